// SPDX-License-Identifier: BSD-3-Clause
// Fields with a formula, on the unit cube, and the grids on which they are sampled. A cell's value
// is the field at its centre. (Its mean over the cell differs from that by width^2 / 24 times the
// Laplacian: no less than second order, so the orders are the same for either.)
#ifndef ExaBricksAccuracyAnalyticFields_h
#define ExaBricksAccuracyAnalyticFields_h

#include "Core/LeafBoxes.h"
#include "Reference/Scenes.h" // CellField

namespace exabricks
{
namespace accuracy
{
struct Field
{
  std::string name;
  std::function<double(const glm::dvec3& p)> value; // p in the unit cube
};

Field constant(double value);
/// 0.1 + slope . p
Field linear(const glm::dvec3& slope);
/// coefficients . p^2
Field quadratic(const glm::dvec3& coefficients);
/// exp(-|p - center|^2 / width^2)
Field gaussian(const glm::dvec3& center, double width);
/// A front of tanh profile, from 1 behind it to 0 ahead, `width` wide, that moves through the cube
/// along its diagonal: in one corner at `time` 0, in the other at 1.
Field movingFront(double time, double width);
/// reference::shellAndBlobs: thin structures that refined grids follow.
Field shellAndBlobs();

/// A hierarchy whose bounds are the unit cube.
struct Grid
{
  Hierarchy hierarchy;
  LeafBoxes leaves;
  int coarseCells = 0;  // along each axis
  double cellShare = 1; // logical to unit cube: the width of a finest cell

  double coarseWidth() const { return 1.0 / this->coarseCells; }
};

/// One level for `ratio` 1, else two: the finer one in the box [1/4, 3/4]^3, which has faces, edges
/// and corners to the coarse cells. `coarseCells` is a multiple of 4.
Grid makeBoxGrid(int ratio, int coarseCells);
/// reference::refinedAtShell in blocks of 4: refined where the structures of shellAndBlobs are.
Grid makeShellGrid(const std::vector<int>& ratios, int coarseCells);

/// The field at the centres of the cells.
reference::CellField atCenters(const Grid& grid, const Field& field);
}
}

#endif
