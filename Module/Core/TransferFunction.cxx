// SPDX-License-Identifier: BSD-3-Clause
#include "Core/TransferFunction.h"

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

bool TransferFunction::visible(const ValueRange& range) const
{
  if (!(range.min <= range.max))
  {
    return false;
  }
  for (const glm::dvec2& interval : this->Transparent)
  {
    if (range.min >= interval.x && range.max <= interval.y)
    {
      return false;
    }
  }
  return true;
}

bool TransferFunction::showsTheSame(const TransferFunction& other) const
{
  return this->Transparent == other.Transparent;
}

std::vector<layout::TransferKnot> TransferFunction::makeKnots() const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<layout::TransferKnot> knots;
  knots.reserve(this->Points.size() + 2);
  // Guards at both ends, so that a search from any bin ends.
  knots.push_back({ glm::vec4(this->evaluate(-infinity)), -1.0f });
  for (const Point& point : this->Points)
  {
    knots.push_back({ glm::vec4(point.color), static_cast<float>(point.value) });
  }
  knots.push_back({ glm::vec4(this->evaluate(infinity)), 3.0f });
  return knots;
}

std::vector<layout::TransferBin> TransferFunction::makeBins() const
{
  std::vector<layout::TransferBin> bins(layout::TRANSFER_BINS);
  for (int i = 0; i < layout::TRANSFER_BINS; ++i)
  {
    // Compared as floats, as the device does.
    const float lo = static_cast<float>(i) / layout::TRANSFER_BINS;
    const float hi = static_cast<float>(i + 1) / layout::TRANSFER_BINS;
    const auto inside = std::find_if(this->Points.begin(), this->Points.end(),
      [&](const Point& p)
      { return static_cast<float>(p.value) >= lo && static_cast<float>(p.value) <= hi; });
    bins[i].lower = glm::vec4(this->evaluate(lo));
    bins[i].upper = glm::vec4(this->evaluate(hi));
    if (inside != this->Points.end())
    {
      // the guard comes before point 0: knot number (index of the point) is the one to its left
      bins[i].lower.a = -1.0f - static_cast<float>(inside - this->Points.begin());
    }
  }
  return bins;
}
}
