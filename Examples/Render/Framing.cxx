// SPDX-License-Identifier: BSD-3-Clause

#include "Framing.h"

#include "Failure.h"

#include "vtkCamera.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace render
{

namespace
{

constexpr double Margin = 1.05;

// From the data towards the camera.
Vector3 directionOf(const std::string& view)
{
  if (view == "iso")
  {
    return { { 1.0, -1.0, 1.0 } };
  }
  Vector3 direction{ { 0.0, 0.0, 0.0 } };
  direction[view[1] - 'x'] = view[0] == '+' ? 1.0 : -1.0;
  return direction;
}

// Orthogonal, of length 1: to the right, up, and towards the camera.
struct Axes
{
  Vector3 Right, Up, Back;
};

Axes makeAxes(Vector3 back, Vector3 up)
{
  Axes axes;
  axes.Back = back;
  const bool standing = vtkMath::Normalize(axes.Back.data()) > 0.0;
  vtkMath::Cross(up.data(), axes.Back.data(), axes.Right.data());
  if (!standing)
  {
    throw Failure(ExitCode::BadArguments,
      "The camera stands on the point it looks at: give a --position and a --focal that differ.");
  }
  if (vtkMath::Normalize(axes.Right.data()) < 1e-9 * vtkMath::Norm(up.data()) ||
    vtkMath::Norm(up.data()) == 0.0)
  {
    throw Failure(ExitCode::BadArguments,
      "--up points along the direction of view: give one that points to a side of it.");
  }
  vtkMath::Cross(axes.Back.data(), axes.Right.data(), axes.Up.data());
  return axes;
}

// What it takes to have all corners of the bounds in view around the focal point.
struct Fit
{
  double Distance = 0.0;      // from the focal point to the camera
  double ParallelScale = 0.0; // half the height of the picture
};

Fit fitBounds(
  const double bounds[6], const Vector3& focal, const Axes& axes, double viewAngle, double aspect)
{
  const double slope = std::tan(0.5 * vtkMath::RadiansFromDegrees(viewAngle));
  Fit fit;
  for (int corner = 0; corner < 8; ++corner)
  {
    double d[3];
    for (int a = 0; a < 3; ++a)
    {
      d[a] = bounds[2 * a + (corner >> a & 1)] - focal[a];
    }
    const double half = Margin *
      std::max(std::abs(vtkMath::Dot(d, axes.Up.data())),
        std::abs(vtkMath::Dot(d, axes.Right.data())) / aspect);
    fit.Distance = std::max(fit.Distance, vtkMath::Dot(d, axes.Back.data()) + half / slope);
    fit.ParallelScale = std::max(fit.ParallelScale, half);
  }
  return fit;
}

}

void placeCamera(const Options& options, const double bounds[6], vtkCamera* camera)
{
  Vector3 focal;
  for (int a = 0; a < 3; ++a)
  {
    focal[a] = 0.5 * (bounds[2 * a] + bounds[2 * a + 1]);
  }
  focal = options.Focal.value_or(focal);

  Vector3 back = directionOf(options.View);
  if (options.Position)
  {
    vtkMath::Subtract(options.Position->data(), focal.data(), back.data());
  }
  const bool alongZ = std::hypot(back[0], back[1]) < 1e-6 * std::abs(back[2]);
  const Vector3 z{ { 0.0, 0.0, 1.0 } }, y{ { 0.0, 1.0, 0.0 } };
  const Axes axes = makeAxes(back, options.Up.value_or(alongZ ? y : z));

  const double aspect = static_cast<double>(options.Size[0]) / options.Size[1];
  const Fit fit = fitBounds(bounds, focal, axes, options.ViewAngle, aspect);
  Vector3 position;
  for (int a = 0; a < 3; ++a)
  {
    position[a] = focal[a] + fit.Distance * axes.Back[a];
  }
  position = options.Position.value_or(position);

  camera->SetPosition(position.data());
  camera->SetFocalPoint(focal.data());
  camera->SetViewUp(axes.Up.data());
  camera->SetViewAngle(options.ViewAngle);
  camera->SetParallelProjection(options.Parallel);
  camera->SetParallelScale(fit.ParallelScale);
  camera->Zoom(options.Zoom);
}

}
