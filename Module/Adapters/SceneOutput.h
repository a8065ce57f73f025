// SPDX-License-Identifier: BSD-3-Clause
// From the core's hierarchy, values and triangles to VTK's data objects.
#ifndef ExaBricksAdaptersSceneOutput_h
#define ExaBricksAdaptersSceneOutput_h

#include "Scenes/StandIn.h"

class vtkOverlappingAMR;
class vtkPolyData;
class vtkVolumeProperty;

namespace exabricks
{
/// Which of several processes has a block: blocks of each level are dealt in turn.
struct Piece
{
  int number = 0;
  int count = 1;

  bool has(unsigned int block) const
  {
    return static_cast<int>(block) % this->count == this->number;
  }
};

/// Writes blocks with a cell array `name`; cells that finer blocks cover are marked REFINEDCELL. Of
/// blocks that the piece does not have the box alone. Returns false if `progress` aborts, and
/// throws std::bad_alloc.
bool writeAMR(const Hierarchy& hierarchy, const CellSource& cells, const char* name,
  vtkOverlappingAMR* amr, const Progress& progress = {}, const Piece& piece = {});

void writeMesh(const TriangleMesh& mesh, vtkPolyData* output);

/// Sets colours and opacities of the values in `range`, to which `transfer` is normalised.
void writeTransfer(
  const TransferFunction& transfer, const Range& range, vtkVolumeProperty* property);
}

#endif
