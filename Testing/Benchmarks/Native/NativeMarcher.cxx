// SPDX-License-Identifier: BSD-3-Clause
#include "NativeMarcher.h"

#include "NativeField.h"
#include "NativeTransfer.h"

#include <atomic>
#include <stdexcept>
#include <thread>

namespace exabricks
{
namespace benchmarks
{
using namespace native;

namespace
{
constexpr int RowsOfTile = 8;

// A node that the ray still has to enter, and where it leaves it.
struct Pending
{
  std::uint32_t node;
  float exit;
};

// Of pending nodes at most: one for each split on the way down.
std::size_t depthOf(const std::vector<layout::KdNode>& nodes)
{
  std::vector<std::size_t> depths(nodes.size(), 0);
  std::size_t greatest = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    greatest = std::max(greatest, depths[i]);
    if ((nodes[i].link & 3u) != layout::KD_LEAF)
    {
      // Children come behind their parents.
      depths[nodes[i].link >> 2] = depths[(nodes[i].link >> 2) + 1] = depths[i] + 1;
    }
  }
  return greatest;
}
}

struct NativeMarcher::Internals
{
  glm::ivec3 size{ 0 };
  std::vector<std::uint32_t> brickLists; // with LAST_BRICK, as on the device
  std::vector<layout::KdNode> nodes;
  std::size_t depth = 0;
  std::vector<float> values;
  std::vector<BrickRecord> bricks;
  TransferTable table;

  Internals(const Volume& volume, const TransferFunction& transfer)
    : size(volume.structure->tree.size)
    , brickLists(volume.structure->tree.brickLists)
    , nodes(selectActiveRegions(volume, transfer).nodes)
    , depth(depthOf(nodes))
    , values(volume.values->normalized)
    , table(transfer)
  {
    if (volume.values->absentCells > 0 || volume.values->layer != 0)
    {
      throw std::invalid_argument("expected a volume without absent cells, and without a layer "
                                  "around its bricks; give this one to VolumeRenderer");
    }
    for (const layout::Region& region : volume.structure->tree.regions)
    {
      if (region.brickCount > 0)
      {
        this->brickLists[region.firstBrick + region.brickCount - 1] |= layout::LAST_BRICK;
      }
    }
    this->values.push_back(0.0f);
    const Structure& structure = *volume.structure;
    this->bricks.reserve(structure.bricks.size());
    for (std::size_t b = 0; b < structure.bricks.size(); ++b)
    {
      const Brick& brick = structure.bricks[b];
      const glm::ivec3 lo((brick.lo - structure.tree.bounds.lo) * std::int64_t(2));
      const auto width = static_cast<int>(structure.width(brick));
      const float* first = this->values.data() + volume.values->firstValue[b];
      this->bricks.push_back(makeRecord(brick, lo, width, first));
    }
  }
};

namespace
{
// One thread's work. Counting is compiled out of what is timed.
template <bool Counting, typename Scene>
class Marcher
{
public:
  NativeMarcher::Counts counts;

  Marcher(const Scene& scene, const View& view)
    : Subject(scene)
    , Frame(view)
    , Function{ scene.table.bins.data(), scene.table.knots.data(), scene.table.integralUnit,
      1.0f / scene.table.integralUnit }
    , StepScale(static_cast<float>(view.quality.stepScale))
    , InverseUnit(static_cast<float>(1.0 / view.opacityUnitDistance))
    , TerminationOpacity(static_cast<float>(view.quality.terminationOpacity))
    , Stack(scene.depth + 1)
  {
  }

  Vec4 march(int x, int y)
  {
    March march;
    Ray ray;
    double skip = 0.0;
    if (!makeRay(this->Frame, this->Subject.size, x, y, skip, ray))
    {
      return march.color;
    }
    this->Count(this->counts.rays);
    Pending* top = this->Stack.data();
    *top++ = { 0, ray.end };
    float exit = ray.begin;
    while (exit < ray.end)
    {
      if (exit > RebaseDistance)
      {
        skip += static_cast<double>(beforeRounding(exit));
        if (!makeRay(this->Frame, this->Subject.size, x, y, skip, ray))
        {
          break;
        }
        exit = ray.begin;
        march.exit = -1.0f; // distances count anew
        top = this->Stack.data();
        *top++ = { 0, ray.end };
      }
      const float entry = exit;
      const layout::KdNode leaf = this->Locate(ray, entry, top, exit);
      if (leaf.link >> 2 == layout::KD_NO_REGION)
      {
        continue;
      }
      this->EnterRegion(leaf.link >> 2, load<float>(leaf.plane), ray, entry, exit, march);
      for (; march.intervals > 0; --march.intervals)
      {
        this->MarchInterval(ray, march);
        if (march.color[3] >= this->TerminationOpacity)
        {
          return march.color;
        }
      }
    }
    return march.color;
  }

private:
  struct March
  {
    const BrickRecord* brick = nullptr;    // the first of the region's: most regions have one alone
    Vec4 offset = broadcast(0.0f);         // of the ray's base in it
    const std::uint32_t* others = nullptr; // place of the rest in the lists; null: there are none
    float entry = 0.0f;                    // distance at which the next interval begins
    float exit = -1.0f;                    // distance at which the ray leaves the region
    std::uint32_t intervals = 0;
    float interval = 0.0f;
    bool halved = false;          // by a sample in its middle
    TransferPoint last;           // that at `entry`
    Vec4 color = broadcast(0.0f); // premultiplied
  };

  void Count(std::uint64_t& what, std::uint64_t by = 1)
  {
    if constexpr (Counting)
    {
      what += by;
    }
  }

  // The leaf that holds the ray just behind `distance`, and where the ray leaves it.
  layout::KdNode Locate(const Ray& ray, float distance, Pending*& top, float& exit)
  {
    const layout::KdNode* nodes = this->Subject.nodes.data();
    --top;
    exit = top->exit;
    layout::KdNode node = nodes[top->node];
    while ((node.link & 3u) != layout::KD_LEAF)
    {
      this->Count(this->counts.treeSteps);
      const std::uint32_t axis = node.link & 3u;
      const float plane = planeDistance(ray, node.plane, axis);
      const std::uint32_t lower = node.link >> 2;
      // The lower child comes first for a ray that goes up.
      const std::uint32_t down = ray.inverse[axis] < 0.0f;
      std::uint32_t next = lower + (1u - down);
      if (plane > distance)
      {
        if (plane < exit)
        {
          *top++ = { next, exit };
          exit = plane;
        }
        next = lower + down;
      }
      node = nodes[next];
    }
    return node;
  }

  // `step`: as in ActiveBox. No cell is absent here.
  void EnterRegion(
    std::uint32_t firstBrick, float step, const Ray& ray, float entry, float exit, March& march)
  {
    this->Count(this->counts.regions);
    march.others = this->Subject.brickLists.data() + firstBrick;
    march.brick = &nextBrick(this->Subject.bricks.data(), march.others);
    march.offset = offsetOf(*march.brick, ray);
    // Samples at most stepScale cells of the finest brick apart, two to an interval, unless one
    // alone does for the region.
    const float interval = 2.0f * this->StepScale * step;
    const float length = exit - entry;
    const float count = std::max(std::ceil(length / interval), 1.0f);
    march.halved = length > 0.5f * interval;
    march.interval = length / count;
    march.intervals = static_cast<std::uint32_t>(count);
    // The field is continuous: the last point of the region before is the first of this one.
    const bool known = march.exit == entry;
    march.entry = entry;
    march.exit = exit;
    if (!known)
    {
      const float value = this->Sample(ray, march, entry);
      march.last = makePoint(this->Function, findPart(this->Function, value), value);
    }
  }

  float Sample(const Ray& ray, const March& march, float distance)
  {
    this->Count(this->counts.samples);
    this->Count(this->counts.bricks);
    const BrickRecord* bricks = this->Subject.bricks.data();
    if constexpr (Counting)
    {
      for (const std::uint32_t* place = march.others; place; nextBrick(bricks, place))
      {
        ++this->counts.bricks;
      }
    }
    return sampleBasis(bricks, *march.brick, march.offset, march.others, ray, distance);
  }

  // The next interval, over which the value goes evenly from the last point to the sample in the
  // middle and on to the next point.
  void MarchInterval(const Ray& ray, March& march)
  {
    const float end = march.intervals == 1 ? march.exit : march.entry + march.interval;
    const float length = end - march.entry;
    const float perLength = ray.dataPerHalfCell * this->InverseUnit;
    if (march.halved)
    {
      float middle = this->Sample(ray, march, march.entry + 0.5f * length);
      const float value = this->Sample(ray, march, end);
      // The middle that gives the halves together the mean of the parabola through all three
      // (Simpson's rule); but no value that lies beyond them, which the field may not take.
      const float last = march.last.value;
      middle = std::min(std::max((4.0f * middle - 0.5f * (last + value)) / 3.0f,
                          std::min(middle, std::min(last, value))),
        std::max(middle, std::max(last, value)));
      this->AbsorbTo(middle, 0.5f * length * perLength, march);
      this->AbsorbTo(value, 0.5f * length * perLength, march);
    }
    else
    {
      this->AbsorbTo(this->Sample(ray, march, end), length * perLength, march);
    }
    march.entry = end;
  }

  void AbsorbTo(float value, float units, March& march)
  {
    this->Count(this->counts.intervals);
    const TransferPart part = findPart(this->Function, value);
    const TransferPoint point = makePoint(this->Function, part, value);
    march.color +=
      (1.0f - march.color[3]) * absorbBetween(this->Function, march.last, point, part, units);
    march.last = point;
  }

  const Scene& Subject;
  const View& Frame;
  const Transfer Function;
  const float StepScale;
  const float InverseUnit;
  const float TerminationOpacity;
  std::vector<Pending> Stack;
};

void checkView(const View& view)
{
  if (view.quality.reconstruction != Reconstruction::Basis)
  {
    throw std::invalid_argument("expected a view of the basis reconstruction, the only one here");
  }
}
}

NativeMarcher::NativeMarcher(const Volume& volume, const TransferFunction& transfer)
  : Data(new Internals(volume, transfer))
{
}

NativeMarcher::~NativeMarcher() = default;

void NativeMarcher::render(const View& view, int threads, std::vector<glm::vec4>& picture) const
{
  checkView(view);
  picture.assign(static_cast<std::size_t>(view.target.width) * view.target.height, glm::vec4(0.0f));
  if (this->Data->nodes.empty())
  {
    return;
  }
  std::atomic<int> next{ 0 };
  const auto work = [&]
  {
    Marcher<false, Internals> marcher(*this->Data, view);
    for (int first; (first = next.fetch_add(RowsOfTile)) < view.target.height;)
    {
      for (int y = first; y < std::min(first + RowsOfTile, view.target.height); ++y)
      {
        for (int x = 0; x < view.target.width; ++x)
        {
          picture[static_cast<std::size_t>(y) * view.target.width + x] =
            load<glm::vec4>(marcher.march(x, y));
        }
      }
    }
  };
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i)
  {
    others.emplace_back(work);
  }
  work();
  for (std::thread& other : others)
  {
    other.join();
  }
}

NativeMarcher::Counts NativeMarcher::count(const View& view) const
{
  checkView(view);
  Marcher<true, Internals> marcher(*this->Data, view);
  for (int y = 0; y < view.target.height && !this->Data->nodes.empty(); ++y)
  {
    for (int x = 0; x < view.target.width; ++x)
    {
      marcher.march(x, y);
    }
  }
  return marcher.counts;
}
}
}
