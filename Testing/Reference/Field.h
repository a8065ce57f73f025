// SPDX-License-Identifier: BSD-3-Clause
// The field of an AMR hierarchy in double precision, leaf cell by leaf cell. It knows nothing of
// bricks and regions, so that it can judge what is built of them.
#ifndef ExaBricksReferenceField_h
#define ExaBricksReferenceField_h

#include "Core/CellSource.h"
#include "Core/LeafBoxes.h"
#include "Core/Range.h"

#include <array>
#include <glm/vec3.hpp>
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

class Field
{
public:
  /// Reads all leaf cells and normalises them to `range`; without it, to their own.
  Field(const Hierarchy& hierarchy, const LeafBoxes& leaves, const CellSource& source,
    const std::optional<Range>& range);

  // A leaf box with its normalised values, x fastest; NaN: absent.
  struct Leaf
  {
    int level;
    Box cells; // of its level
    Box box;   // logical
    std::vector<double> values;
    bool hasAbsent = false;
    std::vector<std::uint32_t> otherLevels; // leaf boxes of other levels whose tents reach in
    std::vector<int> levels;                // of those and its own
  };
  // The eight cells of a level around a point, x fastest.
  struct Corners
  {
    std::array<double, 8> values{}; // 0 where there is none
    std::array<double, 8> there{};  // 1 or 0
    int count = 0;
  };

  const Range& range() const { return this->ValueRange; }
  const std::vector<Leaf>& leaves() const { return this->Leaves; }
  std::size_t levels() const { return this->Levels.size(); }
  double width(int level) const { return static_cast<double>(this->Levels[level].width); }

  /// Value of a leaf cell of the level; NaN: absent; null: there is none.
  const double* find(int level, const Int3& cell) const;
  /// Of the cells `base` and base + 1 along each axis.
  Corners corners(int level, const Int3& base) const;
  /// The normalised value at a logical position; none where no leaf cell is, or an absent one.
  std::optional<double> sample(const glm::dvec3& logical, Reconstruction reconstruction) const;

private:
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

  void Load(const Hierarchy& hierarchy, const LeafBoxes& leaves, const CellSource& source);
  void FindNeighbors(const Hierarchy& hierarchy);
  void Normalize(const std::optional<Range>& range);
  void BuildLevels(const Hierarchy& hierarchy);
  double Basis(const glm::dvec3& logical, const std::vector<int>& levels) const;

  std::vector<Leaf> Leaves;
  std::vector<Level> Levels;
  Range ValueRange;
};
}
}

#endif
