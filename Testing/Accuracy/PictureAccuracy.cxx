// SPDX-License-Identifier: BSD-3-Clause
#include "Accuracy/PictureAccuracy.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace exabricks
{
namespace accuracy
{
reference::Image renderField(const std::function<double(const glm::dvec3&)>& sample,
  const TransferFunction& transfer, const PictureSettings& settings)
{
  Hierarchy cube; // its logical and world coordinates are those of the unit cube
  const reference::View view = reference::lookAt(
    cube, { Int3(0), Int3(1) }, { 1.0, 0.7, -0.4 }, 0.0, settings.pixels, settings.pixels);
  reference::Image image;
  image.width = view.width;
  image.height = view.height;
  image.pixels.assign(static_cast<std::size_t>(view.width) * view.height, glm::dvec4(0.0));
#pragma omp parallel for schedule(dynamic, 1)
  for (int y = 0; y < view.height; ++y)
  {
    for (int x = 0; x < view.width; ++x)
    {
      const glm::dvec2 ndc(2.0 * (x + 0.5) / view.width - 1.0, 2.0 * (y + 0.5) / view.height - 1.0);
      const glm::dvec3 begin(view.ndcToWorld * glm::dvec4(ndc, -1.0, 1.0));
      const glm::dvec3 end(view.ndcToWorld * glm::dvec4(ndc, 1.0, 1.0));
      const int steps = static_cast<int>(std::ceil(glm::distance(begin, end) / settings.step));
      const double power = glm::distance(begin, end) / steps / settings.unitDistance;
      glm::dvec4 color(0.0);
      for (int i = 0; i < steps; ++i)
      {
        const glm::dvec3 p = glm::mix(begin, end, (i + 0.5) / steps);
        if (glm::all(glm::greaterThan(p, glm::dvec3(0.0))) &&
          glm::all(glm::lessThan(p, glm::dvec3(1.0))))
        {
          const glm::dvec4 c = transfer.evaluate(sample(p));
          const double alpha = 1.0 - std::pow(1.0 - c.a, power);
          color += (1.0 - color.a) * alpha * glm::dvec4(glm::dvec3(c), 1.0);
        }
      }
      image.pixels[x + static_cast<std::size_t>(view.width) * y] = color;
    }
  }
  return image;
}

TransferFunction rampTransfer()
{
  return TransferFunction({ { 0.1, glm::dvec4(0.1, 0.2, 0.9, 0.0) },
    { 0.5, glm::dvec4(0.9, 0.9, 0.5, 0.15) }, { 1.0, glm::dvec4(0.9, 0.1, 0.1, 0.5) } });
}

TransferFunction veilTransfer()
{
  return TransferFunction(
    { { 0.30, glm::dvec4(0.1, 0.4, 0.9, 0.0) }, { 0.35, glm::dvec4(0.1, 0.4, 0.9, 0.6) },
      { 0.40, glm::dvec4(0.1, 0.4, 0.9, 0.0) }, { 0.65, glm::dvec4(0.9, 0.5, 0.1, 0.0) },
      { 0.70, glm::dvec4(0.9, 0.5, 0.1, 0.9) }, { 0.75, glm::dvec4(0.9, 0.5, 0.1, 0.0) } });
}

std::vector<PictureRow> measurePictures(const Field& field, const std::vector<Grid>& grids,
  const TransferFunction& transfer, const PictureSettings& settings)
{
  const reference::Image exact = renderField(field.value, transfer, settings);
  std::vector<PictureRow> rows;
  for (const Grid& grid : grids)
  {
    const Sampler sampler(grid, field);
    for (const Method method : { Method::Nearest, Method::Basis, Method::Corrected,
           Method::CompletedBeyond, Method::Completed })
    {
      const auto sample = [&](const glm::dvec3& p)
      { return *sampler.sample(p / grid.cellShare, method); };
      rows.push_back(
        { method, grid.cellShare, psnr(exact, renderField(sample, transfer, settings)) });
    }
  }
  return rows;
}
}
}
