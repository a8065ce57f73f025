// SPDX-License-Identifier: BSD-3-Clause
#include "Core/TransferFunction.h"

#include <algorithm>

#include <cmath>
#include <glm/common.hpp>

namespace exabricks
{
TransferFunction::TransferFunction(std::vector<Point> points)
  : Points(std::move(points))
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (this->Points.empty())
  {
    this->Points.push_back({ 0.0, glm::dvec4(0.0) });
  }
  for (std::size_t i = 0; i < this->Points.size();)
  {
    if (this->Points[i].color.a > 0.0)
    {
      ++i;
      continue;
    }
    const std::size_t first = i;
    while (i < this->Points.size() && !(this->Points[i].color.a > 0.0))
    {
      ++i;
    }
    double last = infinity;
    if (i < this->Points.size())
    {
      last = this->Points[i - 1].value;
      if (last == this->Points[i].value) // a jump: its own value takes what comes after it
      {
        last = std::nextafter(static_cast<float>(last), -std::numeric_limits<float>::infinity());
      }
    }
    this->Transparent.emplace_back(first == 0 ? -infinity : this->Points[first].value, last);
  }
}

glm::dvec4 TransferFunction::evaluate(double value) const
{
  const auto upper = std::upper_bound(this->Points.begin(), this->Points.end(), value,
    [](double v, const Point& point) { return v < point.value; });
  if (upper == this->Points.begin())
  {
    return this->Points.front().color;
  }
  const Point& a = *(upper - 1);
  if (upper == this->Points.end() || a.value == value)
  {
    return a.color;
  }
  return glm::mix(a.color, upper->color, (value - a.value) / (upper->value - a.value));
}

bool TransferFunction::showsTheSame(const TransferFunction& other) const
{
  return this->Transparent == other.Transparent;
}

bool TransferFunction::isAsOpaqueAs(const TransferFunction& other) const
{
  return std::equal(this->Points.begin(), this->Points.end(), other.Points.begin(),
    other.Points.end(),
    [](const Point& a, const Point& b) { return a.value == b.value && a.color.a == b.color.a; });
}
}
