// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes/StandIn.h"

#include "Scenes/Makers.h"

namespace exabricks
{
namespace
{
// In the order of StandInKind.
const StandInDescription descriptions[StandInKinds] = {
  { "Cloud", 77.0, { 0.28, 0.04, 0.08, 0.60 }, 50000, false },
  { "Impact-5K", 46.0, { 0.25, 0.09, 0.16, 0.50 }, 50000, false },
  { "Impact-20K", 46.0, { 0.20, 0.08, 0.16, 0.56 }, 50000, false },
  { "Impact-46K", 89.0, { 0.23, 0.08, 0.15, 0.54 }, 50000, false },
  { "Wind", 16000.0, { 0.09, 0.21, 0.70 }, 1000000, false },
  { "Gear", 19000.0, { 0.05, 0.12, 0.23, 0.60 }, 1000000, true },
  { "Exajet-rear", 206.0, { 0.17, 0.10, 0.19, 0.54 }, 50000, true },
  { "Exajet-wing", 206.0, { 0.17, 0.10, 0.19, 0.54 }, 50000, true },
};
}

FieldSource::FieldSource(const Hierarchy& hierarchy, SceneField field)
  : Origin(hierarchy.origin)
  , Field(std::move(field))
{
  for (const Block& block : hierarchy.blocks)
  {
    this->Levels.push_back(block.level);
  }
  for (const std::int64_t width : hierarchy.cellWidth)
  {
    this->Sizes.push_back(hierarchy.spacing * static_cast<double>(width));
  }
}

void FieldSource::read(int block, const Box& cells, double* values) const
{
  const glm::dvec3& size = this->Sizes[this->Levels[block]];
  Int3 p;
  for (p.z = cells.lo.z; p.z < cells.hi.z; ++p.z)
  {
    for (p.y = cells.lo.y; p.y < cells.hi.y; ++p.y)
    {
      for (p.x = cells.lo.x; p.x < cells.hi.x; ++p.x)
      {
        const glm::dvec3 center = this->Origin + (glm::dvec3(p) + 0.5) * size;
        *values++ = std::clamp(this->Field(center, size.x), 0.0, 1.0);
      }
    }
  }
}

StandIn standInOf(StandInKind kind, Hierarchy hierarchy, SceneField field)
{
  StandIn made;
  made.kind = kind;
  made.cells = std::make_shared<const FieldSource>(hierarchy, std::move(field));
  made.hierarchy = std::move(hierarchy);
  made.range = { 0.0, 1.0 };
  return made;
}

const StandInDescription& describe(StandInKind kind)
{
  return descriptions[static_cast<int>(kind)];
}

TransferFunction StandIn::transferFor(const Range& other) const
{
  std::vector<TransferFunction::Point> points = this->transfer.points();
  for (TransferFunction::Point& point : points)
  {
    point.value =
      other.normalize(this->range.min + point.value * (this->range.max - this->range.min));
  }
  return TransferFunction(std::move(points));
}

StandIn makeStandIn(StandInKind kind, std::uint64_t leafCells)
{
  const std::uint64_t cells = std::max(leafCells, describe(kind).leastLeafCells);
  switch (kind)
  {
    case StandInKind::Cloud:
      return makeCloud(cells);
    case StandInKind::Wind:
      return makeWind(cells);
    case StandInKind::Gear:
      return makeGear(cells);
    case StandInKind::ExajetRear:
    case StandInKind::ExajetWing:
      return makeJet(kind, cells);
    default:
      return makeImpact(kind, cells);
  }
}
}
