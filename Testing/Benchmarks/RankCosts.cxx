// SPDX-License-Identifier: BSD-3-Clause
#include "RankCosts.h"

#include "Timing.h"

#include "Core/BoxIndex.h"
#include "Core/Parts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace exabricks
{
namespace benchmarks
{
namespace
{
// Measured on two processor cores by lavapipe (Documentation/Evaluation): a process has as many.
constexpr double SecondsPerSample = 2.2e-8; // at step 1, the k-d tree
constexpr double CellsPerSecond = 2e7;      // of structures, octrees of small bricks
// Octrees of small bricks, the k-d tree; each of them less than 5 where blocks are large.
constexpr double HostBytesPerCell = 4.0 + 10.5; // of an array, and of structure and values
constexpr double DeviceBytesPerCell = 6.9;
constexpr double BytesPerBlock = 300.0; // that all processes hold
// Taken for granted, not measured: of a network, from one process to all others.
constexpr double BytesPerSecond = 1e9;
constexpr double SecondsPerMessage = 2e-5;
constexpr double BytesPerPixel = 8.0; // colour, opacity and depth, 8 and 32 bits

struct Use
{
  double drawn = 0.0;
  double held = 0.0;
  double samples = 0.0;
};

// How many samples a cell takes in a picture: its mean projected area is 3/2 w^2 and the mean
// length of rays in it 2/3 w, so with steps of its width w as many as pixels fit into w^2.
class SamplesOfCells
{
public:
  SamplesOfCells(const Model& model, const Size& size)
    : Spacing(model.hierarchy.spacing)
    , Eye(model.camera.position)
    , Ahead(glm::normalize(model.camera.focalPoint - model.camera.position))
    , Right(glm::normalize(glm::cross(this->Ahead, model.camera.viewUp)))
    , Up(glm::cross(this->Right, this->Ahead))
    , Slope(std::tan(glm::radians(0.5 * model.camera.viewAngle)))
    , ParallelScale(model.camera.parallelScale)
    , Aspect(static_cast<double>(size[0]) / size[1])
    , Pixels(size[1])
  {
  }

  double of(const Box& halfCells, std::int64_t width) const
  {
    const glm::dvec3 middle = 0.25 * glm::dvec3(halfCells.lo + halfCells.hi);
    const glm::dvec3 way = this->Spacing * middle - this->Eye;
    const double far = glm::dot(way, this->Ahead);
    const double half = this->Slope > 0.0 ? far * this->Slope : this->ParallelScale;
    if (!(far > 0.0) || std::abs(glm::dot(way, this->Up)) > half ||
      std::abs(glm::dot(way, this->Right)) > half * this->Aspect)
    {
      return 0.0;
    }
    const double side =
      std::cbrt(this->Spacing.x * this->Spacing.y * this->Spacing.z) * static_cast<double>(width);
    const double inPixels = side * this->Pixels / (2.0 * half);
    return inPixels * inPixels;
  }

private:
  const glm::dvec3 Spacing;
  const glm::dvec3 Eye;
  const glm::dvec3 Ahead;
  const glm::dvec3 Right;
  const glm::dvec3 Up;
  const double Slope; // 0: rays are parallel
  const double ParallelScale;
  const double Aspect;
  const double Pixels;
};

double cellsIn(const Box& halfCells, std::int64_t width)
{
  const glm::dvec3 size = glm::dvec3(halfCells.size()) / (2.0 * static_cast<double>(width));
  return size.x * size.y * size.z;
}

// Leaf boxes of each level, to be found by place.
std::vector<BoxIndex> indexLevels(const LeafBoxes& leaves, std::size_t levels)
{
  std::vector<std::vector<Box>> boxes(levels);
  for (const LeafBox& leaf : leaves.boxes)
  {
    boxes[static_cast<std::size_t>(leaf.level)].push_back(leaf.box);
  }
  std::vector<BoxIndex> index;
  for (std::vector<Box>& ofLevel : boxes)
  {
    index.emplace_back(std::move(ofLevel));
  }
  return index;
}
}

const char* const RankCostsHeader =
  "scene,leaf_cells,blocks,ranks,parts,drawn_most,drawn_mean,held_most,held_mean,"
  "received_bytes_most,host_bytes_most,device_bytes_most,samples_most,samples_mean,cut_s,exchange_"
  "s,structure_s,"
  "picture_s,compositing_s";

void printRankCosts(const Model& model, const Size& size, int most)
{
  const Hierarchy& hierarchy = model.hierarchy;
  const LeafBoxes leaves = findLeafBoxes(hierarchy);
  const std::vector<Brick> bricks = buildBricks(leaves, hierarchy.cellWidth);
  const std::vector<BoxIndex> index = indexLevels(leaves, hierarchy.cellWidth.size());
  const SamplesOfCells samplesOf(model, size);
  const double blocks = static_cast<double>(hierarchy.blocks.size());
  for (int ranks = 1; ranks <= most; ranks *= 2)
  {
    Costs cut;
    Parts parts;
    cut.measure([&] { parts = cutIntoParts(leaves, bricks, hierarchy.cellWidth, ranks); });
    Use greatest;
    Use sum;
    int filled = 0;
    for (const Box& part : parts.boxes)
    {
      if (part.empty())
      {
        continue;
      }
      Use use;
      const std::vector<std::int64_t> reach = findReach(leaves, hierarchy.cellWidth, part, false);
      for (std::size_t level = 0; level < index.size(); ++level)
      {
        const std::int64_t width = hierarchy.cellWidth[level];
        const Box near = ranks > 1 ? cellsInReach(part, reach[level]) : leaves.bounds;
        index[level].forEachIntersecting(near,
          [&](int leaf)
          {
            const Box& box = index[level].box(leaf);
            use.held += cellsIn(scaled(intersection(box, near), 2), width);
            const Box own = intersection(scaled(box, 2), part);
            if (!own.empty())
            {
              const double cells = cellsIn(own, width);
              use.drawn += cells;
              use.samples += cells * samplesOf.of(own, width);
            }
          });
      }
      ++filled;
      greatest = { std::max(greatest.drawn, use.drawn), std::max(greatest.held, use.held),
        std::max(greatest.samples, use.samples) };
      sum = { sum.drawn + use.drawn, sum.held + use.held, sum.samples + use.samples };
    }
    const double others = 1.0 - 1.0 / ranks;
    const double received = 4.0 * greatest.held * others;
    const double pixels = static_cast<double>(size[0]) * size[1];
    const double rounds = std::ceil(std::log2(ranks));
    std::printf(
      "\"%s\",%.0f,%.0f,%d,%d,%.0f,%.0f,%.0f,%.0f,%.4g,%.4g,%.4g,%.4g,%.4g,%.3g,%.3g,%.3g,"
      "%.3g,%.3g\n",
      model.name.c_str(), static_cast<double>(leaves.cells), blocks, ranks, filled, greatest.drawn,
      sum.drawn / filled, greatest.held, sum.held / filled, received,
      HostBytesPerCell * greatest.held + BytesPerBlock * blocks, DeviceBytesPerCell * greatest.held,
      greatest.samples, sum.samples / filled, cut.wall.front(),
      received / BytesPerSecond + ranks * others * SecondsPerMessage,
      greatest.held / CellsPerSecond, greatest.samples * SecondsPerSample,
      2.0 * others * pixels * BytesPerPixel / BytesPerSecond + rounds * SecondsPerMessage);
    std::fflush(stdout);
  }
}
}
}
