// SPDX-License-Identifier: BSD-3-Clause
// The one place that knows how vtkOverlappingAMR changed: VTK 9.6 made it a
// vtkPartitionedDataSetCollection, whose blocks need not be images.
#ifndef ExaBricksAdaptersAMRCompatibility_h
#define ExaBricksAdaptersAMRCompatibility_h

#include "vtkOverlappingAMR.h"
#include "vtkStructuredData.h"
#include "vtkUniformGrid.h"

#include <vector>

#if __has_include("vtkOverlappingAMRMetaData.h")
#define EXABRICKS_AMR_OF_VTK_9_6
#include "vtkCartesianGrid.h"
#endif

namespace exabricks
{
/// Blocks of a level, whether they are there or not.
inline unsigned int numberOfBlocks(vtkOverlappingAMR* amr, unsigned int level)
{
#ifdef EXABRICKS_AMR_OF_VTK_9_6
  return amr->GetNumberOfBlocks(level);
#else
  return amr->GetNumberOfDataSets(level);
#endif
}

/// Levels of so many blocks, none of which is there yet. `description`: of their grids, as VTK
/// numbers it; 3-D if negative.
inline void initialize(
  vtkOverlappingAMR* amr, const std::vector<int>& blocksPerLevel, int description = -1)
{
#ifdef EXABRICKS_AMR_OF_VTK_9_6
  amr->Initialize(std::vector<unsigned int>(blocksPerLevel.begin(), blocksPerLevel.end()));
  constexpr int threeD = vtkStructuredData::VTK_STRUCTURED_XYZ_GRID;
#else
  amr->Initialize(static_cast<int>(blocksPerLevel.size()), blocksPerLevel.data());
  constexpr int threeD = VTK_XYZ_GRID;
#endif
  amr->SetGridDescription(description < 0 ? threeD : description);
}

/// The block, or null if it is not there.
inline vtkDataSet* getBlock(vtkOverlappingAMR* amr, unsigned int level, unsigned int index)
{
#ifdef EXABRICKS_AMR_OF_VTK_9_6
  return amr->GetDataSetAsCartesianGrid(level, index);
#else
  return amr->GetDataSet(level, index);
#endif
}

/// The number of a block among those of all levels, whether they are there or not: the composite
/// index of selections.
inline unsigned int numberOfBlock(vtkOverlappingAMR* amr, unsigned int level, unsigned int index)
{
#ifdef EXABRICKS_AMR_OF_VTK_9_6
  return static_cast<unsigned int>(amr->GetAbsoluteBlockIndex(level, index));
#else
  return static_cast<unsigned int>(amr->GetCompositeIndex(level, index));
#endif
}

/// Calls f(vtkDataSet*) for each block that is there.
template <typename Function>
void forEachBlock(vtkOverlappingAMR* amr, const Function& f)
{
  for (unsigned int level = 0; level < amr->GetNumberOfLevels(); ++level)
  {
    for (unsigned int index = 0; index < numberOfBlocks(amr, level); ++index)
    {
      if (vtkDataSet* block = getBlock(amr, level, index))
      {
        f(block);
      }
    }
  }
}

/// The first block that is there, or null.
inline vtkDataSet* getFirstBlock(vtkOverlappingAMR* amr)
{
  for (unsigned int level = 0; level < amr->GetNumberOfLevels(); ++level)
  {
    for (unsigned int index = 0; index < numberOfBlocks(amr, level); ++index)
    {
      if (vtkDataSet* block = getBlock(amr, level, index))
      {
        return block;
      }
    }
  }
  return nullptr;
}
}

#endif
