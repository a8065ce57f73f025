// SPDX-License-Identifier: BSD-3-Clause

#include "Framing.h"

#include "Failure.h"

#include "vtkCamera.h"
#include "vtkExaBricksFirstPicture.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace render
{

namespace
{

constexpr double RoomForLabels = 0.15; // on each side, of the bounds

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

  double away[3];
  const double distance = std::max(vtkMath::Norm(focal.data()), 1.0);
  for (int a = 0; a < 3; ++a)
  {
    away[a] = focal[a] + distance * axes.Back[a];
  }
  camera->SetFocalPoint(focal.data());
  camera->SetPosition(away);
  camera->SetViewUp(axes.Up.data());
  camera->SetViewAngle(options.ViewAngle);
  // Labels of axes stand around the bounds.
  const double room = options.Annotate ? RoomForLabels : 0.0;
  double fitted[6];
  for (int a = 0; a < 3; ++a)
  {
    const double more = room * (bounds[2 * a + 1] - bounds[2 * a]);
    fitted[2 * a] = bounds[2 * a] - more;
    fitted[2 * a + 1] = bounds[2 * a + 1] + more;
  }
  vtkExaBricksFirstPicture::FitCamera(
    camera, fitted, static_cast<double>(options.Size[0]) / options.Size[1]);
  if (options.Position)
  {
    camera->SetPosition(options.Position->data());
  }
  camera->SetParallelProjection(options.Parallel);
  if (options.ParallelScale > 0.0)
  {
    camera->SetParallelScale(options.ParallelScale);
  }
  camera->Zoom(options.Zoom);
}

}
