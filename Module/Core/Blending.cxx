// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Blending.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace exabricks
{
namespace
{
using Point = TransferFunction::Point;

// The points in [0, 1], one at each end, and one at both sides of each of `cuts`.
std::vector<Point> cutUnitInterval(
  const TransferFunction& transfer, const std::vector<double>& cuts)
{
  std::vector<Point> points{ { 0.0, transfer.evaluate(0.0) } };
  for (const Point& point : transfer.points())
  {
    if (point.value > 0.0 && point.value < 1.0)
    {
      points.push_back(point);
    }
  }
  points.push_back({ 1.0, transfer.evaluate(1.0) });
  for (const double cut : cuts)
  {
    const auto behind = std::upper_bound(points.begin(), points.end(), cut,
      [](double value, const Point& point) { return value < point.value; });
    points.insert(behind, 2, { cut, transfer.evaluate(cut) });
  }
  return points;
}

// The next float, as a value at a jump takes what comes after it.
double justAbove(double value)
{
  return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity());
}

// The points in [0, 1], with an opacity of 0 outside of the range, whose ends are in it.
std::vector<Point> cutToRange(const TransferFunction& transfer, const glm::dvec2& range)
{
  const bool cutsBelow = range.x > 0.0;
  const double end = justAbove(range.y);
  const bool cutsAbove = end <= 1.0;
  std::vector<double> cuts;
  if (cutsBelow && range.x <= 1.0)
  {
    cuts.push_back(range.x);
  }
  if (cutsAbove && end > 0.0)
  {
    cuts.push_back(end);
  }
  std::vector<Point> points = cutUnitInterval(transfer, cuts);
  bool atLower = false; // of the points at a cut the outermost one is outside
  bool atUpper = false;
  for (Point& point : points)
  {
    const bool below = point.value < range.x || (point.value == range.x && !atLower);
    const bool above = point.value > end || (point.value == end && atUpper);
    atLower = atLower || point.value == range.x;
    atUpper = atUpper || point.value == end;
    if ((cutsBelow && below) || (cutsAbove && above))
    {
      point.color.a = 0.0;
    }
  }
  return points;
}
}

TransferFunction findLookup(
  const TransferFunction& transfer, Blending blending, const glm::dvec2& averageRange)
{
  if (blending != Blending::Average && blending != Blending::Additive)
  {
    return transfer;
  }
  std::vector<Point> points = blending == Blending::Average ? cutToRange(transfer, averageRange)
                                                            : cutUnitInterval(transfer, {});
  for (Point& point : points)
  {
    point.color = glm::dvec4(point.value, point.value, point.value, point.color.a);
  }
  return TransferFunction(points);
}

TransferFunction findVisibility(const TransferFunction& transfer, Blending blending,
  const glm::dvec2& averageRange, const std::vector<double>& isoValues)
{
  const glm::dvec4 shown(1.0);
  const glm::dvec4 hidden(0.0);
  switch (blending)
  {
    case Blending::Composite:
    case Blending::Slice:
      return transfer;
    case Blending::Average:
      if (!(averageRange.x <= averageRange.y))
      {
        return TransferFunction();
      }
      return TransferFunction({ { averageRange.x, hidden }, { averageRange.x, shown },
        { justAbove(averageRange.y), shown }, { justAbove(averageRange.y), hidden } });
    case Blending::Isosurface:
    {
      std::vector<Point> points;
      for (const double value : isoValues)
      {
        // Where the field only reaches the value, rounding may pass it.
        for (const Point& point : { Point{ value - 1e-6, hidden }, Point{ value - 1e-6, shown },
               Point{ value + 1e-6, shown }, Point{ value + 1e-6, hidden } })
        {
          points.push_back(point);
        }
      }
      std::stable_sort(points.begin(), points.end(),
        [](const Point& a, const Point& b) { return a.value < b.value; });
      return TransferFunction(points);
    }
    default:
      return TransferFunction({ { 0.0, shown } });
  }
}
}
