// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/Redistribution.h"

#include "Adapters/AMRCompatibility.h"
#include "Adapters/AMRInput.h"
#include "Core/BoxIndex.h"

#include "vtkAMRBox.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkStructuredData.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <new>

namespace exabricks
{
namespace
{
constexpr int ValuesTag = 28471;
constexpr vtkIdType LongestMessage = 1 << 28; // bytes

// The partner of a process in a round in which each has at most one: by the circle method of
// tournaments. Itself: it has none.
int partnerIn(int round, int rank, int ranks)
{
  const int even = ranks + ranks % 2;
  const int last = even - 1;
  int partner = rank == last ? round : (2 * round - rank % last + 2 * last) % last;
  partner = rank != last && partner == rank ? last : partner;
  return partner < ranks ? partner : rank;
}

void send(vtkMultiProcessController* controller, const std::vector<unsigned char>& bytes, int to)
{
  const auto size = static_cast<vtkIdType>(bytes.size());
  for (vtkIdType sent = 0; sent < size; sent += LongestMessage)
  {
    controller->Send(bytes.data() + sent, std::min(LongestMessage, size - sent), to, ValuesTag);
  }
}

void receive(vtkMultiProcessController* controller, std::vector<unsigned char>& bytes, int from)
{
  const auto size = static_cast<vtkIdType>(bytes.size());
  for (vtkIdType there = 0; there < size; there += LongestMessage)
  {
    controller->Receive(
      bytes.data() + there, std::min(LongestMessage, size - there), from, ValuesTag);
  }
}

void initialize(vtkOverlappingAMR* amr, const std::vector<int>& blocksPerLevel)
{
#ifdef EXABRICKS_AMR_OF_VTK_9_6
  amr->Initialize(std::vector<unsigned int>(blocksPerLevel.begin(), blocksPerLevel.end()));
  amr->SetGridDescription(vtkStructuredData::VTK_STRUCTURED_XYZ_GRID);
#else
  amr->Initialize(static_cast<int>(blocksPerLevel.size()), blocksPerLevel.data());
  amr->SetGridDescription(VTK_XYZ_GRID);
#endif
}

bool isGhosts(const std::string& name) { return name == vtkDataSetAttributes::GhostArrayName(); }
}

// What this process has of the AMR.
struct Redistribution::LocalBlocks
{
  AMRInput input;
  std::vector<int> level; // of each block, in the AMR

  explicit LocalBlocks(vtkOverlappingAMR* amr)
  {
    if (amr && getFirstBlock(amr))
    {
      this->input = readAMR(amr);
      for (const Block& block : this->input.hierarchy.blocks)
      {
        this->level.push_back(this->input.amrLevel[static_cast<std::size_t>(block.level)]);
      }
    }
  }
  vtkImageData* grid(int block) const { return this->input.grids[static_cast<std::size_t>(block)]; }
};

// The values of the pieces, array by array and piece by piece, as bytes.
struct Redistribution::Transfers
{
  std::vector<std::vector<unsigned char>> sent;     // [rank]
  std::vector<std::vector<unsigned char>> received; // [rank]
};

std::string Redistribution::redistribute(vtkMultiProcessController* controller,
  vtkOverlappingAMR* input, bool completed, vtkOverlappingAMR* output)
{
  this->Controller = controller;
  this->Rank = controller->GetLocalProcessId();
  this->Ranks = controller->GetNumberOfProcesses();
  initialize(output, { 0 });
  const LocalBlocks local(input);
  std::string fault = this->Agree(local.input.fault);
  fault = fault.empty() ? this->AgreeOnLattice(local) : fault;
  if (!fault.empty() || this->AMRLevel.empty())
  {
    return fault;
  }
  bool changed = false;
  fault = this->GatherBlocks(local, completed, changed);
  fault = fault.empty() ? this->AgreeOnArrays(local) : fault;
  if (!fault.empty())
  {
    this->Key.clear();
    return fault;
  }
  Transfers transfers;
  try
  {
    if (changed)
    {
      this->FindPieces(completed);
    }
    const auto bytesOf = [&](const std::vector<Piece>& pieces)
    {
      std::size_t cells = 0;
      for (const Piece& piece : pieces)
      {
        cells += static_cast<std::size_t>(piece.cells.volume());
      }
      std::size_t bytes = 0;
      for (const ArrayKind& kind : this->Arrays)
      {
        bytes += cells * this->BytesOfCell(kind);
      }
      return bytes;
    };
    transfers.sent.resize(static_cast<std::size_t>(this->Ranks));
    transfers.received.resize(static_cast<std::size_t>(this->Ranks));
    this->BytesReceived = 0;
    for (std::size_t rank = 0; rank < transfers.sent.size(); ++rank)
    {
      transfers.received[rank].resize(bytesOf(this->Received[rank]));
      this->BytesReceived +=
        static_cast<int>(rank) == this->Rank ? 0 : transfers.received[rank].size();
      std::vector<unsigned char>& bytes = transfers.sent[rank];
      bytes.resize(bytesOf(this->Sent[rank]));
      unsigned char* to = bytes.data();
      for (const ArrayKind& kind : this->Arrays)
      {
        const std::uint64_t bytesOfCell = this->BytesOfCell(kind);
        for (const Piece& piece : this->Sent[rank])
        {
          const int block = this->Blocks[static_cast<std::size_t>(piece.block)].local;
          vtkImageData* const grid = local.grid(block);
          vtkDataArray* const array = grid->GetCellData()->GetArray(kind.name.c_str());
          const Int3 first =
            local.input.hierarchy.blocks[static_cast<std::size_t>(block)].cells.lo -
            local.input.offsets[static_cast<std::size_t>(block)];
          int points[3];
          grid->GetDimensions(points);
          const Int3 cells(points[0] - 1, points[1] - 1, points[2] - 1);
          const auto* const from =
            array ? static_cast<const unsigned char*>(array->GetVoidPointer(0)) : nullptr;
          const std::size_t length = static_cast<std::size_t>(piece.cells.size().x) * bytesOfCell;
          for (std::int64_t z = piece.cells.lo.z; z < piece.cells.hi.z; ++z)
          {
            for (std::int64_t y = piece.cells.lo.y; y < piece.cells.hi.y; ++y, to += length)
            {
              const Int3 at = Int3(piece.cells.lo.x, y, z) - first;
              if (from)
              {
                std::memcpy(to,
                  from +
                    static_cast<std::size_t>(at.x + cells.x * (at.y + cells.y * at.z)) *
                      bytesOfCell,
                  length);
              }
              else
              {
                std::memset(to, 0, length); // no ghosts here
              }
            }
          }
        }
      }
    }
  }
  catch (const std::bad_alloc&)
  {
    fault = "out of memory for the values of its part";
  }
  fault = this->Agree(fault);
  if (!fault.empty())
  {
    this->Key.clear();
    return fault;
  }
  this->Exchange(transfers);
  try
  {
    this->MakeOutput(transfers, output);
  }
  catch (const std::bad_alloc&)
  {
    fault = "out of memory for the blocks of its part";
  }
  fault = this->Agree(fault);
  if (!fault.empty())
  {
    this->Key.clear();
    output->Initialize();
    initialize(output, { 0 });
    return fault;
  }
  this->FindRanges(output);
  return {};
}

// What the first process that has a fault says of it, on all of them; nothing if none has.
std::string Redistribution::Agree(const std::string& fault) const
{
  const int failed = fault.empty() ? this->Ranks : this->Rank;
  int first = failed;
  this->Controller->AllReduce(&failed, &first, 1, vtkCommunicator::MIN_OP);
  if (first == this->Ranks)
  {
    return {};
  }
  std::string text = fault;
  vtkMultiProcessStream stream;
  if (first == this->Rank)
  {
    stream << text;
  }
  this->Controller->Broadcast(stream, first);
  if (first != this->Rank)
  {
    stream >> text;
  }
  return "process " + std::to_string(first) + " of " + std::to_string(this->Ranks) + ": " + text;
}

// Sets the levels that any process has blocks of, with their spacing, and the origin.
std::string Redistribution::AgreeOnLattice(const LocalBlocks& local)
{
  const int own =
    local.level.empty() ? 0 : *std::max_element(local.level.begin(), local.level.end()) + 1;
  int levels = own;
  this->Controller->AllReduce(&own, &levels, 1, vtkCommunicator::MAX_OP);
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
  std::vector<double> all(count * static_cast<std::size_t>(this->Ranks));
  this->Controller->AllGather(numbers.data(), all.data(), static_cast<vtkIdType>(count));
  std::vector<int> levelsOf(static_cast<std::size_t>(this->Ranks));
  this->Controller->AllGather(&own, levelsOf.data(), 1);

  std::string fault;
  const auto agreed = [&](int triple, bool isSpacing)
  {
    std::optional<glm::dvec3> found;
    for (int rank = 0; rank < this->Ranks; ++rank)
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
  return this->Agree(fault);
}

// Sets the blocks of all processes, each once, and whether their structure is another one than
// before.
std::string Redistribution::GatherBlocks(const LocalBlocks& local, bool completed, bool& changed)
{
  constexpr std::size_t numbersOfBlock = 7;
  std::vector<vtkIdType> own;
  for (std::size_t b = 0; b < local.level.size(); ++b)
  {
    const Box& cells = local.input.hierarchy.blocks[b].cells;
    own.push_back(local.level[b]);
    for (int axis = 0; axis < 3; ++axis)
    {
      own.push_back(cells.lo[axis]);
      own.push_back(cells.hi[axis]);
    }
  }
  const auto length = static_cast<vtkIdType>(own.size());
  std::vector<vtkIdType> lengths(static_cast<std::size_t>(this->Ranks));
  this->Controller->AllGather(&length, lengths.data(), 1);
  std::vector<vtkIdType> offsets(lengths.size(), 0);
  for (std::size_t rank = 1; rank < offsets.size(); ++rank)
  {
    offsets[rank] = offsets[rank - 1] + lengths[rank - 1];
  }
  std::vector<vtkIdType> all(static_cast<std::size_t>(offsets.back() + lengths.back()));
  this->Controller->AllGatherV(own.data(), all.data(), length, lengths.data(), offsets.data());

  std::vector<std::int64_t> key(all.begin(), all.end());
  key.insert(key.end(), lengths.begin(), lengths.end());
  key.insert(key.end(), this->Whole.cellWidth.begin(), this->Whole.cellWidth.end());
  key.push_back(completed);
  changed = key != this->Key;
  if (!changed)
  {
    return {};
  }
  this->Key = std::move(key);
  this->Whole.blocks.clear();
  this->Blocks.clear();
  std::map<std::vector<vtkIdType>, bool> taken; // a block that several processes have counts once
  for (std::size_t rank = 0; rank < lengths.size(); ++rank)
  {
    const std::size_t blocks = static_cast<std::size_t>(lengths[rank]) / numbersOfBlock;
    for (std::size_t b = 0; b < blocks; ++b)
    {
      const vtkIdType* const at =
        &all[static_cast<std::size_t>(offsets[rank]) + b * numbersOfBlock];
      if (!taken.emplace(std::vector<vtkIdType>(at, at + numbersOfBlock), true).second)
      {
        continue;
      }
      const auto level = std::lower_bound(this->AMRLevel.begin(), this->AMRLevel.end(), at[0]);
      this->Whole.blocks.push_back({ static_cast<int>(level - this->AMRLevel.begin()),
        { Int3(at[1], at[3], at[5]), Int3(at[2], at[4], at[6]) } });
      this->Blocks.push_back({ static_cast<int>(rank), static_cast<int>(b) });
    }
  }
  return findFault(this->Whole);
}

// Which cells of which blocks go where.
void Redistribution::FindPieces(bool completed)
{
  ++this->StructureBuilds;
  this->Leaves = findLeafBoxes(this->Whole);
  this->Shared = cutIntoParts(this->Leaves, this->Whole.cellWidth, this->Ranks);
  this->Reach.clear();
  for (const Box& part : this->Shared.boxes)
  {
    this->Reach.push_back(findReach(this->Leaves, this->Whole.cellWidth, part, completed));
  }
  this->Sent.clear();
  this->Received.clear();
  for (int rank = 0; rank < this->Ranks; ++rank)
  {
    this->Sent.push_back(this->ListPieces(rank, this->Rank));
    this->Received.push_back(this->ListPieces(this->Rank, rank));
  }
  const Box& part = this->Shared.boxes[static_cast<std::size_t>(this->Rank)];
  double cells = 0.0;
  for (const LeafBox& leaf : this->Leaves.boxes)
  {
    const Box common = intersection(leaf.box, part);
    if (!common.empty())
    {
      const glm::dvec3 size(common.size());
      const auto width =
        static_cast<double>(this->Whole.cellWidth[static_cast<std::size_t>(leaf.level)]);
      cells += size.x * size.y * size.z / (width * width * width);
    }
  }
  this->CellsToDraw = static_cast<std::uint64_t>(cells);
}

// In the order of the blocks, so that both processes list the same. Of blocks that coarser cells
// are covered by in part whole cells go, as which of them count is found anew; else leaf cells
// alone.
std::vector<Redistribution::Piece> Redistribution::ListPieces(int toRank, int fromRank) const
{
  std::vector<Piece> pieces;
  const Box& part = this->Shared.boxes[static_cast<std::size_t>(toRank)];
  if (part.empty())
  {
    return pieces;
  }
  const bool whole = this->Leaves.partlyCoveredBoxes > 0;
  std::vector<std::vector<Box>> leavesOfLevel(this->Whole.cellWidth.size());
  const std::vector<std::int64_t>& reach = this->Reach[static_cast<std::size_t>(toRank)];
  const auto needed = [&](int level)
  {
    const std::int64_t by = reach[static_cast<std::size_t>(level)];
    return Box{ part.lo - by, part.hi + by };
  };
  for (const LeafBox& leaf : this->Leaves.boxes)
  {
    if (!whole && leaf.box.intersects(needed(leaf.level)))
    {
      leavesOfLevel[static_cast<std::size_t>(leaf.level)].push_back(leaf.box);
    }
  }
  std::vector<BoxIndex> leaves;
  for (std::vector<Box>& boxes : leavesOfLevel)
  {
    leaves.emplace_back(std::move(boxes));
  }
  std::vector<int> within;
  for (std::size_t b = 0; b < this->Blocks.size(); ++b)
  {
    if (this->Blocks[b].rank != fromRank)
    {
      continue;
    }
    const int level = this->Whole.blocks[b].level;
    const std::int64_t width = this->Whole.cellWidth[static_cast<std::size_t>(level)];
    const Box wanted = intersection(this->Whole.logicalBox(this->Whole.blocks[b]), needed(level));
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
    const BoxIndex& index = leaves[static_cast<std::size_t>(level)];
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

std::uint64_t Redistribution::BytesOfCell(const ArrayKind& kind) const
{
  return static_cast<std::uint64_t>(kind.components) *
    static_cast<std::uint64_t>(vtkDataArray::GetDataTypeSize(kind.type));
}

// Sets the arrays of cells, which every block has on every process, and marks of ghosts, if any
// has.
std::string Redistribution::AgreeOnArrays(const LocalBlocks& local)
{
  const bool has = !local.level.empty();
  const int own = has ? this->Rank : this->Ranks;
  int first = own;
  this->Controller->AllReduce(&own, &first, 1, vtkCommunicator::MIN_OP);
  int ghosts = 0;
  for (std::size_t b = 0; b < local.level.size(); ++b)
  {
    ghosts |= local.grid(static_cast<int>(b))
                ->GetCellData()
                ->HasArray(vtkDataSetAttributes::GhostArrayName());
  }
  int anyGhosts = 0;
  this->Controller->AllReduce(&ghosts, &anyGhosts, 1, vtkCommunicator::MAX_OP);
  this->Arrays.clear();
  vtkMultiProcessStream stream;
  if (first == this->Rank)
  {
    vtkCellData* const cells = local.grid(0)->GetCellData();
    for (int i = 0; i < cells->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* const array = cells->GetArray(i);
      if (array && array->GetName() && !isGhosts(array->GetName()))
      {
        this->Arrays.push_back(
          { array->GetName(), array->GetDataType(), array->GetNumberOfComponents() });
      }
    }
    stream << static_cast<int>(this->Arrays.size());
    for (const ArrayKind& kind : this->Arrays)
    {
      stream << kind.name << kind.type << kind.components;
    }
  }
  this->Controller->Broadcast(stream, first);
  if (first != this->Rank)
  {
    int count = 0;
    stream >> count;
    for (int i = 0; i < count; ++i)
    {
      ArrayKind kind;
      stream >> kind.name >> kind.type >> kind.components;
      this->Arrays.push_back(kind);
    }
  }
  if (anyGhosts)
  {
    this->Arrays.push_back({ vtkDataSetAttributes::GhostArrayName(), VTK_UNSIGNED_CHAR, 1 });
  }
  return this->Agree(this->CheckArrays(local));
}

std::string Redistribution::CheckArrays(const LocalBlocks& local) const
{
  for (std::size_t b = 0; b < local.level.size(); ++b)
  {
    vtkImageData* const grid = local.grid(static_cast<int>(b));
    for (const ArrayKind& kind : this->Arrays)
    {
      vtkDataArray* const array = grid->GetCellData()->GetArray(kind.name.c_str());
      const bool fits = array && array->GetDataType() == kind.type &&
        array->GetNumberOfComponents() == kind.components &&
        array->GetNumberOfTuples() == grid->GetNumberOfCells() && kind.type != VTK_BIT;
      if (!fits && !(isGhosts(kind.name) && !array))
      {
        return "expected a cell array '" + kind.name + "' of " + std::to_string(kind.components) +
          " components of type " + vtkImageScalarTypeNameMacro(kind.type) +
          " in every block, found " +
          (array ? std::to_string(array->GetNumberOfComponents()) + " of type " +
                array->GetDataTypeAsString() + " and " +
                std::to_string(array->GetNumberOfTuples()) + " values"
                 : "none") +
          " in one of level " + std::to_string(local.level[b]) +
          ". Check the reader or filter that made it";
      }
    }
  }
  return {};
}

void Redistribution::Exchange(Transfers& transfers)
{
  const auto own = static_cast<std::size_t>(this->Rank);
  transfers.received[own] = std::move(transfers.sent[own]);
  const int rounds = this->Ranks + this->Ranks % 2 - 1;
  for (int round = 0; round < rounds; ++round)
  {
    const int partner = partnerIn(round, this->Rank, this->Ranks);
    if (partner == this->Rank)
    {
      continue;
    }
    auto& sent = transfers.sent[static_cast<std::size_t>(partner)];
    auto& received = transfers.received[static_cast<std::size_t>(partner)];
    if (this->Rank < partner)
    {
      send(this->Controller, sent, partner);
      receive(this->Controller, received, partner);
    }
    else
    {
      receive(this->Controller, received, partner);
      send(this->Controller, sent, partner);
    }
    std::vector<unsigned char>().swap(sent);
  }
}

// In the order of the blocks, whichever process they come from: where blocks of a level overlap, it
// decides which one counts.
void Redistribution::MakeOutput(const Transfers& transfers, vtkOverlappingAMR* output)
{
  struct Place
  {
    const Piece* piece;
    std::size_t rank;
    std::size_t before; // cells of the pieces before it
  };
  std::vector<Place> places;
  std::vector<std::size_t> cellsFrom(this->Received.size(), 0);
  for (std::size_t rank = 0; rank < this->Received.size(); ++rank)
  {
    for (const Piece& piece : this->Received[rank])
    {
      places.push_back({ &piece, rank, cellsFrom[rank] });
      cellsFrom[rank] += static_cast<std::size_t>(piece.cells.volume());
    }
  }
  std::stable_sort(places.begin(), places.end(),
    [](const Place& a, const Place& b) { return a.piece->block < b.piece->block; });
  this->CellsHeld = 0;
  const auto amrLevelOf = [&](const Place& place)
  {
    return this->AMRLevel[static_cast<std::size_t>(
      this->Whole.blocks[static_cast<std::size_t>(place.piece->block)].level)];
  };
  std::vector<int> blocksPerLevel(static_cast<std::size_t>(this->AMRLevel.back() + 1), 0);
  for (const Place& place : places)
  {
    ++blocksPerLevel[static_cast<std::size_t>(amrLevelOf(place))];
  }
  initialize(output, blocksPerLevel);
  output->SetOrigin(&this->Whole.origin.x);
  for (std::size_t level = 0; level < this->AMRLevel.size(); ++level)
  {
    output->SetSpacing(static_cast<unsigned int>(this->AMRLevel[level]), &this->Spacings[level].x);
  }
  std::vector<unsigned int> next(blocksPerLevel.size(), 0);
  for (const Place& place : places)
  {
    const Box& cells = place.piece->cells;
    const auto level = static_cast<std::size_t>(amrLevelOf(place));
    const glm::dvec3& spacing = this->Spacings[static_cast<std::size_t>(
      this->Whole.blocks[static_cast<std::size_t>(place.piece->block)].level)];
    const glm::dvec3 corner = this->Whole.origin + spacing * glm::dvec3(cells.lo);
    const auto count = static_cast<std::size_t>(cells.volume());
    this->CellsHeld += count;
    vtkNew<vtkUniformGrid> grid;
    grid->SetOrigin(&corner.x);
    grid->SetSpacing(&spacing.x);
    const glm::ivec3 points(cells.size() + std::int64_t(1));
    grid->SetDimensions(points.x, points.y, points.z);
    std::size_t arrayBegin = 0;
    for (const ArrayKind& kind : this->Arrays)
    {
      const std::size_t bytesOfCell = this->BytesOfCell(kind);
      const auto array =
        vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(kind.type));
      array->SetName(kind.name.c_str());
      array->SetNumberOfComponents(kind.components);
      array->SetNumberOfTuples(static_cast<vtkIdType>(count));
      std::memcpy(array->GetVoidPointer(0),
        transfers.received[place.rank].data() + arrayBegin + place.before * bytesOfCell,
        count * bytesOfCell);
      grid->GetCellData()->AddArray(array);
      arrayBegin += cellsFrom[place.rank] * bytesOfCell;
    }
    int lo[3];
    int hi[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      lo[axis] = static_cast<int>(cells.lo[axis]);
      hi[axis] = static_cast<int>(cells.hi[axis] - 1);
    }
    const unsigned int number = next[level]++;
    output->SetAMRBox(static_cast<unsigned int>(level), number, vtkAMRBox(lo, hi));
    output->SetDataSet(static_cast<unsigned int>(level), number, grid);
  }
  AMRPart part;
  part.box = scaled(this->Shared.boxes[static_cast<std::size_t>(this->Rank)], 2);
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
      this->Reach[static_cast<std::size_t>(this->Rank)][level];
  }
  part.whole = std::move(whole);
  markPart(output, part);
}

// Of the arrays on all processes: of cells that are there and whose value is a number.
void Redistribution::FindRanges(vtkOverlappingAMR* output)
{
  std::vector<ArrayRanges> ranges;
  for (const ArrayKind& kind : this->Arrays)
  {
    ranges.emplace_back(static_cast<std::size_t>(kind.components + (kind.components > 1)));
  }
  forEachBlock(output,
    [&](vtkDataSet* block)
    {
      vtkDataArray* const marks =
        block->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName());
      for (std::size_t k = 0; k < this->Arrays.size(); ++k)
      {
        vtkDataArray* const array = block->GetCellData()->GetArray(this->Arrays[k].name.c_str());
        for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
        {
          constexpr int without =
            vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::DUPLICATECELL;
          if (marks && (static_cast<int>(marks->GetComponent(i, 0)) & without) != 0)
          {
            continue;
          }
          double squares = 0.0;
          for (int c = 0; c < this->Arrays[k].components; ++c)
          {
            const double value = array->GetComponent(i, c);
            squares += value * value;
            if (std::isfinite(value))
            {
              ranges[k][static_cast<std::size_t>(c)].add(value);
            }
          }
          if (this->Arrays[k].components > 1 && std::isfinite(squares))
          {
            ranges[k].back().add(std::sqrt(squares));
          }
        }
      }
    });
  for (std::size_t k = 0; k < ranges.size(); ++k)
  {
    for (Range& range : ranges[k])
    {
      const Range own = range;
      this->Controller->AllReduce(&own.min, &range.min, 1, vtkCommunicator::MIN_OP);
      this->Controller->AllReduce(&own.max, &range.max, 1, vtkCommunicator::MAX_OP);
    }
    setWholeRanges(output, this->Arrays[k].name, ranges[k]);
  }
}
}
