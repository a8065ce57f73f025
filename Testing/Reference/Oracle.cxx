// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/Oracle.h"

#include "Reference/RayIntegral.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace exabricks
{
namespace reference
{
namespace
{
// The part of the ray begin + t * direction, 0 <= t <= 1, that lies in a box.
Span clip(const glm::dvec3& begin, const glm::dvec3& direction, const glm::dvec3& boxLo,
  const glm::dvec3& boxHi)
{
  Span span;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double lo = boxLo[axis] - begin[axis];
    const double hi = boxHi[axis] - begin[axis];
    if (direction[axis] == 0.0)
    {
      if (lo > 0.0 || hi <= 0.0)
      {
        return { 1.0, 0.0 };
      }
      continue;
    }
    const double a = lo / direction[axis];
    const double b = hi / direction[axis];
    span.begin = std::max(span.begin, std::min(a, b));
    span.end = std::min(span.end, std::max(a, b));
  }
  return span;
}
}

// The way of one pixel: begin + t * direction, 0 <= t <= 1, logical.
class Oracle::Ray
{
public:
  Ray(const Oracle& oracle, const glm::dvec3& begin, const glm::dvec3& direction)
    : Source(oracle.Values)
    , Begin(begin)
    , Direction(direction)
    , Around(oracle.Values.levels())
  {
    for (const Group& group : oracle.Groups)
    {
      const Span around = this->Clip(group.box, 0.0);
      for (std::size_t i = group.begin; i < group.end && around.begin < around.end; ++i)
      {
        const Span span = this->Clip(this->Source.leaves()[i].box, 0.0);
        if (span.begin < span.end)
        {
          this->Hits.emplace_back(span, &this->Source.leaves()[i]);
        }
      }
    }
    std::sort(this->Hits.begin(), this->Hits.end(),
      [](const auto& a, const auto& b) { return a.first.begin < b.first.begin; });
  }

  /// Leaves all out but these parts, which are in order.
  void keep(const std::vector<Span>& parts)
  {
    std::vector<std::pair<Span, const Field::Leaf*>> kept;
    for (const auto& hit : this->Hits)
    {
      for (const Span& part : parts)
      {
        const Span both{ std::max(hit.first.begin, part.begin), std::min(hit.first.end, part.end) };
        if (both.begin < both.end)
        {
          kept.emplace_back(both, hit.second);
        }
      }
    }
    this->Hits = kept;
  }

  /// Of the part in leaf boxes, as a share of the whole.
  double lengthInside() const
  {
    double sum = 0.0;
    for (const auto& hit : this->Hits)
    {
      sum += hit.first.end - hit.first.begin;
    }
    return sum;
  }

  void integrate(Reconstruction reconstruction, double worldLength, RayIntegral& integral)
  {
    for (const auto& hit : this->Hits)
    {
      const Field::Leaf& leaf = *hit.second;
      const double width = this->Source.width(leaf.level);
      this->Cuts.assign({ hit.first.begin, hit.first.end });
      if (reconstruction == Reconstruction::Nearest || leaf.hasAbsent)
      {
        this->CutAtPlanes(width, 0.0, hit.first); // faces of cells
      }
      if (reconstruction == Reconstruction::Basis)
      {
        this->CutAtKinks(leaf, hit.first);
      }
      std::sort(this->Cuts.begin(), this->Cuts.end());
      for (std::size_t i = 0; i + 1 < this->Cuts.size() && !integral.opaque(); ++i)
      {
        const Span piece{ this->Cuts[i], this->Cuts[i + 1] };
        const Int3 cell =
          glm::clamp(Int3(glm::floor(this->At(0.5 * (piece.begin + piece.end)) / width)),
            leaf.cells.lo, leaf.cells.hi - std::int64_t(1));
        const Int3 at = cell - leaf.cells.lo;
        const Int3 size = leaf.cells.size();
        const double value = leaf.values[at.x + size.x * (at.y + size.y * at.z)];
        const double length = (piece.end - piece.begin) * worldLength;
        if (std::isnan(value) || !(length > 0.0))
        {
          continue;
        }
        if (reconstruction == Reconstruction::Nearest)
        {
          integral.addConstant(value, length);
        }
        else
        {
          this->AddPiece(leaf, piece, length, integral);
        }
      }
    }
  }

private:
  struct Eight
  {
    glm::dvec3 base{ std::numeric_limits<double>::quiet_NaN() };
    Field::Corners corners;
  };

  glm::dvec3 At(double t) const { return this->Begin + t * this->Direction; }

  Span Clip(const Box& box, double grow) const
  {
    return clip(this->Begin, this->Direction, glm::dvec3(box.lo) - grow, glm::dvec3(box.hi) + grow);
  }

  // Cuts at the planes (i + offset) * width of each axis.
  void CutAtPlanes(double width, double offset, const Span& span)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double a = this->At(span.begin)[axis] / width - offset;
      const double b = this->At(span.end)[axis] / width - offset;
      for (double i = std::ceil(std::min(a, b)); i <= std::max(a, b); i += 1.0)
      {
        const double t = ((i + offset) * width - this->Begin[axis]) / this->Direction[axis];
        if (t > span.begin && t < span.end)
        {
          this->Cuts.push_back(t);
        }
      }
    }
  }

  // The basis has kinks where tents begin, culminate and end: at planes through cell centres.
  void CutAtKinks(const Field::Leaf& leaf, const Span& span)
  {
    this->CutAtPlanes(this->Source.width(leaf.level), 0.5, span);
    for (const std::uint32_t i : leaf.otherLevels)
    {
      const Field::Leaf& other = this->Source.leaves()[i];
      const double width = this->Source.width(other.level);
      Span reach = this->Clip(other.box, 0.5 * width);
      reach.begin = std::max(reach.begin, span.begin);
      reach.end = std::min(reach.end, span.end);
      if (reach.begin < reach.end)
      {
        this->Cuts.push_back(reach.begin);
        this->Cuts.push_back(reach.end);
        this->CutAtPlanes(width, 0.5, reach);
      }
    }
  }

  // Without kinks: tents are products of three linear functions, so that their sums are cubic.
  void AddPiece(const Field::Leaf& leaf, const Span& piece, double length, RayIntegral& integral)
  {
    const glm::dvec3 begin = this->At(piece.begin);
    const glm::dvec3 end = this->At(piece.end);
    Cubic sum;
    Cubic weights;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const int level : leaf.levels)
    {
      const double width = this->Source.width(level);
      const glm::dvec3 base = glm::floor(0.5 * (begin + end) / width - 0.5);
      Eight& eight = this->Around[level];
      if (base != eight.base)
      {
        eight = { base, this->Source.corners(level, Int3(base)) };
      }
      const Field::Corners& corners = eight.corners;
      if (corners.count == 0)
      {
        continue;
      }
      const glm::dvec3 from = begin / width - 0.5 - base;
      const glm::dvec3 to = end / width - 0.5 - base;
      sum += trilinearAlong(corners.values, from, to);
      weights += corners.count == 8 ? Cubic{ { 1.0 } } : trilinearAlong(corners.there, from, to);
      for (int i = 0; i < 8; ++i)
      {
        if (corners.there[i] > 0.0)
        {
          least = std::min(least, corners.values[i]);
          most = std::max(most, corners.values[i]);
        }
      }
    }
    integral.add(sum, weights, least, most, length);
  }

  const Field& Source;
  const glm::dvec3 Begin;
  const glm::dvec3 Direction;
  std::vector<std::pair<Span, const Field::Leaf*>> Hits;
  std::vector<double> Cuts;
  std::vector<Eight> Around; // [level], of the last piece
};

Oracle::Oracle(const Hierarchy& hierarchy, const LeafBoxes& leaves, const CellSource& source,
  const std::optional<Range>& range)
  : Values(hierarchy, leaves, source, range)
{
  constexpr std::size_t groupSize = 16;
  for (std::size_t i = 0; i < this->Values.leaves().size(); ++i)
  {
    if (i % groupSize == 0)
    {
      this->Groups.push_back({ {}, i, i });
    }
    this->Groups.back().box = unite(this->Groups.back().box, this->Values.leaves()[i].box);
    ++this->Groups.back().end;
  }
}

Image Oracle::render(
  const View& view, const TransferFunction& transfer, const Settings& settings) const
{
  double error;
  return this->render(view, transfer, settings, error);
}

Image Oracle::render(
  const View& view, const TransferFunction& transfer, const Settings& settings, double& error) const
{
  Image image;
  image.width = view.width;
  image.height = view.height;
  image.pixels.assign(static_cast<std::size_t>(view.width) * view.height, glm::dvec4(0.0));
  double greatest = 0.0;
#pragma omp parallel for schedule(dynamic, 32) reduction(max : greatest)
  for (std::ptrdiff_t pixel = 0; pixel < static_cast<std::ptrdiff_t>(image.pixels.size()); ++pixel)
  {
    const glm::dvec2 at(pixel % view.width, pixel / view.width);
    const glm::dvec2 ndc = 2.0 * (at + 0.5) / glm::dvec2(view.width, view.height) - 1.0;
    const double depth = view.depth.empty() ? 1.0 : view.depth[pixel];
    const auto unproject = [&](const glm::dmat4& matrix, double z)
    {
      const glm::dvec4 p = matrix * glm::dvec4(ndc, z, 1.0);
      return glm::dvec3(p) / p.w;
    };
    const double length = glm::distance(
      unproject(view.ndcToWorld, -1.0), unproject(view.ndcToWorld, 2.0 * depth - 1.0));
    const glm::dvec3 begin = unproject(view.ndcToLogical, -1.0);
    const glm::dvec3 direction = unproject(view.ndcToLogical, 2.0 * depth - 1.0) - begin;
    Ray ray(*this, begin, direction);
    ray.keep(view.cut.partsOf(begin, direction));
    RayIntegral integral(
      transfer, settings.opacityUnitDistance, settings.tolerance / (ray.lengthInside() * length));
    ray.integrate(settings.reconstruction, length, integral);
    image.pixels[pixel] = integral.color();
    greatest = std::max(greatest, integral.error());
  }
  error = greatest;
  return image;
}
}
}
