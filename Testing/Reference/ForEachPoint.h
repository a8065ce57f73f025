// SPDX-License-Identifier: BSD-3-Clause
#ifndef ExaBricksReferenceForEachPoint_h
#define ExaBricksReferenceForEachPoint_h

#include "Core/Box.h"

namespace exabricks
{
namespace reference
{
/// Calls visit(p) for the lattice points, or cells, of a box; x runs fastest.
template <typename Visitor>
void forEachPoint(const Box& box, const Visitor& visit)
{
  Int3 p;
  for (p.z = box.lo.z; p.z < box.hi.z; ++p.z)
  {
    for (p.y = box.lo.y; p.y < box.hi.y; ++p.y)
    {
      for (p.x = box.lo.x; p.x < box.hi.x; ++p.x)
      {
        visit(p);
      }
    }
  }
}
}
}

#endif
