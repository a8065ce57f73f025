// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/Redistribution.h"

#include "Adapters/AMRCompatibility.h"

#include "vtkAMRBox.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>
#include <optional>

namespace exabricks
{
namespace
{
// `ranges`: of the components, and of several their magnitude.
void addRanges(vtkDataArray* array, ArrayRanges& ranges)
{
  for (std::size_t k = 0; k < ranges.size(); ++k)
  {
    const int component = static_cast<int>(k);
    double range[2];
    array->GetFiniteRange(range, component < array->GetNumberOfComponents() ? component : -1);
    ranges[k].add(Range{ range[0], range[1] }); // (greatest, least) of no number
  }
}

// The same without cells that are hidden, or that another block has.
void addRangesOfMarked(vtkDataArray* array, vtkDataArray* marks, ArrayRanges& ranges)
{
  constexpr int without = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::DUPLICATECELL;
  const vtkIdType cells = std::min(array->GetNumberOfTuples(), marks->GetNumberOfTuples());
  for (vtkIdType i = 0; i < cells; ++i)
  {
    if ((static_cast<int>(marks->GetComponent(i, 0)) & without) != 0)
    {
      continue;
    }
    double squares = 0.0;
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      const double value = array->GetComponent(i, c);
      squares += value * value;
      if (std::isfinite(value))
      {
        ranges[static_cast<std::size_t>(c)].add(value);
      }
    }
    if (array->GetNumberOfComponents() > 1 && std::isfinite(squares))
    {
      ranges.back().add(std::sqrt(squares));
    }
  }
}

bool isGhosts(const std::string& name) { return name == vtkDataSetAttributes::GhostArrayName(); }
}

std::string Redistribution::redistribute(vtkMultiProcessController* controller,
  vtkOverlappingAMR* input, const LevelRange& levels, bool completed, vtkOverlappingAMR* output)
{
  this->Group = Processes(controller);
  initialize(output, { 0 });
  this->CellsHeld = this->BytesReceived = 0;
  std::optional<LocalBlocks> read;
  std::string fault = this->Group.agree(guard([&] { read.emplace(input, levels); }));
  if (!fault.empty())
  {
    return fault;
  }
  const LocalBlocks& local = *read;
  fault = this->Structure.update(this->Group, local, completed);
  if (!fault.empty() || this->Structure.empty())
  {
    return fault;
  }
  fault = this->AgreeOnArrays(local);
  if (!fault.empty())
  {
    return fault;
  }
  const auto count = static_cast<std::size_t>(this->Group.count);
  std::vector<Bytes> sent(count);
  std::vector<Bytes> received(count);
  fault = this->Group.agree(guard(
    [&]
    {
      for (std::size_t rank = 0; rank < count; ++rank)
      {
        sent[rank] = this->Pack(local, this->Structure.sent()[rank]);
        received[rank].resize(this->BytesOf(this->Structure.received()[rank]));
        this->BytesReceived +=
          static_cast<int>(rank) == this->Group.rank ? 0 : received[rank].size();
      }
    }));
  if (!fault.empty())
  {
    return fault;
  }
  this->Group.exchange(sent, received);
  fault = this->Group.agree(guard([&] { this->MakeOutput(received, output); }));
  if (!fault.empty())
  {
    output->Initialize();
    initialize(output, { 0 });
    return fault;
  }
  this->FindRanges(output);
  return {};
}

std::size_t Redistribution::ArrayKind::bytesOfCell() const
{
  return static_cast<std::size_t>(this->components) *
    static_cast<std::size_t>(vtkDataArray::GetDataTypeSize(this->type));
}

std::size_t Redistribution::BytesOf(const std::vector<SharedStructure::Piece>& pieces) const
{
  std::size_t cells = 0;
  for (const SharedStructure::Piece& piece : pieces)
  {
    cells += static_cast<std::size_t>(piece.cells.volume());
  }
  std::size_t bytes = 0;
  for (const ArrayKind& kind : this->Arrays)
  {
    bytes += cells * kind.bytesOfCell();
  }
  return bytes;
}

Redistribution::Bytes Redistribution::Pack(
  const LocalBlocks& local, const std::vector<SharedStructure::Piece>& pieces) const
{
  Bytes bytes(this->BytesOf(pieces));
  unsigned char* to = bytes.data();
  for (const ArrayKind& kind : this->Arrays)
  {
    const std::size_t bytesOfCell = kind.bytesOfCell();
    for (const SharedStructure::Piece& piece : pieces)
    {
      const int block = this->Structure.owners()[static_cast<std::size_t>(piece.block)].local;
      vtkImageData* const grid = local.grid(block);
      vtkDataArray* const array = grid->GetCellData()->GetArray(kind.name.c_str());
      const Int3 first = local.input.hierarchy.blocks[static_cast<std::size_t>(block)].cells.lo -
        local.input.offsets[static_cast<std::size_t>(block)];
      int points[3];
      grid->GetDimensions(points);
      const Int3 cells(points[0] - 1, points[1] - 1, points[2] - 1);
      const auto* const from =
        array ? static_cast<const unsigned char*>(array->GetVoidPointer(0)) : nullptr;
      if (array && !from)
      {
        throw std::bad_alloc(); // an array of another layout is copied
      }
      const std::size_t length = static_cast<std::size_t>(piece.cells.size().x) * bytesOfCell;
      for (std::int64_t z = piece.cells.lo.z; z < piece.cells.hi.z; ++z)
      {
        for (std::int64_t y = piece.cells.lo.y; y < piece.cells.hi.y; ++y, to += length)
        {
          const Int3 at = Int3(piece.cells.lo.x, y, z) - first;
          const auto cell = static_cast<std::size_t>(at.x + cells.x * (at.y + cells.y * at.z));
          if (from)
          {
            std::memcpy(to, from + cell * bytesOfCell, length);
          }
          else
          {
            std::memset(to, 0, length); // no ghosts here
          }
        }
      }
    }
  }
  return bytes;
}

// Sets the arrays of cells, which every block has on every process, and marks of ghosts, if any
// has.
std::string Redistribution::AgreeOnArrays(const LocalBlocks& local)
{
  const bool has = !local.level.empty();
  const int candidate = has ? this->Group.rank : this->Group.count;
  int first = candidate;
  this->Group.controller->AllReduce(&candidate, &first, 1, vtkCommunicator::MIN_OP);
  int ghosts = 0;
  for (std::size_t b = 0; b < local.level.size(); ++b)
  {
    ghosts |= local.grid(static_cast<int>(b))
                ->GetCellData()
                ->HasArray(vtkDataSetAttributes::GhostArrayName());
  }
  int anyGhosts = 0;
  this->Group.controller->AllReduce(&ghosts, &anyGhosts, 1, vtkCommunicator::MAX_OP);
  this->Arrays.clear();
  vtkMultiProcessStream stream;
  if (first == this->Group.rank)
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
    vtkDataArray* const active = cells->GetScalars();
    this->ActiveScalars = active && active->GetName() ? active->GetName() : "";
    stream << this->ActiveScalars << static_cast<int>(this->Arrays.size());
    for (const ArrayKind& kind : this->Arrays)
    {
      stream << kind.name << kind.type << kind.components;
    }
  }
  this->Group.controller->Broadcast(stream, first);
  if (first != this->Group.rank)
  {
    int count = 0;
    stream >> this->ActiveScalars >> count;
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
  // Those that all blocks have travel; without any, what this process lacks is said.
  std::vector<int> own(this->Arrays.size(), 1);
  std::string lacking;
  for (std::size_t k = 0; k < this->Arrays.size(); ++k)
  {
    const std::string fault = this->CheckArray(local, this->Arrays[k]);
    own[k] = fault.empty();
    lacking = lacking.empty() ? fault : lacking;
  }
  std::vector<int> all(own.size(), 1);
  this->Group.controller->AllReduce(
    own.data(), all.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::MIN_OP);
  std::vector<ArrayKind> common;
  for (std::size_t k = 0; k < all.size(); ++k)
  {
    if (all[k] != 0)
    {
      common.push_back(this->Arrays[k]);
    }
  }
  const bool none = common.empty() || (common.size() == 1 && isGhosts(common.front().name));
  const std::string fault = this->Group.agree(none ? lacking : "");
  this->Arrays = std::move(common);
  return fault;
}

std::string Redistribution::CheckArray(const LocalBlocks& local, const ArrayKind& kind)
{
  for (std::size_t b = 0; b < local.level.size(); ++b)
  {
    vtkImageData* const grid = local.grid(static_cast<int>(b));
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

// In the order of the blocks, whichever process they come from: where blocks of a level overlap, it
// decides which one counts.
void Redistribution::MakeOutput(const std::vector<Bytes>& received, vtkOverlappingAMR* output)
{
  struct Place
  {
    const SharedStructure::Piece* piece;
    std::size_t rank;
    std::size_t before; // cells of the pieces before it
  };
  std::vector<Place> places;
  std::vector<std::size_t> cellsFrom(this->Structure.received().size(), 0);
  for (std::size_t rank = 0; rank < this->Structure.received().size(); ++rank)
  {
    for (const SharedStructure::Piece& piece : this->Structure.received()[rank])
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
    return this->Structure.amrLevel()[static_cast<std::size_t>(
      this->Structure.hierarchy().blocks[static_cast<std::size_t>(place.piece->block)].level)];
  };
  std::vector<int> blocksPerLevel(
    static_cast<std::size_t>(this->Structure.amrLevel().back() + 1), 0);
  for (const Place& place : places)
  {
    ++blocksPerLevel[static_cast<std::size_t>(amrLevelOf(place))];
  }
  initialize(output, blocksPerLevel);
  output->SetOrigin(&this->Structure.hierarchy().origin.x);
  for (std::size_t level = 0; level < this->Structure.amrLevel().size(); ++level)
  {
    output->SetSpacing(static_cast<unsigned int>(this->Structure.amrLevel()[level]),
      &this->Structure.spacing()[level].x);
  }
  std::vector<unsigned int> next(blocksPerLevel.size(), 0);
  for (const Place& place : places)
  {
    const Box& cells = place.piece->cells;
    const auto level = static_cast<std::size_t>(amrLevelOf(place));
    const glm::dvec3& spacing = this->Structure.spacing()[static_cast<std::size_t>(
      this->Structure.hierarchy().blocks[static_cast<std::size_t>(place.piece->block)].level)];
    const glm::dvec3 corner = this->Structure.hierarchy().origin + spacing * glm::dvec3(cells.lo);
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
      const std::size_t bytesOfCell = kind.bytesOfCell();
      const auto array =
        vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(kind.type));
      array->SetName(kind.name.c_str());
      array->SetNumberOfComponents(kind.components);
      array->SetNumberOfTuples(static_cast<vtkIdType>(count));
      std::memcpy(array->GetVoidPointer(0),
        received[place.rank].data() + arrayBegin + place.before * bytesOfCell, count * bytesOfCell);
      grid->GetCellData()->AddArray(array);
      arrayBegin += cellsFrom[place.rank] * bytesOfCell;
    }
    if (!this->ActiveScalars.empty())
    {
      grid->GetCellData()->SetActiveScalars(this->ActiveScalars.c_str());
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
  markPart(output, this->Structure.part());
}

// Of the arrays on all processes: of cells that are there and whose value is a number.
void Redistribution::FindRanges(vtkOverlappingAMR* output) const
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
        marks ? addRangesOfMarked(array, marks, ranges[k]) : addRanges(array, ranges[k]);
      }
    });

  // In one message: least values, and greatest ones below 0.
  std::vector<double> own;
  for (const ArrayRanges& ofArray : ranges)
  {
    for (const Range& range : ofArray)
    {
      own.push_back(range.min);
      own.push_back(-range.max);
    }
  }
  std::vector<double> all(own.size());
  this->Group.controller->AllReduce(
    own.data(), all.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::MIN_OP);
  std::size_t next = 0;
  for (std::size_t k = 0; k < ranges.size(); ++k)
  {
    for (Range& range : ranges[k])
    {
      range.min = all[next++];
      range.max = -all[next++];
    }
    setWholeRanges(output, this->Arrays[k].name, ranges[k]);
  }
}
}
