// SPDX-License-Identifier: BSD-3-Clause
#include "Core/TransferFunction2D.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace exabricks
{
namespace
{
// The two pixels that a variable is between, and how far it is from the first one.
struct Place
{
  int first;
  int second;
  double fraction;

  Place(double variable, int pixels)
  {
    const double at = std::clamp(variable * pixels - 0.5, 0.0, static_cast<double>(pixels - 1));
    this->first = static_cast<int>(at);
    this->second = std::min(this->first + 1, pixels - 1);
    this->fraction = at - this->first;
  }
};
}

glm::dvec4 TransferFunction2D::evaluate(double first, double second) const
{
  const Place x(first, this->width);
  const Place y(second, this->height);
  const auto row = [&](int number)
  {
    const glm::vec4* const begin =
      this->pixels.data() + static_cast<std::size_t>(number) * this->width;
    return glm::mix(glm::dvec4(begin[x.first]), glm::dvec4(begin[x.second]), x.fraction);
  };
  return glm::mix(row(y.first), row(y.second), y.fraction);
}

TransferFunction TransferFunction2D::envelope() const
{
  std::vector<TransferFunction::Point> points;
  for (int x = 0; x < this->width; ++x)
  {
    float most = 0.0f;
    for (int y = 0; y < this->height; ++y)
    {
      most = std::max(most, this->pixels[x + static_cast<std::size_t>(y) * this->width].a);
    }
    points.push_back({ (x + 0.5) / this->width, glm::dvec4(1.0, 1.0, 1.0, most) });
  }
  return TransferFunction(std::move(points));
}
}
