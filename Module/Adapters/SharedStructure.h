// SPDX-License-Identifier: BSD-3-Clause
// The boxes of an AMR that several processes hold blocks of: which part of it each is to draw, and
// which cells of which blocks it needs for that. All processes find the same.
#ifndef ExaBricksAdaptersSharedStructure_h
#define ExaBricksAdaptersSharedStructure_h

#include "Adapters/AMRInput.h"
#include "Adapters/AMRPart.h"
#include "Adapters/Processes.h"
#include "Core/BoxIndex.h"
#include "Core/Parts.h"

namespace exabricks
{
/// What this process has of the AMR.
struct LocalBlocks
{
  AMRInput input;
  std::vector<int> level; // of each block, in the AMR

  /// `amr`: may be null, or without blocks.
  LocalBlocks(vtkOverlappingAMR* amr, const LevelRange& levels);

  vtkImageData* grid(int block) const { return this->input.grids[static_cast<std::size_t>(block)]; }
};

class SharedStructure
{
public:
  // A block of any process.
  struct Owner
  {
    int rank = 0;
    int local = 0; // its number on that process
  };
  /// Cells of a block, counted in those of its level.
  struct Piece
  {
    int block = 0;
    Box cells;
  };

  /// `completed`: as for findReach(). Returns what went wrong on any process. Nothing is found anew
  /// where the boxes are those of the last time.
  std::string update(const Processes& processes, const LocalBlocks& local, bool completed);
  /// Finds all anew the next time.
  void forget();

  /// No process has any blocks.
  bool empty() const { return this->AMRLevel.empty(); }
  const Hierarchy& hierarchy() const { return this->Whole; }
  const Parts& parts() const { return this->Shared; }
  /// [level of the hierarchy]
  const std::vector<int>& amrLevel() const { return this->AMRLevel; }
  const std::vector<glm::dvec3>& spacing() const { return this->Spacings; }
  /// [block of the hierarchy]
  const std::vector<Owner>& owners() const { return this->Owners; }
  /// [process]: what goes to it from this one, and comes from it. Both list the same, in one order.
  const std::vector<std::vector<Piece>>& sent() const { return this->Sent; }
  const std::vector<std::vector<Piece>>& received() const { return this->Received; }
  /// Of this process.
  AMRPart part() const;
  std::uint64_t leafCells() const { return this->Leaves.cells; }
  std::uint64_t cellsToDraw() const { return this->CellsToDraw; }
  int builds() const { return this->Builds; }

private:
  std::string AgreeOnLattice(const LocalBlocks& local);
  std::string GatherBlocks(
    const LocalBlocks& local, bool completed, std::vector<std::int64_t>& key);
  void TakeBlocks(const std::vector<vtkIdType>& all, const std::vector<vtkIdType>& lengths,
    std::size_t numbersOfBlock);
  void FindPieces(bool completed);
  // The leaf cells that a process's part needs, by level; of partly covered ones none, as which of
  // them count is found anew by the process.
  std::vector<BoxIndex> FindNeeded(int rank) const;
  std::vector<Piece> ListPieces(
    int toRank, const std::vector<BoxIndex>& needed, int fromRank) const;

  Processes Group;
  std::vector<std::int64_t> Key; // all boxes; empty: nothing was found
  Hierarchy Whole;
  std::vector<int> AMRLevel;
  std::vector<glm::dvec3> Spacings;
  std::vector<Owner> Owners;
  LeafBoxes Leaves;
  Parts Shared;
  std::vector<std::vector<std::int64_t>> Reach; // [process][level]
  std::vector<std::vector<Piece>> Sent;
  std::vector<std::vector<Piece>> Received;
  bool Completes = false;
  std::uint64_t CellsToDraw = 0;
  int Builds = 0;
};
}

#endif
