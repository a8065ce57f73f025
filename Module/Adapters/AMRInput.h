// SPDX-License-Identifier: BSD-3-Clause
// From vtkOverlappingAMR to the core's hierarchy.
#ifndef ExaBricksAdaptersAMRInput_h
#define ExaBricksAdaptersAMRInput_h

#include "Core/Hierarchy.h"

#include "vtkSmartPointer.h"

#include <limits>

class vtkImageData;
class vtkOverlappingAMR;

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
}

#endif
