// SPDX-License-Identifier: BSD-3-Clause
// Opens an AMR data set with the reader of VTK that its name asks for.

#ifndef ExaBricksRenderOpenAMR_h
#define ExaBricksRenderOpenAMR_h

#include "vtkOverlappingAMR.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkAlgorithm;

namespace render
{

struct ArrayInfo
{
  std::string Name;
  int Components = 1;
  double Range[2] = { 0.0, 0.0 }; // on the coarsest level, of the magnitude of several components

  // Whether values differ by more than rounding does.
  bool Varies() const;
};

class AMRFile
{
public:
  // Throws Failure(InputUnreadable) if there is nothing that VTK could read.
  explicit AMRFile(const std::string& path);
  ~AMRFile();

  // Class name of the reader.
  const char* ReaderName() const;

  // Cell arrays. Some readers know them beforehand; for the others this reads the coarsest level.
  const std::vector<ArrayInfo>& Arrays() const { return this->CellArrays; }

  // Reads one cell array on the first so many levels (0: on all). Cells in embedded boundaries are
  // hidden, where an array tells which they are.
  vtkSmartPointer<vtkOverlappingAMR> Read(const std::string& array, int levels, bool quiet);

private:
  vtkSmartPointer<vtkOverlappingAMR> Output(const std::string& doing) const;
  void RunReader(const std::function<void()>& work) const;
  void SetLevels(int levels);
  void FindArrays();

  const std::string Path;
  vtkSmartPointer<vtkAlgorithm> Reader;
  std::vector<ArrayInfo> CellArrays;
};

}

#endif
