// SPDX-License-Identifier: BSD-3-Clause
// The hierarchies of Testing/Reference as VTK's readers would hand them over, and what cases share.
#ifndef ExaBricksStabilityMakeAMR_h
#define ExaBricksStabilityMakeAMR_h

#include "Case.h"

#include "Reference/Scenes.h"

class vtkDataArray;

namespace exabricks
{
namespace stability
{
/// Values by formula.
class FieldSource : public CellSource
{
public:
  FieldSource(const Hierarchy& hierarchy, reference::CellField field);
  void read(int block, const Box& cells, double* values) const override;

private:
  reference::CellField Field;
  std::vector<int> Levels;
};

struct AMROptions
{
  vtkDataArray* like = nullptr; // type of the arrays; double if null
  int ghosts = 0;               // layers of cells around each block ...
  double ghostValue = 0.0;      // ... with this value
  bool ghostsMarked = false;    // as duplicates
  int nullBlock = -1;           // this one of the hierarchy's is not there
};

/// Covered cells are marked as such, as VTK's readers do.
vtkSmartPointer<vtkOverlappingAMR> makeAMR(
  const Hierarchy& hierarchy, const reference::CellField& field, const AMROptions& options = {});

/// Values that show structure, between about 0 and 1: reference::shellAndBlobs.
reference::CellField shellField(const Hierarchy& hierarchy);
/// reference::layeredTransfer for these values, moved to [lo, hi].
std::vector<Node> layers(double lo = 0.0, double hi = 1.0);
/// One colour and opacity for all values.
std::vector<Node> constantNodes(double opacity, const glm::dvec3& color = { 0.9, 0.6, 0.3 });

/// For the oracle: on values normalised to `range`, in a way of its own, to judge the adapter's.
TransferFunction normalize(const std::vector<Node>& nodes, const Range& range);

/// A block of so many cells of one level.
Hierarchy oneBlock(const Int3& cells);

/// 32 finest cells along each axis, ratio 2. Four blocks, so that renderers with a texture for each
/// are not stopped by their number in every case; the shell lies in cells of both levels.
Hierarchy twoLevels();

/// A shell in `hierarchy` and its layers, seen from a corner.
Setting shellSetting(const Hierarchy& hierarchy, double viewAngle = 30.0);
/// `field` in `hierarchy`, seen from a corner.
Setting fieldSetting(const Hierarchy& hierarchy, const reference::CellField& field,
  double viewAngle = 30.0, const AMROptions& options = {});
/// Looks along `direction` at all of the setting's hierarchy.
void look(Setting& setting, const glm::dvec3& direction, double viewAngle);
}
}

#endif
