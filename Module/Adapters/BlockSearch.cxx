// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/BlockSearch.h"

#include "Adapters/AMRCompatibility.h"

#include "vtkAMRBox.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkUnsignedCharArray.h"

namespace exabricks
{
BlockSearch::BlockSearch(vtkOverlappingAMR* amr, const BrickedVolume& bricked)
  : AMR(amr)
  , Bricked(bricked)
  , Last(amr ? amr->GetNumberOfLevels() : 0, -1)
{
}

CellOfBlock BlockSearch::find(const LeafCell& leaf, const glm::dvec3& inCell)
{
  if (this->Bricked.onPoints)
  {
    return this->CellBetweenPoints(this->Bricked.world(inCell));
  }
  const Structure& structure = *this->Bricked.volume.structure;
  // The cell may be the rest of a coarser one, which finer blocks cover in part.
  const std::vector<std::int64_t>& widths = structure.hierarchy.cellWidth;
  for (int level = structure.bricks[leaf.brick].level; level >= 0 && this->AMR; --level)
  {
    const int amrLevel = this->Bricked.amrLevel[level];
    const auto width = static_cast<double>(widths[level]);
    const glm::dvec3 cell = glm::floor((glm::dvec3(leaf.lo) + 0.5) / width);
    const glm::dvec3 middle = this->Bricked.origin + this->Bricked.spacing * (width * (cell + 0.5));
    const CellOfBlock again = this->CellIn(amrLevel, this->Last[amrLevel], cell, middle, false);
    if (again.block >= 0)
    {
      return again;
    }
    const int blocks =
      static_cast<int>(numberOfBlocks(this->AMR, static_cast<unsigned int>(amrLevel)));
    for (const bool duplicate : { false, true })
    {
      for (int block = 0; block < blocks; ++block)
      {
        const CellOfBlock found = this->CellIn(amrLevel, block, cell, middle, duplicate);
        if (found.block >= 0)
        {
          this->Last[amrLevel] = block;
          return found;
        }
      }
    }
  }
  return {};
}

CellOfBlock BlockSearch::CellBetweenPoints(const glm::dvec3& place) const
{
  CellOfBlock found{ this->Bricked.amrLevel.front(), 0 };
  const auto level = static_cast<unsigned int>(found.level);
  const int blocks = this->AMR ? static_cast<int>(numberOfBlocks(this->AMR, level)) : 0;
  for (; found.block < blocks; ++found.block)
  {
    auto* grid = vtkImageData::SafeDownCast(
      getBlock(this->AMR, level, static_cast<unsigned int>(found.block)));
    double fractions[3];
    if (grid && grid->ComputeStructuredCoordinates(&place.x, found.ijk, fractions))
    {
      found.id = grid->ComputeCellId(found.ijk);
      return found;
    }
  }
  return {};
}

CellOfBlock BlockSearch::CellIn(
  int amrLevel, int block, const glm::dvec3& cell, const glm::dvec3& middle, bool duplicate) const
{
  const auto level = static_cast<unsigned int>(amrLevel);
  const auto index = static_cast<unsigned int>(block);
  if (block < 0 ||
    !this->AMR->GetAMRBox(level, index)
       .Contains(static_cast<int>(cell.x), static_cast<int>(cell.y), static_cast<int>(cell.z)))
  {
    return {};
  }
  vtkDataSet* const data = getBlock(this->AMR, level, index);
  if (!data)
  {
    return {};
  }
  CellOfBlock found{ amrLevel, block };
  auto* grid = vtkImageData::SafeDownCast(data);
  double fractions[3];
  if (grid && grid->ComputeStructuredCoordinates(&middle.x, found.ijk, fractions))
  {
    found.id = grid->ComputeCellId(found.ijk);
    vtkUnsignedCharArray* const ghosts = grid->GetCellGhostArray();
    if (!duplicate && ghosts &&
      (ghosts->GetValue(found.id) & vtkDataSetAttributes::DUPLICATECELL) != 0)
    {
      return {};
    }
  }
  return found;
}
}
