// SPDX-License-Identifier: BSD-3-Clause
// From vtkOverlappingAMR to the core's hierarchy, and its arrays as the core's source of values.
#ifndef ExaBricksAdaptersAMRInput_h
#define ExaBricksAdaptersAMRInput_h

#include "Core/CellSource.h"
#include "Core/Hierarchy.h"

#include "vtkSmartPointer.h"

#include <limits>

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
  std::vector<int> amrLevel; // [level of the hierarchy], its number in the AMR
  std::vector<vtkSmartPointer<vtkImageData>> grids; // [block]
  std::vector<unsigned int> numbers;                // [block], in its level of the AMR
  std::vector<Int3> offsets; // [block], of its AMR box in the cells of its grid (ghost layers)
  bool onPoints = false;     // see takePoints()
  std::string fault;         // empty, or why it cannot be drawn
  std::string unread;        // empty, or how much less than there is a reader has read
};

/// Levels of an AMR, from the one number to the other.
struct LevelRange
{
  unsigned int first = 0;
  unsigned int last = std::numeric_limits<unsigned int>::max();
};

/// Sets the hierarchy's widths, origin and spacing by the spacing of each of its levels, whose
/// numbers in the AMR are for messages. Returns what was expected, what was found and what to do,
/// or nothing.
std::string makeLattice(const std::vector<glm::dvec3>& spacings, const std::vector<int>& amrLevel,
  const glm::dvec3& origin, Hierarchy& hierarchy);

/// Reads boxes, origin and spacing, and no values. An AMR that is a part of a larger one (AMRPart)
/// has the lattice of all of its levels, and shows its part. Levels outside of the range are left
/// out, as if they were not there.
AMRInput readAMR(vtkOverlappingAMR* amr, const LevelRange& levels = {});

/// Takes the points of an only block for the middles of cells, and shows what lies between them, so
/// that its point arrays are drawn as VTK draws those of an image. False: there are several blocks,
/// or cells are hidden, which are no cells then.
bool takePoints(AMRInput& input);

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
