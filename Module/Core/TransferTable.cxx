// SPDX-License-Identifier: BSD-3-Clause
#include "Core/TransferTable.h"

#include <cmath>
#include <glm/common.hpp>

namespace exabricks
{
namespace
{
using Point = TransferFunction::Point;

// Points with values in [0, 1] alone, the first at 0 and the last at 1; a jump at 1 is kept.
std::vector<Point> clipToUnitInterval(const TransferFunction& transfer)
{
  std::vector<Point> points{ { 0.0, transfer.evaluate(0.0) } };
  const std::vector<Point>& all = transfer.points();
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const bool isJumpAtOne =
      all[i].value == 1.0 && i + 1 < all.size() && all[i + 1].value == 1.0 && i > 0;
    if ((all[i].value > 0.0 && all[i].value < 1.0) || isJumpAtOne)
    {
      points.push_back(all[i]);
    }
  }
  points.push_back({ 1.0, transfer.evaluate(1.0) });
  return points;
}

// That of the greatest opacity below 1; and without the loss of digits of 1 - opacity where that is
// small.
double extinctionOf(double opacity)
{
  return std::min(-std::log1p(-opacity), static_cast<double>(layout::DENSEST));
}

glm::dvec4 extinctionOf(const glm::dvec4& color)
{
  return extinctionOf(color.a) * glm::dvec4(color.r, color.g, color.b, 1.0);
}

// A part on which colour and opacity are linear.
struct Part
{
  Point begin;
  Point end;

  double width() const { return this->end.value - this->begin.value; }
  Point at(double value) const
  {
    const double share = this->width() > 0.0 ? (value - this->begin.value) / this->width() : 0.0;
    return { value, glm::mix(this->begin.color, this->end.color, glm::clamp(share, 0.0, 1.0)) };
  }
  bool opaque() const { return this->begin.color.a >= 1.0 && this->end.color.a >= 1.0; }

  // The device takes extinction for linear: the part is narrow enough for that.
  bool isLinear() const
  {
    const glm::dvec4 mean = this->mean();
    const glm::dvec4 off =
      glm::abs(0.5 * (extinctionOf(this->begin.color) + extinctionOf(this->end.color)) - mean);
    return std::max({ off.r, off.g, off.b, off.a }) <= 1e-4 * mean.a;
  }

  // Mean of the extinction, and of the same times each colour.
  glm::dvec4 mean() const
  {
    const double a0 = this->begin.color.a;
    const double a1 = this->end.color.a;
    double mean = 0.0;
    double upward = 0.0; // of the extinction times the share of the way to the end
    if (std::abs(a1 - a0) > 1e-3)
    {
      const double u0 = std::exp(-extinctionOf(a0)); // what passes
      const double u1 = std::exp(-extinctionOf(a1));
      const auto first = [](double u) { return u - u * std::log(u); }; // integrals of -ln u, ...
      const auto second = [](double u) { return u * u * (0.25 - 0.5 * std::log(u)); }; // -u ln u
      mean = (first(u1) - first(u0)) / (u1 - u0);
      upward = ((second(u1) - second(u0)) / (u1 - u0) - u0 * mean) / (u1 - u0);
    }
    else
    {
      for (const double offset : { -1.0, 0.0, 1.0 }) // Gauss's rule of three points
      {
        const double share = 0.5 + offset * std::sqrt(0.15);
        const double weight = offset == 0.0 ? 4.0 / 9.0 : 5.0 / 18.0;
        const double extinction = extinctionOf(glm::mix(a0, a1, share));
        mean += weight * extinction;
        upward += weight * extinction * share;
      }
    }
    const glm::dvec4 colors =
      mean * this->begin.color + upward * (this->end.color - this->begin.color);
    return glm::dvec4(colors.r, colors.g, colors.b, mean);
  }
};
// All parts between the points, with what lies before each.
struct Pieces
{
  explicit Pieces(const std::vector<Point>& points)
  {
    glm::dvec4 integral(0.0);
    int opaqueBefore = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      const Part part{ points[i], points[i + 1] };
      const int isOpaque = part.opaque() && part.width() > 0.0 ? 1 : 0;
      this->all.push_back({ part, integral, 2 * opaqueBefore + isOpaque });
      integral += part.width() * part.mean();
      opaqueBefore += isOpaque;
    }
    // From 1 on.
    this->all.push_back({ { points.back(), points.back() }, integral, 2 * opaqueBefore });
    // The greatest float below 2^31
    this->unit = integral.a > 0.0 ? integral.a / 2147483520.0 : 1.0;
  }

  struct Piece
  {
    Part part;
    glm::dvec4 integral;
    int opaque;
  };

  float begin(std::size_t i) const // compared as floats, as the device does
  {
    return static_cast<float>(this->all[i].part.begin.value);
  }

  // Part of piece i as the device has it.
  layout::TransferKnot record(std::size_t i, const Part& part) const
  {
    const Piece& piece = this->all[i];
    const Part before{ piece.part.begin, part.begin };
    layout::TransferKnot knot{};
    knot.lower = glm::vec4(extinctionOf(part.begin.color));
    knot.upper = glm::vec4(extinctionOf(part.end.color));
    if (part.opaque())
    {
      knot.lower = layout::OPAQUE * glm::vec4(glm::vec3(part.begin.color), 1.0f);
      knot.upper = layout::OPAQUE * glm::vec4(glm::vec3(part.end.color), 1.0f);
    }
    knot.integral =
      glm::ivec4(glm::round((piece.integral + before.width() * before.mean()) / this->unit));
    knot.opaque = piece.opaque;
    knot.value = static_cast<float>(part.begin.value);
    return knot;
  }

  // Part of piece i, halved until the device's lines fit.
  void addKnots(
    std::size_t i, const Part& part, int depth, std::vector<layout::TransferKnot>& knots) const
  {
    constexpr int deepest = 10;
    const Point middle = part.at(0.5 * (part.begin.value + part.end.value));
    const float value = static_cast<float>(middle.value);
    if (part.isLinear() || depth == deepest || !(static_cast<float>(part.begin.value) < value) ||
      !(value < static_cast<float>(part.end.value)))
    {
      knots.push_back(this->record(i, part));
      return;
    }
    this->addKnots(i, { part.begin, middle }, depth + 1, knots);
    this->addKnots(i, { middle, part.end }, depth + 1, knots);
  }

  std::vector<Piece> all;
  double unit;
};
}

TransferTable::TransferTable(const TransferFunction& transfer)
{
  const Pieces pieces(clipToUnitInterval(transfer));
  this->integralUnit = static_cast<float>(pieces.unit);
  const std::size_t last = pieces.all.size() - 1; // from 1 on
  std::vector<layout::TransferKnot> inside;
  std::size_t piece = 0; // the last one that does not begin above the bin's lower end
  for (int i = 0; i < layout::TRANSFER_BINS; ++i)
  {
    const float lo = static_cast<float>(i) / layout::TRANSFER_BINS;
    const float hi = static_cast<float>(i + 1) / layout::TRANSFER_BINS;
    while (piece + 1 < last && pieces.begin(piece + 1) <= lo)
    {
      ++piece;
    }
    const bool isLastBin = i + 1 == layout::TRANSFER_BINS;
    inside.clear();
    Point begin = pieces.all[piece].part.at(lo);
    for (std::size_t k = piece; k < last && (k == piece || pieces.begin(k) < hi); ++k)
    {
      const bool endsInside = pieces.begin(k + 1) < hi || (isLastBin && k + 1 < last);
      const Point end = endsInside ? pieces.all[k].part.end : pieces.all[k].part.at(hi);
      if (static_cast<float>(begin.value) < static_cast<float>(end.value))
      {
        pieces.addKnots(k, { begin, end }, 0, inside);
      }
      begin = pieces.all[std::min(k + 1, last)].part.begin;
    }
    layout::TransferBin bin{ inside[0].lower, inside[0].upper, inside[0].integral,
      inside[0].opaque };
    const Part& end = pieces.all[last].part;
    const bool jumpsAtOne =
      isLastBin && glm::vec4(extinctionOf(end.begin.color)) != inside.back().upper;
    if (inside.size() > 1 || jumpsAtOne)
    {
      bin.lower.a = -1.0f - static_cast<float>(this->knots.size());
      this->knots.insert(this->knots.end(), inside.begin(), inside.end());
      bin.upper.a = static_cast<float>(inside.size() + (isLastBin ? 1 : 0));
      // Its upper end; that of the last bin holds 1 itself, and needs one more after it.
      this->knots.push_back(pieces.record(last, end));
      this->knots.back().value = hi;
      if (isLastBin)
      {
        this->knots.push_back(this->knots.back());
        this->knots.back().value = 3.0f;
      }
    }
    this->bins.push_back(bin);
  }
}
}
