// SPDX-License-Identifier: BSD-3-Clause
#include "Core/TransferTable.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace exabricks
{
namespace
{
using Point = TransferFunction::Point;

// The function's points in [0, 1], with one at 0 and one at 1; a jump at 1 is kept.
std::vector<Point> clipToUnitInterval(const TransferFunction& transfer)
{
  std::vector<Point> points{ { 0.0, transfer.evaluate(0.0) } };
  const std::vector<Point>& all = transfer.points();
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const bool isJumpAtOne = all[i].value == 1.0 && i + 1 < all.size() && all[i + 1].value == 1.0;
    if ((all[i].value > 0.0 && all[i].value < 1.0) || isJumpAtOne)
    {
      points.push_back(all[i]);
    }
  }
  points.push_back({ 1.0, transfer.evaluate(1.0) });
  return points;
}

using Amount = TransferTable::Amount;

// By log1p, as 1 - opacity has few digits of a small opacity. At most the extinction of the
// greatest opacity below 1.
double extinctionOf(double opacity)
{
  return std::min(-std::log1p(-opacity), static_cast<double>(layout::DENSEST));
}

double amountOf(double opacity, Amount amount)
{
  return amount == Amount::Extinction ? extinctionOf(opacity) : opacity;
}

glm::dvec4 amountOf(const glm::dvec4& color, Amount amount)
{
  return amountOf(color.a, amount) * glm::dvec4(color.r, color.g, color.b, 1.0);
}

// A part on which colour and opacity are linear.
struct Part
{
  Point begin;
  Point end;
  Amount amount;

  double width() const { return this->end.value - this->begin.value; }
  Point at(double value) const
  {
    const double fraction = this->width() > 0.0 ? (value - this->begin.value) / this->width() : 0.0;
    return { value, glm::mix(this->begin.color, this->end.color, glm::clamp(fraction, 0.0, 1.0)) };
  }
  // Which matters where extinction has no number for it.
  bool opaque() const
  {
    return this->amount == Amount::Extinction && this->begin.color.a >= 1.0 &&
      this->end.color.a >= 1.0;
  }
  glm::dvec4 amountAtBegin() const { return amountOf(this->begin.color, this->amount); }
  glm::dvec4 amountAtEnd() const { return amountOf(this->end.color, this->amount); }

  // Whether the part is so narrow that amounts are linear on it, for which the device takes them.
  bool isLinear() const
  {
    const glm::dvec4 mean = this->mean();
    const glm::dvec4 off = glm::abs(0.5 * (this->amountAtBegin() + this->amountAtEnd()) - mean);
    return std::max({ off.r, off.g, off.b, off.a }) <= 1e-4 * mean.a;
  }

  // The mean of the amount, in the last component, and of the amount times each colour.
  glm::dvec4 mean() const
  {
    const double a0 = this->begin.color.a;
    const double a1 = this->end.color.a;
    double mean = 0.0;
    double upward = 0.0; // mean of the amount times the fraction of the way to the end
    if (this->amount == Amount::Extinction && std::abs(a1 - a0) > 1e-3)
    {
      const double u0 = std::exp(-extinctionOf(a0)); // transmittance
      const double u1 = std::exp(-extinctionOf(a1));
      // Integrals of -ln u and of -u ln u.
      const auto first = [](double u) { return u - u * std::log(u); };
      const auto second = [](double u) { return u * u * (0.25 - 0.5 * std::log(u)); };
      mean = (first(u1) - first(u0)) / (u1 - u0);
      upward = ((second(u1) - second(u0)) / (u1 - u0) - u0 * mean) / (u1 - u0);
    }
    else
    {
      for (const double offset : { -1.0, 0.0, 1.0 }) // Gauss's rule of three points
      {
        const double fraction = 0.5 + offset * std::sqrt(0.15);
        const double weight = offset == 0.0 ? 4.0 / 9.0 : 5.0 / 18.0;
        const double amountThere = amountOf(glm::mix(a0, a1, fraction), this->amount);
        mean += weight * amountThere;
        upward += weight * amountThere * fraction;
      }
    }
    const glm::dvec4 colors =
      mean * this->begin.color + upward * (this->end.color - this->begin.color);
    return glm::dvec4(colors.r, colors.g, colors.b, mean);
  }
};

// A straight line as the device has it; the integral of the lines before it is added later.
struct Line
{
  layout::TransferKnot knot;
  double width; // in values

  glm::dvec4 integral() const
  {
    return 0.5 * this->width * (glm::dvec4(this->knot.lower) + glm::dvec4(this->knot.upper));
  }
};

// The pieces between the points, and the one from 1 on.
class Pieces
{
public:
  Pieces(const std::vector<Point>& points, Amount amount)
  {
    int opaqueBefore = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      const Part part{ points[i], points[i + 1], amount };
      const int isOpaque = part.opaque() && part.width() > 0.0 ? 1 : 0;
      this->All.push_back({ part, 2 * opaqueBefore + isOpaque });
      opaqueBefore += isOpaque;
    }
    this->All.push_back({ { points.back(), points.back(), amount }, 2 * opaqueBefore });
    // The more pieces, the less each is halved, so that there are some 10^5 lines at most.
    this->Deepest = std::clamp(
      static_cast<int>(std::log2(65536.0 / static_cast<double>(points.size()))), 0, FullDepth);
  }

  std::size_t last() const { return this->All.size() - 1; } // from 1 on
  const Part& part(std::size_t i) const { return this->All[i].part; }
  float begin(std::size_t i) const // compared as floats, as the device does
  {
    return static_cast<float>(this->All[i].part.begin.value);
  }

  Line line(std::size_t i, const Part& part) const
  {
    return { { glm::vec4(part.amountAtBegin()), glm::vec4(part.amountAtEnd()), glm::ivec4(0),
               this->All[i].opaque, static_cast<float>(part.begin.value) },
      part.width() };
  }

  // Adds lines for a part of piece i, which is halved until lines fit.
  void addLines(std::size_t i, const Part& part, int depth, std::vector<Line>& lines) const
  {
    const Point middle = part.at(0.5 * (part.begin.value + part.end.value));
    const float value = static_cast<float>(middle.value);
    const bool splits = static_cast<float>(part.begin.value) < value &&
      value < static_cast<float>(part.end.value); // as floats
    if (part.isLinear() || !splits || depth == this->Deepest)
    {
      lines.push_back(this->line(i, part));
      if (!part.isLinear() && splits && this->Deepest < FullDepth && part.begin.color.a < 1.0 &&
        part.end.color.a < 1.0)
      {
        // As it is not halved any more, the line has the part's mean, and not its ends.
        layout::TransferKnot& knot = lines.back().knot;
        const glm::vec4 factor(
          part.mean() / glm::max(0.5 * glm::dvec4(knot.lower + knot.upper), 1e-300));
        knot.lower *= factor;
        knot.upper *= factor;
      }
      return;
    }
    this->addLines(i, { part.begin, middle, part.amount }, depth + 1, lines);
    this->addLines(i, { middle, part.end, part.amount }, depth + 1, lines);
  }

  // The lines from `lo` to `hi`. `first` is the last piece that does not begin above `lo`. A jump
  // at 1 is in no bin.
  std::vector<Line> linesBetween(float lo, float hi, std::size_t first) const
  {
    std::vector<Line> lines;
    Point begin = this->part(first).at(lo);
    for (std::size_t i = first; i < this->last() && (i == first || this->begin(i) < hi); ++i)
    {
      const Point end = this->begin(i + 1) < hi ? this->part(i).end : this->part(i).at(hi);
      if (static_cast<float>(begin.value) < static_cast<float>(end.value))
      {
        this->addLines(i, { begin, end, this->part(i).amount }, 0, lines);
      }
      begin = this->part(i + 1).begin;
    }
    return lines;
  }

private:
  struct Piece
  {
    Part part;
    int opaque;
  };

  static constexpr int FullDepth = 10;

  std::vector<Piece> All;
  int Deepest;
};
}

TransferTable::TransferTable(const TransferFunction& transfer, Amount amount)
{
  const Pieces pieces(clipToUnitInterval(transfer), amount);
  // Integrals of the lines themselves, so that no difference of them is off the lines.
  glm::dvec4 integral(0.0);
  std::vector<glm::dvec4> toBins;
  std::vector<glm::dvec4> toKnots;
  const auto addKnot = [&](const layout::TransferKnot& knot)
  {
    this->knots.push_back(knot);
    toKnots.push_back(integral);
  };
  std::size_t piece = 0; // the last one that does not begin above the bin's lower end
  for (int i = 0; i < layout::TRANSFER_BINS; ++i)
  {
    const float lo = static_cast<float>(i) / layout::TRANSFER_BINS;
    const float hi = static_cast<float>(i + 1) / layout::TRANSFER_BINS;
    while (piece + 1 < pieces.last() && pieces.begin(piece + 1) <= lo)
    {
      ++piece;
    }
    const std::vector<Line> lines = pieces.linesBetween(lo, hi, piece);
    const layout::TransferKnot& first = lines.front().knot;
    layout::TransferBin bin{ first.lower, first.upper, glm::ivec4(0), first.opaque, 0 };
    toBins.push_back(integral);
    layout::TransferKnot end = pieces.line(pieces.last(), pieces.part(pieces.last())).knot;
    const bool isLast = i + 1 == layout::TRANSFER_BINS;
    const bool isLine = lines.size() == 1 && !(isLast && end.lower != lines.back().knot.upper);
    if (!isLine)
    {
      bin.lower.a = -1.0f;
      bin.integral = { this->knots.size(), lines.size() + isLast, 0, 0 };
    }
    for (const Line& line : lines)
    {
      if (!isLine)
      {
        addKnot(line.knot);
      }
      integral += line.integral();
    }
    if (!isLine)
    {
      // The bin's upper end. That of the last bin holds 1 itself, and needs one more after it.
      end.value = hi;
      addKnot(end);
      end.value = 3.0f;
      if (isLast)
      {
        addKnot(end);
      }
    }
    this->bins.push_back(bin);
  }

  // A little less than 2^31, as the device rounds.
  const double unit = integral.a > 0.0 ? integral.a / 2147000000.0 : 1.0;
  this->integralUnit = static_cast<float>(unit);
  for (std::size_t i = 0; i < this->bins.size(); ++i)
  {
    if (this->bins[i].lower.a >= 0.0f)
    {
      this->bins[i].integral = glm::ivec4(glm::round(toBins[i] / unit));
    }
  }
  for (std::size_t i = 0; i < this->knots.size(); ++i)
  {
    this->knots[i].integral = glm::ivec4(glm::round(toKnots[i] / unit));
  }
}
}
