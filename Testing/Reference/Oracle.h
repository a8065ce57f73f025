// SPDX-License-Identifier: BSD-3-Clause
// What the pictures ought to be: renders an AMR hierarchy in double precision to a set error. Rays
// are split wherever the field has a kink, and integrated piece by piece (RayIntegral).
#ifndef ExaBricksReferenceOracle_h
#define ExaBricksReferenceOracle_h

#include "Core/TransferFunction.h"
#include "Reference/Field.h"
#include "Reference/Image.h"
#include "Reference/View.h"

namespace exabricks
{
namespace reference
{
class Oracle
{
public:
  /// Reads all leaf cells; values are normalised to `range`, or to their own.
  Oracle(const Hierarchy& hierarchy, const LeafBoxes& leaves, const CellSource& source,
    const std::optional<Range>& range = {});

  const Range& range() const { return this->Values.range(); }
  /// The normalised value at a logical position; none where no leaf cell is, or an absent one.
  std::optional<double> sample(const glm::dvec3& logical, Reconstruction reconstruction) const
  {
    return this->Values.sample(logical, reconstruction);
  }

  struct Settings
  {
    Reconstruction reconstruction = Reconstruction::Basis;
    double opacityUnitDistance = 1.0; // world
    double tolerance = 1e-7;          // greatest error of a pixel's channel
  };
  /// Volume rendering front to back, never ended early, on no background.
  Image render(const View& view, const TransferFunction& transfer, const Settings& settings) const;
  /// The same, with an estimate of the greatest error in a channel of any pixel.
  Image render(const View& view, const TransferFunction& transfer, const Settings& settings,
    double& error) const;

private:
  struct Group // of neighbouring leaf boxes, to pass over many at once
  {
    Box box;
    std::size_t begin, end;
  };
  class Ray;

  Field Values;
  std::vector<Group> Groups;
};
}
}

#endif
