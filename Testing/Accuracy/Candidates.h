// SPDX-License-Identifier: BSD-3-Clause
// Reconstructions weighed against the basis, in double precision: of them, the library offers
// `completed` (Core/Completion). The basis B(p) = sum H_C v_C / sum H_C does not reproduce a linear
// field across levels, because the mean of the cells' centres m(p) = sum H_C C / sum H_C is not p
// there. Both candidates mend that, are continuous, and are the basis wherever only cells of one
// level reach.
#ifndef ExaBricksAccuracyCandidates_h
#define ExaBricksAccuracyCandidates_h

#include "Core/LeafBoxes.h"
#include "Reference/Scenes.h" // CellField

namespace exabricks
{
namespace accuracy
{
class Candidates
{
public:
  Candidates(
    const Hierarchy& hierarchy, const LeafBoxes& leaves, const reference::CellField& field);

  /// B(p) + G(p) . (p - m(p)), G the basis of the cells' gradients. One gradient a cell; twice the
  /// sums; leaves the range of the cells.
  double corrected(const glm::dvec3& logical) const;

  /// sum_l W_l(p) T_l(p) / sum_l W_l(p): W_l is the sum of the tents of level l's leaf cells, as in
  /// the basis, but T_l interpolates all eight lattice points of level l around p. Those that are
  /// no leaf cells are given values beforehand, from the leaf cells there and their gradients: on
  /// the device, a layer of such cells around each brick. A sample does as much as it does for the
  /// basis. Here also beyond the bounds of the data, by gradients.
  double completedBeyond(const glm::dvec3& logical) const
  {
    return this->InterpolateLevels(logical, &Level::completedBeyond);
  }
  /// The same, but beyond the bounds of the data the value stays, as it does for the basis.
  double completed(const glm::dvec3& logical) const
  {
    return this->InterpolateLevels(logical, &Level::completed);
  }

private:
  struct Level
  {
    std::int64_t width = 1;
    Box bounds;                 // of its leaf cells, and a layer around them; in its cells
    std::vector<double> values; // x fastest; NaN: not a leaf cell
    std::vector<glm::dvec3> gradients;
    // values, and those of the lattice points beside leaf cells
    std::vector<double> completedBeyond;
    std::vector<double> completed;

    std::size_t at(const Int3& cell) const;
    bool isLeaf(const Int3& cell) const;
  };

  template <typename Visitor>
  void ForEachFaceNeighbour(int level, const Int3& cell, const Visitor& visit) const;
  glm::dvec3 FindGradient(int level, const Int3& cell) const;
  void Complete(int level, const Int3& cell);
  double InterpolateLevels(const glm::dvec3& p, std::vector<double> Level::*values) const;

  std::vector<Level> Levels;
  double Min, Max;
};
}
}

#endif
