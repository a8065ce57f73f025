// SPDX-License-Identifier: BSD-3-Clause
// Enzo's data sets (3-D): whether the grids that a .hierarchy lists fit together, and fit the
// parameters and the HDF5 files beside it. The format: Enzo, src/enzo/WriteDataHierarchy.C,
// Grid_WriteGrid.C and WriteParameterFile.C; what is trusted of it: VTK,
// IO/AMR/vtkAMREnzoReaderInternal.cxx.
#ifndef ExaBricksFilesEnzoHierarchy_h
#define ExaBricksFilesEnzoHierarchy_h

#include <filesystem>
#include <string>

namespace exabricks
{
/// What is wrong with it, with what was expected and found where; empty: nothing was found. Reads
/// the text files, and which data sets the HDF5 files hold, not their values.
std::string findEnzoFault(const std::filesystem::path& hierarchy);
}

#endif
