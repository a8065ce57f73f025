// SPDX-License-Identifier: BSD-3-Clause
// Hands each of several processes its part of an AMR whose blocks they hold in any way, with the
// cells around it that count for what is seen in it. All processes do each step together.
#ifndef ExaBricksAdaptersRedistribution_h
#define ExaBricksAdaptersRedistribution_h

#include "Adapters/AMRPart.h"
#include "Core/Parts.h"

#include "vtkSmartPointer.h"

#include <cstdint>

class vtkMultiProcessController;
class vtkOverlappingAMR;

namespace exabricks
{
class Redistribution
{
public:
  /// Puts this process's part into `output`. `completed`: as for findReach(). Returns, on each
  /// process, what went wrong on any of them, and on which; `output` has no blocks then.
  std::string redistribute(vtkMultiProcessController* controller, vtkOverlappingAMR* input,
    bool completed, vtkOverlappingAMR* output);

  /// Of the last one: the same on all processes.
  const Parts& parts() const { return this->Shared; }
  const Hierarchy& hierarchy() const { return this->Whole; }
  /// How often the structure was gathered and cut: not again as long as it stays the same.
  int structureBuilds() const { return this->StructureBuilds; }
  /// Leaf cells that this process draws, all that it has for that, and bytes that came from others.
  std::uint64_t cellsToDraw() const { return this->CellsToDraw; }
  std::uint64_t cellsHeld() const { return this->CellsHeld; }
  std::uint64_t bytesReceived() const { return this->BytesReceived; }

private:
  // A block of any process.
  struct SharedBlock
  {
    int rank = 0;
    int local = 0; // its number on that process
  };
  // Cells of a block, counted in those of its level.
  struct Piece
  {
    int block = 0;
    Box cells;
  };
  struct ArrayKind
  {
    std::string name;
    int type = 0;
    int components = 0;
  };
  struct LocalBlocks;
  struct Transfers;

  std::string AgreeOnLattice(const LocalBlocks& local);
  std::string GatherBlocks(const LocalBlocks& local, bool completed, bool& changed);
  void FindPieces(bool completed);
  std::vector<Piece> ListPieces(int toRank, int fromRank) const;
  std::string AgreeOnArrays(const LocalBlocks& local);
  std::string CheckArrays(const LocalBlocks& local) const;
  void Exchange(Transfers& transfers);
  void FindRanges(vtkOverlappingAMR* output);
  void MakeOutput(const Transfers& transfers, vtkOverlappingAMR* output);
  std::string Agree(const std::string& fault) const;
  std::uint64_t BytesOfCell(const ArrayKind& kind) const;

  vtkMultiProcessController* Controller = nullptr;
  int Rank = 0;
  int Ranks = 1;

  // The structure, by which pieces are kept while it stays the same.
  std::vector<std::int64_t> Key;
  Hierarchy Whole;
  std::vector<int> AMRLevel;        // of each level of the hierarchy
  std::vector<glm::dvec3> Spacings; // the same
  std::vector<SharedBlock> Blocks;  // of each block of the hierarchy
  LeafBoxes Leaves;
  Parts Shared;
  std::vector<std::vector<std::int64_t>> Reach; // [rank][level]
  std::vector<std::vector<Piece>> Sent;         // [rank], from this one
  std::vector<std::vector<Piece>> Received;     // [rank], to this one
  std::vector<ArrayKind> Arrays;

  int StructureBuilds = 0;
  std::uint64_t CellsToDraw = 0;
  std::uint64_t CellsHeld = 0;
  std::uint64_t BytesReceived = 0;
};
}

#endif
