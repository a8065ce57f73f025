// SPDX-License-Identifier: BSD-3-Clause
#include "Core/ActiveRegions.h"

namespace exabricks
{
namespace
{
class Pruner
{
public:
  Pruner(const RegionTree& tree, const std::vector<unsigned char>& active)
    : Tree(tree)
    , Active(active)
  {
    this->Nodes.resize(1);
    const layout::KdNode root = this->Prune(0);
    this->Nodes[0] = root;
  }

  std::vector<layout::KdNode> take() { return std::move(this->Nodes); }

private:
  static constexpr layout::KdNode Nothing{ 0, 4 * layout::KD_NO_REGION + layout::KD_LEAF };

  // The node's pruned copy; its children are appended, adjacent, unless both are empty.
  layout::KdNode Prune(std::size_t n)
  {
    const layout::KdNode& node = this->Tree.nodes[n];
    const std::uint32_t index = node.link >> 2;
    if ((node.link & 3) == layout::KD_LEAF)
    {
      return this->Active[index] ? node : Nothing;
    }
    const std::size_t place = this->Nodes.size();
    this->Nodes.resize(place + 2);
    const layout::KdNode lower = this->Prune(index);
    const layout::KdNode upper = this->Prune(index + 1);
    if (lower.link == Nothing.link && upper.link == Nothing.link)
    {
      this->Nodes.resize(place);
      return Nothing;
    }
    this->Nodes[place] = lower;
    this->Nodes[place + 1] = upper;
    return { node.plane, static_cast<std::uint32_t>(4 * place) + (node.link & 3) };
  }

  const RegionTree& Tree;
  const std::vector<unsigned char>& Active;
  std::vector<layout::KdNode> Nodes;
};
}

ActiveRegions selectActiveRegions(
  const RegionTree& tree, const std::vector<ValueRange>& ranges, const TransferFunction& transfer)
{
  ActiveRegions result;
  std::vector<unsigned char> active(tree.regions.size());
  for (std::size_t r = 0; r < active.size(); ++r)
  {
    active[r] = tree.regions[r].brickCount > 0 && transfer.visible(ranges[r]);
    if (active[r])
    {
      result.regions.push_back(static_cast<std::uint32_t>(r));
    }
  }
  if (!tree.nodes.empty())
  {
    result.nodes = Pruner(tree, active).take();
  }
  return result;
}

void sortByMedianSplits(const RegionTree& tree, std::vector<std::uint32_t>& regions)
{
  const auto center = [&](std::uint32_t r, int axis)
  { return std::int64_t(tree.regions[r].lo[axis]) + tree.regions[r].hi[axis]; };
  std::vector<std::pair<std::size_t, std::size_t>> ranges{ { 0, regions.size() } };
  while (!ranges.empty())
  {
    const auto range = ranges.back();
    ranges.pop_back();
    if (range.second - range.first < 3)
    {
      continue;
    }
    Int3 lo(std::numeric_limits<std::int64_t>::max());
    Int3 hi(std::numeric_limits<std::int64_t>::min());
    for (std::size_t i = range.first; i < range.second; ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        lo[axis] = std::min(lo[axis], center(regions[i], axis));
        hi[axis] = std::max(hi[axis], center(regions[i], axis));
      }
    }
    const Int3 size = hi - lo;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t middle = range.first + (range.second - range.first) / 2;
    std::nth_element(regions.begin() + range.first, regions.begin() + middle,
      regions.begin() + range.second,
      [&](std::uint32_t a, std::uint32_t b) { return center(a, axis) < center(b, axis); });
    ranges.emplace_back(range.first, middle);
    ranges.emplace_back(middle, range.second);
  }
}
}
