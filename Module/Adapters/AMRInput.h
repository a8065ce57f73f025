// SPDX-License-Identifier: BSD-3-Clause
// From vtkOverlappingAMR to the core's hierarchy, and its arrays as the core's source of values.
#ifndef ExaBricksAdaptersAMRInput_h
#define ExaBricksAdaptersAMRInput_h

#include "Core/CellSource.h"
#include "Core/Hierarchy.h"

#include "vtkSmartPointer.h"

class vtkDataArray;
class vtkDataSet;
class vtkImageData;
class vtkOverlappingAMR;
class vtkUnsignedCharArray;

namespace exabricks
{
struct AMRInput
{
  Hierarchy hierarchy;       // levels without blocks are left out
  std::vector<int> amrLevel; // [level of hierarchy], the AMR's own number of it
  std::vector<vtkSmartPointer<vtkImageData>> grids; // [block]
  std::vector<Int3> offsets; // [block], of its AMR box in the grid's cells (ghost layers)
  std::string fault;         // empty, or why it cannot be drawn
};

AMRInput readAMR(vtkOverlappingAMR* amr);

/// Reads cells of the blocks' arrays, of any type; hidden cells as absent. `component` -1:
/// magnitude.
class AMRCellSource : public CellSource
{
public:
  AMRCellSource(const AMRInput& input, int component);

  /// The block's array, one value for each cell of its grid.
  void setArray(int block, vtkDataArray* array);

  void read(int block, const Box& cells, double* values) const override;
  bool hasDuplicates(int block) const override;
  void readDuplicates(int block, const Box& cells, unsigned char* duplicate) const override;

private:
  struct Source
  {
    vtkSmartPointer<vtkDataArray> Array;
    const unsigned char* Ghosts = nullptr; // vtkGhostType of each cell, or null
    bool Duplicates = false;
    Int3 GridCells{ 0 }; // cells of the grid along each axis
    Int3 First{ 0 };     // what to subtract from a cell of the level to get a cell of the grid
  };
  template <typename Visitor>
  void ForEachRow(const Source& source, const Box& cells, Visitor&& visit) const;

  int Component;
  std::vector<Source> Sources;
};
}

#endif
