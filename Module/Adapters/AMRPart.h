// SPDX-License-Identifier: BSD-3-Clause
// What an AMR that is one process's part of a larger one tells of the whole, in its field data:
// which box of it is this process's to draw, and the ranges of its arrays.
#ifndef ExaBricksAdaptersAMRPart_h
#define ExaBricksAdaptersAMRPart_h

#include "Core/Hierarchy.h"
#include "Core/Range.h"

#include <optional>
#include <string>
#include <vector>

class vtkOverlappingAMR;

namespace exabricks
{
/// Ranges of an array's components; of several, their magnitude follows.
using ArrayRanges = std::vector<Range>;

struct AMRPart
{
  Box box; // in half cells of the AMR's last level; empty: nothing is to be drawn
  std::shared_ptr<const WholeHierarchy> whole; // with the AMR's numbers of levels
};
void markPart(vtkOverlappingAMR* amr, const AMRPart& part);
bool isPart(vtkOverlappingAMR* amr);
/// None: the AMR is no part.
std::optional<AMRPart> findPart(vtkOverlappingAMR* amr);

void setWholeRanges(vtkOverlappingAMR* amr, const std::string& array, const ArrayRanges& ranges);
/// `component`: -1: the magnitude. None: it is not known, or empty.
std::optional<Range> findWholeRange(
  vtkOverlappingAMR* amr, const std::string& array, int component);
}

#endif
