// SPDX-License-Identifier: BSD-3-Clause
// Hands each of several processes its part of an AMR whose blocks they hold in any way, with the
// cells around it that count for what is seen in it. All processes do each step together.
#ifndef ExaBricksAdaptersRedistribution_h
#define ExaBricksAdaptersRedistribution_h

#include "Adapters/SharedStructure.h"

namespace exabricks
{
class Redistribution
{
public:
  /// Puts this process's part into `output`. `completed`: as for findReach(). Returns, on each
  /// process, what went wrong on any of them, and on which; `output` has no blocks then.
  std::string redistribute(vtkMultiProcessController* controller, vtkOverlappingAMR* input,
    const LevelRange& levels, bool completed, vtkOverlappingAMR* output);

  /// Of the last one: the same on all processes.
  const SharedStructure& structure() const { return this->Structure; }
  /// Cells that this process has now, and bytes that came from others.
  std::uint64_t cellsHeld() const { return this->CellsHeld; }
  std::uint64_t bytesReceived() const { return this->BytesReceived; }

private:
  struct ArrayKind
  {
    std::string name;
    int type = 0;
    int components = 0;

    std::size_t bytesOfCell() const;
  };
  // The values of pieces, array by array and piece by piece.
  using Bytes = std::vector<unsigned char>;

  std::string AgreeOnArrays(const LocalBlocks& local);
  static std::string CheckArray(const LocalBlocks& local, const ArrayKind& kind);
  std::size_t BytesOf(const std::vector<SharedStructure::Piece>& pieces) const;
  Bytes Pack(const LocalBlocks& local, const std::vector<SharedStructure::Piece>& pieces) const;
  void MakeOutput(const std::vector<Bytes>& received, vtkOverlappingAMR* output);
  void FindRanges(vtkOverlappingAMR* output) const;

  Processes Group;
  SharedStructure Structure;
  std::vector<ArrayKind> Arrays;
  std::string ActiveScalars; // of cells; empty: none are
  std::uint64_t CellsHeld = 0;
  std::uint64_t BytesReceived = 0;
};
}

#endif
