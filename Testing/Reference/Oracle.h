// SPDX-License-Identifier: BSD-3-Clause
// What the pictures ought to be: samples and renders an AMR hierarchy in double precision, leaf
// cell by leaf cell. It knows nothing of bricks and regions, so that it can judge what is built of
// them.
#ifndef ExaBricksReferenceOracle_h
#define ExaBricksReferenceOracle_h

#include "Core/LeafBoxes.h"
#include "Core/Scalars.h" // CellSource and Range
#include "Core/TransferFunction.h"
#include "Reference/View.h"

#include <optional>

namespace exabricks
{
namespace reference
{
enum class Reconstruction
{
  Basis,  // weighted mean of the tents of all leaf cells around the point
  Nearest // the leaf cell that holds the point
};

/// Premultiplied red, green, blue, opacity; row 0 at the bottom, x fastest.
struct Image
{
  int width = 0;
  int height = 0;
  std::vector<glm::dvec4> pixels;

  const glm::dvec4& at(int x, int y) const
  {
    return this->pixels[x + static_cast<std::size_t>(this->width) * y];
  }
};

class Oracle
{
public:
  /// Reads all leaf cells; values are normalised to their own range.
  Oracle(const Hierarchy& hierarchy, const LeafBoxes& leaves, const CellSource& source);
  /// The same, normalised to `range`.
  Oracle(const Hierarchy& hierarchy, const LeafBoxes& leaves, const CellSource& source,
    const Range& range);

  const Range& range() const { return this->ValueRange; }

  /// The normalised value at a logical position; none where no leaf cell is, or an absent one.
  std::optional<double> sample(const glm::dvec3& logical, Reconstruction reconstruction) const;

  struct Settings
  {
    Reconstruction reconstruction = Reconstruction::Basis;
    double opacityUnitDistance = 1.0; // world
    double step = 1.0 / 32.0; // longest interval, in cells of the finest level near it; basis only
  };
  /// Volume rendering by the midpoint rule, front to back, never ended early, on no background.
  /// Intervals end at the faces of leaf cells, so for nearest the integral is exact.
  Image render(const View& view, const TransferFunction& transfer, const Settings& settings) const;

private:
  // A leaf box with its normalised values, x fastest; NaN: absent.
  struct Leaf
  {
    int level;
    Box cells;          // of its level
    Box box;            // logical
    double finestWidth; // least width of the cells whose tents reach into the box
    std::vector<double> values;
  };
  // A grid of equal buckets over the cells of one level; each lists the leaf boxes that touch it.
  struct Level
  {
    std::int64_t width = 1;
    Box bounds; // in its cells
    std::int64_t bucketCells = 1;
    Int3 buckets{ 0 };
    std::vector<std::uint32_t> first; // per bucket, and one more
    std::vector<std::uint32_t> leaves;
  };
  struct Group // of neighbouring leaf boxes, to pass over many at once
  {
    Box box;
    std::size_t begin, end;
  };
  class Cursor;

  void Load(const Hierarchy& hierarchy, const LeafBoxes& leaves, const CellSource& source);
  void Normalize();
  void BuildLevels(const Hierarchy& hierarchy);
  const double* Find(int level, const Int3& cell) const; // null: not a leaf cell
  glm::dvec4 March(const glm::dvec3& begin, const glm::dvec3& end, double worldLength,
    const TransferFunction& transfer, const Settings& settings) const;

  std::vector<Leaf> Leaves;
  std::vector<Group> Groups;
  std::vector<Level> Levels;
  Range ValueRange;
};

/// Peak signal-to-noise ratio in dB, over red, green, blue and opacity of the whole picture, with a
/// peak of 1. Infinite for equal pictures.
double psnr(const Image& a, const Image& b);
}
}

#endif
