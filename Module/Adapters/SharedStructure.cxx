// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/SharedStructure.h"

#include "Adapters/AMRCompatibility.h"
#include "Adapters/Ghosts.h"

#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace exabricks
{
namespace
{
// Arrays of points do not travel, so that cells at hidden points are marked themselves. The grid
// itself, if no point is hidden.
vtkSmartPointer<vtkImageData> hideCellsOfHiddenPoints(vtkImageData* grid)
{
  const unsigned char* const hidden =
    findGhosts(grid->GetPointData(), grid->GetNumberOfPoints(), vtkDataSetAttributes::HIDDENPOINT);
  if (!hidden)
  {
    return grid;
  }
  const vtkIdType count = grid->GetNumberOfCells();
  const unsigned char* const before = findGhosts(grid->GetCellData(), count, AnyGhost);
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfTuples(count);
  const int* const dimensions = grid->GetDimensions();
  const Int3 points(dimensions[0], dimensions[1], dimensions[2]);
  const HiddenCorners corners(hidden, points);
  const Int3 cells = points - Int3(1);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Int3 cell(i % cells.x, i / cells.x % cells.y, i / (cells.x * cells.y));
    const int mark = (before ? before[i] : 0) |
      (corners.hide(cell) ? static_cast<int>(vtkDataSetAttributes::HIDDENCELL) : 0);
    marks->SetValue(i, static_cast<unsigned char>(mark));
  }
  auto marked = vtkSmartPointer<vtkImageData>::Take(grid->NewInstance());
  marked->ShallowCopy(grid);
  marked->GetCellData()->AddArray(marks);
  return marked;
}
}

LocalBlocks::LocalBlocks(vtkOverlappingAMR* amr, const LevelRange& levels)
{
  bool any = false;
  for (unsigned int l = levels.first; amr && l < amr->GetNumberOfLevels() && l <= levels.last; ++l)
  {
    for (unsigned int i = 0; i < numberOfBlocks(amr, l) && !any; ++i)
    {
      any = getBlock(amr, l, i) != nullptr;
    }
  }
  if (any)
  {
    this->input = readAMR(amr, levels);
    for (vtkSmartPointer<vtkImageData>& grid : this->input.grids)
    {
      grid = hideCellsOfHiddenPoints(grid);
    }
    for (const Block& block : this->input.hierarchy.blocks)
    {
      this->level.push_back(this->input.amrLevel[static_cast<std::size_t>(block.level)]);
    }
  }
}

void SharedStructure::forget()
{
  this->Key.clear();
  this->Whole = {};
  this->AMRLevel.clear();
  this->Spacings.clear();
  this->Owners.clear();
  this->Leaves = {};
  this->Shared = {};
  this->Reach.clear();
  this->Sent.clear();
  this->Received.clear();
  this->CellsToDraw = 0;
}

std::string SharedStructure::update(
  const Processes& processes, const LocalBlocks& local, bool completed)
{
  this->Group = processes;
  std::string fault = this->Group.agree(local.input.fault);
  fault = fault.empty() ? this->AgreeOnLattice(local) : fault;
  std::vector<std::int64_t> key;
  if (fault.empty() && !this->empty())
  {
    fault = this->GatherBlocks(local, completed, key);
    if (fault.empty() && key != this->Key)
    {
      fault = this->Group.agree(guard([&] { this->FindPieces(completed); }));
    }
  }
  if (!fault.empty() || this->empty())
  {
    this->forget();
    return fault;
  }
  this->Key = std::move(key);
  return {};
}

// Sets the levels that any process has blocks of, with their spacing, and the origin.
std::string SharedStructure::AgreeOnLattice(const LocalBlocks& local)
{
  const int own =
    local.level.empty() ? 0 : *std::max_element(local.level.begin(), local.level.end()) + 1;
  int levels = own;
  this->Group.controller->AllReduce(&own, &levels, 1, vtkCommunicator::MAX_OP);
  this->AMRLevel.clear();
  this->Spacings.clear();
  if (levels == 0)
  {
    return {};
  }
  // Of each level its spacing, or 0, and the origin.
  const std::size_t count = 3 * static_cast<std::size_t>(levels + 1);
  std::vector<double> numbers(count, 0.0);
  const Hierarchy& hierarchy = local.input.hierarchy;
  for (std::size_t b = 0; b < local.level.size(); ++b)
  {
    const glm::dvec3 spacing = hierarchy.spacing *
      static_cast<double>(hierarchy.cellWidth[static_cast<std::size_t>(hierarchy.blocks[b].level)]);
    for (int axis = 0; axis < 3; ++axis)
    {
      numbers[static_cast<std::size_t>(3 * local.level[b] + axis)] = spacing[axis];
      numbers[static_cast<std::size_t>(3 * levels + axis)] = hierarchy.origin[axis];
    }
  }
  std::vector<double> all(count * static_cast<std::size_t>(this->Group.count));
  this->Group.controller->AllGather(numbers.data(), all.data(), static_cast<vtkIdType>(count));
  std::vector<int> levelsOf(static_cast<std::size_t>(this->Group.count));
  this->Group.controller->AllGather(&own, levelsOf.data(), 1);

  std::string fault;
  const auto agreed = [&](int triple, bool isSpacing)
  {
    std::optional<glm::dvec3> found;
    for (int rank = 0; rank < this->Group.count; ++rank)
    {
      const double* const at =
        &all[count * static_cast<std::size_t>(rank) + static_cast<std::size_t>(3 * triple)];
      const glm::dvec3 its(at[0], at[1], at[2]);
      const bool has = isSpacing ? its.x > 0.0 : levelsOf[static_cast<std::size_t>(rank)] > 0;
      if (has && !found)
      {
        found = its;
      }
    }
    const double* const mine = &numbers[static_cast<std::size_t>(3 * triple)];
    const bool have = isSpacing ? mine[0] > 0.0 : own > 0;
    for (int axis = 0; axis < 3 && have && fault.empty(); ++axis)
    {
      const double scale = isSpacing ? (*found)[axis] : hierarchy.spacing[axis];
      if (!(std::abs(mine[axis] - (*found)[axis]) <= 1e-3 * scale))
      {
        fault = std::string("expected the same ") +
          (isSpacing ? "spacing of level " + std::to_string(triple) : "origin") +
          " as on the other processes, found " + std::to_string(mine[axis]) + " and " +
          std::to_string((*found)[axis]) + " along axis " + std::to_string(axis) +
          ". Check the reader or filter that made it";
      }
    }
    return found;
  };
  for (int level = 0; level < levels; ++level)
  {
    if (const std::optional<glm::dvec3> spacing = agreed(level, true))
    {
      this->AMRLevel.push_back(level);
      this->Spacings.push_back(*spacing);
    }
  }
  const glm::dvec3 origin = *agreed(levels, false);
  if (fault.empty())
  {
    fault = makeLattice(this->Spacings, this->AMRLevel, origin, this->Whole);
  }
  return this->Group.agree(fault);
}

// Sets the blocks of all processes, each once, and what tells this structure from others.
std::string SharedStructure::GatherBlocks(
  const LocalBlocks& local, bool completed, std::vector<std::int64_t>& key)
{
  constexpr std::size_t numbersOfBlock = 8;
  std::vector<vtkIdType> own;
  std::string fault = guard(
    [&]
    {
      for (std::size_t b = 0; b < local.level.size(); ++b)
      {
        const Box& cells = local.input.hierarchy.blocks[b].cells;
        own.push_back(local.level[b]);
        own.push_back(local.input.numbers[b]);
        for (int axis = 0; axis < 3; ++axis)
        {
          own.push_back(cells.lo[axis]);
          own.push_back(cells.hi[axis]);
        }
      }
    });
  const auto length = static_cast<vtkIdType>(own.size());
  std::vector<vtkIdType> lengths(static_cast<std::size_t>(this->Group.count));
  this->Group.controller->AllGather(&length, lengths.data(), 1);
  std::vector<vtkIdType> offsets(lengths.size(), 0);
  for (std::size_t rank = 1; rank < offsets.size(); ++rank)
  {
    offsets[rank] = offsets[rank - 1] + lengths[rank - 1];
  }
  std::vector<vtkIdType> all;
  fault = fault.empty()
    ? guard([&] { all.resize(static_cast<std::size_t>(offsets.back() + lengths.back())); })
    : fault;
  fault = this->Group.agree(fault);
  if (!fault.empty())
  {
    return fault;
  }
  this->Group.controller->AllGatherV(
    own.data(), all.data(), length, lengths.data(), offsets.data());
  fault = guard(
    [&]
    {
      key.assign(all.begin(), all.end());
      key.insert(key.end(), lengths.begin(), lengths.end());
      key.insert(key.end(), this->Whole.cellWidth.begin(), this->Whole.cellWidth.end());
      key.push_back(completed);
      if (key != this->Key)
      {
        this->TakeBlocks(all, lengths, numbersOfBlock);
      }
    });
  fault = fault.empty() ? findFault(this->Whole) : fault;
  return this->Group.agree(fault);
}

// In the order that they have on one process, by which bricks and regions are made. A block that
// several processes have counts once.
void SharedStructure::TakeBlocks(const std::vector<vtkIdType>& all,
  const std::vector<vtkIdType>& lengths, std::size_t numbersOfBlock)
{
  struct Found
  {
    const vtkIdType* numbers; // level, number in it, box
    Owner owner;
  };
  std::vector<Found> found;
  const vtkIdType* at = all.data();
  for (std::size_t rank = 0; rank < lengths.size(); ++rank)
  {
    const std::size_t blocks = static_cast<std::size_t>(lengths[rank]) / numbersOfBlock;
    for (std::size_t b = 0; b < blocks; ++b, at += numbersOfBlock)
    {
      found.push_back({ at, { static_cast<int>(rank), static_cast<int>(b) } });
    }
  }
  std::stable_sort(found.begin(), found.end(),
    [&](const Found& a, const Found& b)
    {
      return std::lexicographical_compare(
        a.numbers, a.numbers + numbersOfBlock, b.numbers, b.numbers + numbersOfBlock);
    });
  this->Whole.blocks.clear();
  this->Owners.clear();
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const vtkIdType* const block = found[i].numbers;
    if (i > 0 && std::equal(block, block + numbersOfBlock, found[i - 1].numbers))
    {
      continue;
    }
    const auto level = std::lower_bound(this->AMRLevel.begin(), this->AMRLevel.end(), block[0]);
    this->Whole.blocks.push_back({ static_cast<int>(level - this->AMRLevel.begin()),
      { Int3(block[2], block[4], block[6]), Int3(block[3], block[5], block[7]) } });
    this->Owners.push_back(found[i].owner);
  }
}

// Which cells of which blocks go where.
void SharedStructure::FindPieces(bool completed)
{
  ++this->Builds;
  this->Completes = completed;
  this->Leaves = findLeafBoxes(this->Whole);
  this->Shared = cutIntoParts(this->Leaves, buildBricks(this->Leaves, this->Whole.cellWidth),
    this->Whole.cellWidth, this->Group.count);
  this->Reach.clear();
  for (const Box& part : this->Shared.boxes)
  {
    this->Reach.push_back(findReach(this->Leaves, this->Whole.cellWidth, part, completed));
  }
  this->Sent.clear();
  this->Received.clear();
  const std::vector<BoxIndex> own = this->FindNeeded(this->Group.rank);
  for (int rank = 0; rank < this->Group.count; ++rank)
  {
    this->Sent.push_back(this->ListPieces(rank, this->FindNeeded(rank), this->Group.rank));
    this->Received.push_back(this->ListPieces(this->Group.rank, own, rank));
  }
  const Box& part = this->Shared.boxes[static_cast<std::size_t>(this->Group.rank)];
  double cells = 0.0;
  for (const LeafBox& leaf : this->Leaves.boxes)
  {
    const Box common = intersection(scaled(leaf.box, 2), part);
    if (!common.empty())
    {
      const glm::dvec3 size = 0.5 * glm::dvec3(common.size());
      const auto width =
        static_cast<double>(this->Whole.cellWidth[static_cast<std::size_t>(leaf.level)]);
      cells += size.x * size.y * size.z / (width * width * width);
    }
  }
  this->CellsToDraw = static_cast<std::uint64_t>(cells);
}

std::vector<BoxIndex> SharedStructure::FindNeeded(int rank) const
{
  const Box& part = this->Shared.boxes[static_cast<std::size_t>(rank)];
  const std::vector<std::int64_t>& reach = this->Reach[static_cast<std::size_t>(rank)];
  std::vector<std::vector<Box>> ofLevel(this->Whole.cellWidth.size());
  for (const LeafBox& leaf : this->Leaves.boxes)
  {
    const auto level = static_cast<std::size_t>(leaf.level);
    if (!part.empty() && this->Leaves.partlyCoveredBoxes == 0 &&
      leaf.box.intersects(cellsInReach(part, reach[level])))
    {
      ofLevel[level].push_back(leaf.box);
    }
  }
  std::vector<BoxIndex> needed;
  for (std::vector<Box>& boxes : ofLevel)
  {
    needed.emplace_back(std::move(boxes));
  }
  return needed;
}

// In the order of the blocks, so that both processes list the same. Of blocks that coarser cells
// are covered by in part whole cells go, else leaf cells alone.
std::vector<SharedStructure::Piece> SharedStructure::ListPieces(
  int toRank, const std::vector<BoxIndex>& needed, int fromRank) const
{
  std::vector<Piece> pieces;
  const Box& part = this->Shared.boxes[static_cast<std::size_t>(toRank)];
  if (part.empty())
  {
    return pieces;
  }
  const bool whole = this->Leaves.partlyCoveredBoxes > 0;
  const std::vector<std::int64_t>& reach = this->Reach[static_cast<std::size_t>(toRank)];
  std::vector<int> within;
  for (std::size_t b = 0; b < this->Owners.size(); ++b)
  {
    if (this->Owners[b].rank != fromRank)
    {
      continue;
    }
    const int level = this->Whole.blocks[b].level;
    const std::int64_t width = this->Whole.cellWidth[static_cast<std::size_t>(level)];
    const Box wanted = intersection(this->Whole.logicalBox(this->Whole.blocks[b]),
      cellsInReach(part, reach[static_cast<std::size_t>(level)]));
    if (wanted.empty())
    {
      continue;
    }
    if (whole)
    {
      pieces.push_back({ static_cast<int>(b),
        intersection(outwardToCells(wanted, width), this->Whole.blocks[b].cells) });
      continue;
    }
    within.clear();
    const BoxIndex& index = needed[static_cast<std::size_t>(level)];
    index.forEachIntersecting(wanted, [&](int leaf) { within.push_back(leaf); });
    std::sort(within.begin(), within.end());
    for (const int leaf : within)
    {
      pieces.push_back(
        { static_cast<int>(b), outwardToCells(intersection(index.box(leaf), wanted), width) });
    }
  }
  return pieces;
}

AMRPart SharedStructure::part() const
{
  AMRPart part;
  part.box = this->Shared.boxes[static_cast<std::size_t>(this->Group.rank)];
  auto whole = std::make_shared<WholeHierarchy>();
  whole->blocks = this->Whole.blocks;
  for (Block& block : whole->blocks)
  {
    block.level = this->AMRLevel[static_cast<std::size_t>(block.level)];
  }
  whole->reach.assign(static_cast<std::size_t>(this->AMRLevel.back() + 1), 0);
  for (std::size_t level = 0; level < this->AMRLevel.size(); ++level)
  {
    whole->reach[static_cast<std::size_t>(this->AMRLevel[level])] =
      this->Reach[static_cast<std::size_t>(this->Group.rank)][level];
  }
  whole->completed = this->Completes;
  part.whole = std::move(whole);
  return part;
}
}
