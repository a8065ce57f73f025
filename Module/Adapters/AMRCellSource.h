// SPDX-License-Identifier: BSD-3-Clause
// The arrays of an AMR as the core's source of values.
#ifndef ExaBricksAdaptersAMRCellSource_h
#define ExaBricksAdaptersAMRCellSource_h

#include "Adapters/AMRInput.h"
#include "Core/CellSource.h"

#include <optional>
#include <vector>

class vtkDataArray;

namespace exabricks
{
/// Reads cells of the blocks' arrays, of any type; hidden cells as absent ones.
class AMRCellSource : public CellSource
{
public:
  /// `component`: which one to read of an array with several; -1: their magnitude.
  AMRCellSource(const AMRInput& input, int component);

  /// Reads another component; cells of which any component is not finite are absent then.
  void selectOfAll(int component);

  /// The block's array, one value for each cell of its grid, or each point, if they were taken.
  void setArray(int block, vtkDataArray* array);
  /// Another one: of all, what setArray() has set is component 0 then, and this is component 1.
  /// Which of its own components: as for the constructor.
  void setSecondArray(int block, vtkDataArray* array, int component);

  /// The range to normalise each component to, of those that are read; none: that of the cells.
  void setWholeRanges(std::vector<std::optional<Range>> ranges);

  void read(int block, const Box& cells, double* values) const override;
  std::optional<Range> wholeRange() const override;
  bool hasDuplicates(int block) const override;
  void readDuplicates(int block, const Box& cells, unsigned char* duplicate) const override;

private:
  struct Source
  {
    vtkSmartPointer<vtkDataArray> array;
    vtkSmartPointer<vtkDataArray> second;       // null: there is none
    const unsigned char* ghosts = nullptr;      // vtkGhostType of each cell, or null
    const unsigned char* pointGhosts = nullptr; // of corners of cells, if some are hidden, or null
    unsigned char hidden = 0;                   // its bit for what is hidden
    bool hasDuplicates = false;
    Int3 gridCells{ 0 }; // cells of the grid along each axis
    Int3 first{ 0 };     // what to subtract from a cell of the level to get a cell of the grid
  };
  template <typename Visitor>
  void ForEachRow(const Source& source, const Box& cells, Visitor&& visit) const;
  void HideCellsOfHiddenPoints(const Source& source, const Box& cells, double* values) const;

  int Component;
  int FirstComponent;
  int SecondComponent = 0;
  bool NeedsAll = false; // components to be finite
  std::vector<std::optional<Range>> WholeRanges;
  std::vector<Source> Sources;
};
}

#endif
