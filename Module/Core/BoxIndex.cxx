// SPDX-License-Identifier: BSD-3-Clause
#include "Core/BoxIndex.h"

#include <numeric>

namespace exabricks
{
BoxIndex::BoxIndex(std::vector<Box> boxes)
  : Boxes(std::move(boxes))
  , Order(this->Boxes.size())
{
  std::iota(this->Order.begin(), this->Order.end(), 0);
  if (!this->Order.empty())
  {
    this->Build(0, static_cast<int>(this->Order.size()));
  }
}

void BoxIndex::Build(int begin, int end)
{
  constexpr int leafSize = 4;
  Box bounds;
  for (int i = begin; i < end; ++i)
  {
    bounds = unite(bounds, this->Boxes[this->Order[i]]);
  }
  const std::size_t n = this->Nodes.size();
  this->Nodes.push_back({ bounds, begin, end, 0 });
  if (end - begin <= leafSize)
  {
    return;
  }
  const Int3 size = bounds.size();
  const int axis = longestAxis(size);
  const int middle = begin + (end - begin) / 2;
  std::nth_element(this->Order.begin() + begin, this->Order.begin() + middle,
    this->Order.begin() + end,
    [&](int a, int b)
    {
      const Box& first = this->Boxes[a];
      const Box& second = this->Boxes[b];
      return first.lo[axis] + first.hi[axis] < second.lo[axis] + second.hi[axis];
    });
  this->Build(begin, middle);
  this->Nodes[n].upper = static_cast<int>(this->Nodes.size());
  this->Build(middle, end);
}
}
