// SPDX-License-Identifier: BSD-3-Clause
// Visits the blocks of an AMR data set that are there, in a way that all versions of VTK share.

#ifndef ExaBricksRenderBlocks_h
#define ExaBricksRenderBlocks_h

#include "vtkCompositeDataIterator.h"
#include "vtkDataSet.h"
#include "vtkOverlappingAMR.h"
#include "vtkSmartPointer.h"

namespace render
{

// Calls f(vtkDataSet*) for each block.
template <class Function>
void forEachBlock(vtkOverlappingAMR* amr, Function f)
{
  vtkSmartPointer<vtkCompositeDataIterator> blocks;
  blocks.TakeReference(amr->NewIterator());
  blocks->SkipEmptyNodesOn();
  for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
  {
    if (auto* block = vtkDataSet::SafeDownCast(blocks->GetCurrentDataObject()))
    {
      f(block);
    }
  }
}

}

#endif
