// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes/MergeCells.h"

#include <algorithm>

namespace exabricks
{
namespace
{
class Marks
{
public:
  Marks(const Int3& size, std::vector<unsigned char>& marks)
    : Size(size)
    , Values(marks)
  {
  }

  unsigned char* row(const Int3& p)
  {
    return &this->Values[p.x + this->Size.x * (p.y + this->Size.y * p.z)];
  }

  // Whether all cells of the box, which is not empty, are marked.
  bool all(const Box& box)
  {
    const std::int64_t n = box.size().x;
    Int3 p = box.lo;
    for (p.z = box.lo.z; p.z < box.hi.z; ++p.z)
    {
      for (p.y = box.lo.y; p.y < box.hi.y; ++p.y)
      {
        const unsigned char* first = this->row(p);
        if (std::find(first, first + n, 0) != first + n)
        {
          return false;
        }
      }
    }
    return true;
  }

  void clear(const Box& box)
  {
    Int3 p = box.lo;
    for (p.z = box.lo.z; p.z < box.hi.z; ++p.z)
    {
      for (p.y = box.lo.y; p.y < box.hi.y; ++p.y)
      {
        std::fill_n(this->row(p), box.size().x, static_cast<unsigned char>(0));
      }
    }
  }

private:
  const Int3 Size;
  std::vector<unsigned char>& Values;
};
}

std::vector<Box> mergeCells(const Box& box, std::vector<unsigned char>& marks, std::int64_t most)
{
  std::vector<Box> merged;
  const Int3 size = box.size();
  Marks cells(size, marks);
  Int3 p;
  for (p.z = 0; p.z < size.z; ++p.z)
  {
    for (p.y = 0; p.y < size.y; ++p.y)
    {
      for (p.x = 0; p.x < size.x; ++p.x)
      {
        if (!*cells.row(p))
        {
          continue;
        }
        Box part{ p, p + std::int64_t(1) };
        for (int axis = 0; axis < 3; ++axis)
        {
          while (part.hi[axis] < size[axis] && part.size()[axis] < most)
          {
            Box next = part;
            next.lo[axis] = part.hi[axis];
            ++next.hi[axis];
            if (!cells.all(next))
            {
              break;
            }
            ++part.hi[axis];
          }
        }
        cells.clear(part);
        merged.push_back({ box.lo + part.lo, box.lo + part.hi });
      }
    }
  }
  return merged;
}
}
