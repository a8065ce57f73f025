// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/AMRPart.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkOverlappingAMR.h"

namespace exabricks
{
namespace
{
constexpr const char* partName = "ExaBricksPart"; // its box, whether for completing, then the reach
constexpr const char* wholeName = "ExaBricksWhole"; // level and box of each block
constexpr const char* rangesName = "ExaBricksRanges of ";

struct PartArrays
{
  vtkIdTypeArray* numbers;
  vtkIdTypeArray* blocks;

  explicit PartArrays(vtkOverlappingAMR* amr)
    : numbers(vtkIdTypeArray::SafeDownCast(amr->GetFieldData()->GetArray(partName)))
    , blocks(vtkIdTypeArray::SafeDownCast(amr->GetFieldData()->GetArray(wholeName)))
  {
  }
  bool areWhole() const
  {
    return this->numbers && this->numbers->GetNumberOfValues() >= 8 && this->blocks &&
      this->blocks->GetNumberOfComponents() == 7;
  }
};
}

void markPart(vtkOverlappingAMR* amr, const AMRPart& part)
{
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName(partName);
  const auto append = [&](vtkIdTypeArray* array, const Box& box)
  {
    for (const Int3& corner : { box.lo, box.hi })
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        array->InsertNextValue(corner[axis]);
      }
    }
  };
  append(numbers, part.box);
  numbers->InsertNextValue(part.whole->completed);
  for (const std::int64_t reach : part.whole->reach)
  {
    numbers->InsertNextValue(reach);
  }
  amr->GetFieldData()->AddArray(numbers);

  vtkNew<vtkIdTypeArray> blocks;
  blocks->SetName(wholeName);
  blocks->SetNumberOfComponents(7);
  blocks->Allocate(7 * static_cast<vtkIdType>(part.whole->blocks.size()));
  for (const Block& block : part.whole->blocks)
  {
    blocks->InsertNextValue(block.level);
    append(blocks, block.cells);
  }
  amr->GetFieldData()->AddArray(blocks);
}

bool isPart(vtkOverlappingAMR* amr) { return PartArrays(amr).areWhole(); }

std::optional<AMRPart> findPart(vtkOverlappingAMR* amr)
{
  const PartArrays arrays(amr);
  if (!arrays.areWhole())
  {
    return std::nullopt;
  }
  vtkIdTypeArray* numbers = arrays.numbers;
  vtkIdTypeArray* blocks = arrays.blocks;
  const auto boxAt = [](const vtkIdType* at) {
    return Box{ { at[0], at[1], at[2] }, { at[3], at[4], at[5] } };
  };
  AMRPart part;
  part.box = boxAt(numbers->GetPointer(0));
  auto whole = std::make_shared<WholeHierarchy>();
  whole->completed = numbers->GetValue(6) != 0;
  whole->reach.assign(
    numbers->GetPointer(7), numbers->GetPointer(0) + numbers->GetNumberOfValues());
  whole->blocks.reserve(static_cast<std::size_t>(blocks->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < blocks->GetNumberOfTuples(); ++i)
  {
    const vtkIdType* const at = blocks->GetPointer(7 * i);
    whole->blocks.push_back({ static_cast<int>(at[0]), boxAt(at + 1) });
  }
  part.whole = std::move(whole);
  return part;
}

void setWholeRanges(vtkOverlappingAMR* amr, const std::string& array, const ArrayRanges& ranges)
{
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName((rangesName + array).c_str());
  numbers->SetNumberOfComponents(2);
  for (const Range& range : ranges)
  {
    numbers->InsertNextTuple2(range.min, range.max);
  }
  amr->GetFieldData()->AddArray(numbers);
}

std::optional<Range> findWholeRange(vtkOverlappingAMR* amr, const std::string& array, int component)
{
  auto* numbers =
    vtkDoubleArray::SafeDownCast(amr->GetFieldData()->GetArray((rangesName + array).c_str()));
  const vtkIdType tuple = !numbers ? -1
    : component < 0                ? numbers->GetNumberOfTuples() - 1
                                   : component;
  if (tuple < 0 || tuple >= numbers->GetNumberOfTuples())
  {
    return std::nullopt;
  }
  const Range range{ numbers->GetComponent(tuple, 0), numbers->GetComponent(tuple, 1) };
  return range.empty() ? std::nullopt : std::make_optional(range);
}
}
