// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/AMRInput.h"

#include "Adapters/AMRCompatibility.h"
#include "Adapters/AMRPart.h"
#include "Adapters/Ghosts.h"

#include "vtkAMRBox.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkMatrix3x3.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace exabricks
{
namespace
{
std::string blockName(unsigned int level, unsigned int index)
{
  return "block " + std::to_string(index) + " of level " + std::to_string(level);
}

std::string triple(const double v[3])
{
  std::ostringstream text;
  text << "(" << v[0] << ", " << v[1] << ", " << v[2] << ")";
  return text.str();
}

// The ratio of the spacings of two levels if it is whole, else 0; it may be larger than any
// integer. Readers are known to report wrong ratios, but spacings they have to get right.
double findRatio(const glm::dvec3& coarse, const glm::dvec3& fine)
{
  const glm::dvec3 ratio = coarse / fine;
  const double whole = std::round(ratio.x);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(std::abs(ratio[axis] - whole) <= 1e-3 * whole))
    {
      return 0.0;
    }
  }
  return whole;
}

}

std::string makeLattice(const std::vector<glm::dvec3>& spacings, const std::vector<int>& amrLevel,
  const glm::dvec3& origin, Hierarchy& hierarchy)
{
  const std::size_t levels = spacings.size();
  hierarchy.cellWidth.assign(levels, 1);
  for (std::size_t level = levels - 1; level-- > 0;)
  {
    const double ratio = findRatio(spacings[level], spacings[level + 1]);
    if (!(ratio >= 2.0))
    {
      return "expected the same whole refinement ratio of at least 2 along all axes, found "
             "spacing " +
        triple(&spacings[level].x) + " on level " + std::to_string(amrLevel[level]) + " and " +
        triple(&spacings[level + 1].x) + " on level " + std::to_string(amrLevel[level + 1]) +
        ". Check the spacings of the AMR";
    }
    const std::int64_t width = hierarchy.cellWidth[level + 1];
    if (ratio * static_cast<double>(width) >= static_cast<double>(LatticeLimit))
    {
      return describeWideRatio(ratio, amrLevel[level], amrLevel[level + 1], width);
    }
    hierarchy.cellWidth[level] = static_cast<std::int64_t>(ratio) * width;
  }
  // Of all spacings the coarsest is stored with the least relative error.
  hierarchy.spacing = spacings.front() / static_cast<double>(hierarchy.cellWidth.front());
  hierarchy.origin = origin;
  return {};
}

namespace
{
class Reader
{
public:
  Reader(vtkOverlappingAMR* amr, const LevelRange& levels)
    : AMR(amr)
    , Levels(levels)
    , Part(findPart(amr))
  {
  }

  AMRInput read()
  {
    const unsigned int count = this->AMR->GetNumberOfLevels();
    for (unsigned int level = this->Levels.first;
         level < count && level <= this->Levels.last && this->Ok(); ++level)
    {
      double spacing[3];
      this->AMR->GetSpacing(level, spacing);
      if (this->Part && spacing[0] > 0.0)
      {
        this->AddLevel(level);
      }
      for (unsigned int index = 0; index < numberOfBlocks(this->AMR, level) && this->Ok(); ++index)
      {
        if (vtkDataSet* block = getBlock(this->AMR, level, index))
        {
          this->AddBlock(level, index, block);
        }
      }
    }
    if (this->Ok() && this->Input.grids.empty())
    {
      this->Input.fault = this->DescribeNoBlocks();
    }
    if (this->Ok())
    {
      this->FinishLattice();
      this->Input.unread = this->DescribeUnread();
    }
    return std::move(this->Input);
  }

private:
  bool Ok() const { return this->Input.fault.empty(); }

  std::string DescribeNoBlocks() const
  {
    const std::string levels = std::to_string(this->AMR->GetNumberOfLevels()) + " levels";
    return this->Levels.first == 0 && this->Levels.last + 1 >= this->AMR->GetNumberOfLevels()
      ? "expected an AMR with at least one block, found none in its " + levels +
        ". Let the reader read more levels, or check the file"
      : "expected at least one block from level " + std::to_string(this->Levels.first) + " to " +
        std::to_string(this->Levels.last) + ", found none, of " + levels +
        ". Call SetLevelRange() with levels that are there";
  }

  // Readers tell the boxes of all levels, and read few of them unless they are told to.
  std::string DescribeUnread() const
  {
    const auto read = static_cast<unsigned int>(this->Input.amrLevel.back()) + 1;
    const unsigned int wanted = std::min(this->Levels.last, this->AMR->GetNumberOfLevels() - 1) + 1;
    unsigned int levels = 0; // up to the last one that has blocks
    double shown = 0.0;      // cells without finer ones, as far as they were read
    double all = 0.0;
    double coarser = 0.0; // volume of a cell of the level before
    for (unsigned int level = this->Levels.first; level < wanted; ++level)
    {
      double cells = 0.0;
      for (unsigned int index = 0; index < numberOfBlocks(this->AMR, level); ++index)
      {
        cells += static_cast<double>(this->AMR->GetAMRBox(level, index).GetNumberOfCells());
      }
      if (!(cells > 0.0))
      {
        continue;
      }
      double spacing[3];
      this->AMR->GetSpacing(level, spacing);
      const double volume = spacing[0] * spacing[1] * spacing[2];
      all += cells - (coarser > 0.0 ? cells * volume / coarser : 0.0);
      shown = level < read ? all : shown;
      levels = level + 1;
      coarser = volume;
    }
    if (levels <= read || !(shown > 0.0 && all > shown))
    {
      return {};
    }
    std::ostringstream text;
    text << "Of " << levels << " levels " << read << (read == 1 ? " was" : " were")
         << " read, with " << std::setprecision(2) << 100.0 * shown / all
         << " % of the cells that there are. For more call SetMaxLevel(" << levels - 1
         << ") of the reader, or SetMaximumLevelsToReadByDefault(0) of one of .vthb files; or "
            "SetLevelRange(0, "
         << read - 1 << ") of the mapper, if it is meant.";
    return text.str();
  }

  void AddLevel(unsigned int level)
  {
    this->Input.amrLevel.push_back(static_cast<int>(level));
    double spacing[3];
    this->AMR->GetSpacing(level, spacing);
    this->Spacings.emplace_back(spacing[0], spacing[1], spacing[2]);
  }

  void AddBlock(unsigned int level, unsigned int index, vtkDataSet* block)
  {
    vtkImageData* grid = vtkImageData::SafeDownCast(block);
    if (!grid)
    {
      this->Input.fault = "expected blocks with uniform spacing (vtkUniformGrid), found a " +
        std::string(block->GetClassName()) + " in " + blockName(level, index) +
        ". Resample it to a uniform grid";
      return;
    }
    int points[3];
    grid->GetDimensions(points);
    if (points[0] < 2 || points[1] < 2 || points[2] < 2)
    {
      this->Input.fault = "expected a 3-D AMR, found " + blockName(level, index) + " with " +
        std::to_string(points[0]) + " x " + std::to_string(points[1]) + " x " +
        std::to_string(points[2]) + " points: a 2-D AMR has no volume. Draw it as a surface";
      return;
    }
    if (this->Input.amrLevel.empty() || this->Input.amrLevel.back() != static_cast<int>(level))
    {
      this->AddLevel(level);
    }
    const vtkAMRBox& box = this->AMR->GetAMRBox(level, index);
    Block result;
    result.level = static_cast<int>(this->Input.amrLevel.size()) - 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      result.cells.lo[axis] = box.GetLoCorner()[axis];
      result.cells.hi[axis] = std::int64_t(box.GetHiCorner()[axis]) + 1;
    }
    this->AddGrid(level, index, grid, result);
  }

  // A grid may be larger than the AMR box, by ghost layers. Round-off in its origin is common.
  void AddGrid(unsigned int level, unsigned int index, vtkImageData* grid, const Block& block)
  {
    if (!grid->GetDirectionMatrix()->IsIdentity())
    {
      this->Input.fault = "expected grids along the axes, found the grid of " +
        blockName(level, index) +
        " turned. Turn the volume in its place: SetUserMatrix() of the vtkVolume, and "
        "SetDirectionMatrix() of the grids without";
      return;
    }
    const glm::dvec3& spacing = this->Spacings.back();
    const double* origin = this->AMR->GetOrigin();
    double bounds[6];
    grid->GetBounds(bounds);
    int points[3];
    grid->GetDimensions(points);
    Int3 offset;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double cells = (origin[axis] - bounds[2 * axis]) / spacing[axis] +
        static_cast<double>(block.cells.lo[axis]);
      const double off = std::round(cells); // it may be of any size, or not a number
      const double room = static_cast<double>(points[axis] - 1 - block.cells.size()[axis]);
      if (!(std::abs(cells - off) < 0.1) || !(off >= 0.0) || !(off <= room))
      {
        const double corner[3] = { bounds[0], bounds[2], bounds[4] };
        std::ostringstream text;
        text << "expected the grid of " << blockName(level, index)
             << " to lie on the lattice of its level and to hold its AMR box of "
             << block.cells.size().x << " x " << block.cells.size().y << " x "
             << block.cells.size().z << " cells, found a grid of " << points[0] - 1 << " x "
             << points[1] - 1 << " x " << points[2] - 1 << " cells at " << triple(corner)
             << ". Check the AMR boxes, origin and spacing";
        this->Input.fault = text.str();
        return;
      }
      offset[axis] = static_cast<std::int64_t>(off);
    }
    this->Input.hierarchy.blocks.push_back(block);
    this->Input.grids.emplace_back(grid);
    this->Input.numbers.push_back(index);
    this->Input.offsets.push_back(offset);
  }

  // The whole with this hierarchy's levels.
  std::shared_ptr<const WholeHierarchy> FindWhole() const
  {
    auto whole = std::make_shared<WholeHierarchy>();
    whole->completed = this->Part->whole->completed;
    const std::vector<int>& levels = this->Input.amrLevel;
    whole->blocks.reserve(this->Part->whole->blocks.size());
    for (const Block& block : this->Part->whole->blocks)
    {
      const auto level = std::lower_bound(levels.begin(), levels.end(), block.level);
      if (level != levels.end() && *level == block.level)
      {
        whole->blocks.push_back({ static_cast<int>(level - levels.begin()), block.cells });
      }
    }
    for (const int level : levels)
    {
      const auto& reach = this->Part->whole->reach;
      whole->reach.push_back(
        level < static_cast<int>(reach.size()) ? reach[static_cast<std::size_t>(level)] : 0);
    }
    return whole;
  }

  void FinishLattice()
  {
    const double* origin = this->AMR->GetOrigin();
    this->Input.fault = makeLattice(this->Spacings, this->Input.amrLevel,
      { origin[0], origin[1], origin[2] }, this->Input.hierarchy);
    if (this->Part && this->Ok() &&
      (this->Levels.first > 0 || this->Levels.last + 1 < this->AMR->GetNumberOfLevels()))
    {
      this->Input.fault =
        "expected all levels of one process's part of an AMR, found a level range. "
        "Call SetLevelRange() of the vtkExaBricksRedistribute";
    }
    if (this->Part && this->Ok())
    {
      this->Input.hierarchy.shown = this->Part->box;
      this->Input.hierarchy.whole = this->FindWhole();
    }
    this->Input.fault = this->Ok() ? findFault(this->Input.hierarchy) : this->Input.fault;
  }

  vtkOverlappingAMR* AMR;
  const LevelRange Levels;
  const std::optional<AMRPart> Part;
  AMRInput Input;
  std::vector<glm::dvec3> Spacings; // [level of the hierarchy]
};
}

AMRInput readAMR(vtkOverlappingAMR* amr, const LevelRange& levels)
{
  return Reader(amr, levels).read();
}

bool takePoints(AMRInput& input)
{
  const bool only = input.grids.size() == 1;
  vtkImageData* grid = only ? input.grids.front().Get() : nullptr;
  if (!only ||
    findGhosts(grid->GetCellData(), grid->GetNumberOfCells(), vtkDataSetAttributes::HIDDENCELL))
  {
    return false;
  }
  Hierarchy& hierarchy = input.hierarchy;
  Box& cells = hierarchy.blocks.front().cells;
  cells.hi += std::int64_t(1);
  hierarchy.origin -= 0.5 * hierarchy.spacing;
  hierarchy.shown = Box{ cells.lo * std::int64_t(2) + std::int64_t(1),
    cells.hi * std::int64_t(2) - std::int64_t(1) };
  input.onPoints = true;
  return true;
}
}
