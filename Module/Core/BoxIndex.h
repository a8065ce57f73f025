// SPDX-License-Identifier: BSD-3-Clause
// Finds the boxes of a fixed set that intersect a given box: a bounding volume hierarchy by median
// splits.
#ifndef ExaBricksCoreBoxIndex_h
#define ExaBricksCoreBoxIndex_h

#include "Core/Box.h"

#include <vector>

namespace exabricks
{
class BoxIndex
{
public:
  BoxIndex() = default;
  explicit BoxIndex(std::vector<Box> boxes);

  /// Calls `visit(i)` for every box i that intersects `box`, in no particular order.
  template <typename Visitor>
  void forEachIntersecting(const Box& box, Visitor&& visit) const
  {
    if (!this->Nodes.empty())
    {
      this->Visit(0, box, visit);
    }
  }

  const Box& box(int i) const { return this->Boxes[i]; }
  std::size_t size() const { return this->Boxes.size(); }

private:
  struct Node
  {
    Box bounds;
    int begin, end; // its boxes are those from Order[begin] up to Order[end]
    int upper;      // index of the upper child, 0 for a leaf; the lower child follows its parent
  };

  template <typename Visitor>
  void Visit(int n, const Box& box, Visitor&& visit) const
  {
    const Node& node = this->Nodes[n];
    if (!node.bounds.intersects(box))
    {
      return;
    }
    if (node.upper)
    {
      this->Visit(n + 1, box, visit);
      this->Visit(node.upper, box, visit);
      return;
    }
    for (int i = node.begin; i < node.end; ++i)
    {
      if (this->Boxes[this->Order[i]].intersects(box))
      {
        visit(this->Order[i]);
      }
    }
  }

  void Build(int begin, int end);

  std::vector<Box> Boxes;
  std::vector<int> Order;
  std::vector<Node> Nodes;
};
}

#endif
