// SPDX-License-Identifier: BSD-3-Clause
// The array by which VTK marks cells and points (vtkGhostType).
#ifndef ExaBricksAdaptersGhosts_h
#define ExaBricksAdaptersGhosts_h

#include "Core/Box.h"

#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace exabricks
{
constexpr unsigned char AnyGhost = 0xff; // of any kind

/// vtkGhostType of each cell or point; null, if none is of this kind.
inline const unsigned char* findGhosts(vtkFieldData* data, vtkIdType count, unsigned char kind)
{
  auto* ghosts =
    vtkUnsignedCharArray::SafeDownCast(data->GetArray(vtkDataSetAttributes::GhostArrayName()));
  const unsigned char* first =
    ghosts && ghosts->GetNumberOfValues() == count ? ghosts->GetPointer(0) : nullptr;
  return first &&
      std::any_of(first, first + count, [kind](unsigned char ghost) { return ghost & kind; })
    ? first
    : nullptr;
}

/// As vtkUniformGrid::IsCellVisible() has it: a cell shows if all of its points do.
class HiddenCorners
{
public:
  /// `pointGhosts`: vtkGhostType of each point. `points`: of the grid along each axis.
  HiddenCorners(const unsigned char* pointGhosts, const Int3& points)
    : PointGhosts(pointGhosts)
    , Points(points)
    , Corners{ 0, 1, points.x, points.x + 1, points.x * points.y, points.x * points.y + 1,
      points.x * (points.y + 1), points.x * (points.y + 1) + 1 }
  {
  }

  /// `cell`: of the grid.
  bool hide(const Int3& cell) const
  {
    const unsigned char* const lowest =
      this->PointGhosts + (cell.x + this->Points.x * (cell.y + this->Points.y * cell.z));
    return std::any_of(this->Corners.begin(), this->Corners.end(),
      [lowest](std::int64_t corner) { return lowest[corner] & vtkDataSetAttributes::HIDDENPOINT; });
  }

private:
  const unsigned char* const PointGhosts;
  const Int3 Points;
  const std::array<std::int64_t, 8> Corners;
};
}

#endif
