// SPDX-License-Identifier: BSD-3-Clause
// Cases in which volume renderers of AMR are known to fail, each with a bound that ours has to keep
// and the reason for it.
#ifndef ExaBricksStabilityCase_h
#define ExaBricksStabilityCase_h

#include "Core/CellSource.h"
#include "Core/Hierarchy.h"
#include "Reference/Oracle.h"

#include "vtkOverlappingAMR.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <memory>

namespace exabricks
{
namespace stability
{
/// A node of the transfer function; two of equal value are a jump.
struct Node
{
  double value;     // of the array
  glm::dvec4 color; // red, green, blue, opacity of the unit distance
};

/// What is drawn, and how.
struct Setting
{
  vtkSmartPointer<vtkOverlappingAMR> amr; // with the cell array "value"
  /// Instead of an AMR, where VTK has no memory for its blocks.
  std::shared_ptr<const CellSource> cells;
  Hierarchy hierarchy; // the lattice of the AMR; with `cells`, all of it
  /// The values as they ought to be read, so that the oracle does without the adapters; empty: it
  /// reads the AMR through them.
  std::function<double(int level, const Int3& cell)> field;
  std::vector<Node> transfer;
  double unitDistance = 1.0;

  reference::Camera camera;
  int width = 48;
  int height = 48;
  double scale = 1.0; // of the volume's matrix
  double stepScale = 0.25;
  /// Rays that lie in faces of cells may take either side: the truth is that of the rays this far
  /// off to one of the sides, in finest cells. 0: no ray does.
  double beside = 0.0;
  std::size_t leastBricks = 0; // so many there have to be
  std::size_t leastRegions = 0;
  std::uint64_t largestValueBuffer = std::numeric_limits<std::uint64_t>::max(); // bytes

  /// The picture as it ought to be, where there is a better way to it than the oracle.
  std::function<reference::Image(const reference::View&, reference::Reconstruction)> truth;
};

struct Case
{
  std::string name;
  std::string elsewhere; // what fails in other renderers
  std::function<Setting()> make;
  double basis; // least PSNR over the drawn pixels, dB
  double nearest;
  std::string reason; // of the bounds
  bool blank = false; // nothing is to be seen
};

struct Theme
{
  std::string name;
  std::vector<Case> cases;
};

std::vector<Case> levelCases();
std::vector<Case> cellCases();
std::vector<Case> geometryCases();
std::vector<Case> rayCases();
std::vector<Case> transferCases();
std::vector<Case> valueCases();
std::vector<Case> sizeCases();
std::vector<Theme> allThemes();
}
}

#endif
