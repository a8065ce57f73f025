// SPDX-License-Identifier: BSD-3-Clause
// AMReX plotfiles (3-D, "HyperCLaw-V1.1"): whether what their headers say fits together and fits
// the files beside them. Readers trust it, and end in crashes, or draw other values, where it does
// not. The format: AMReX, Src/Base/AMReX_PlotFileUtil.cpp, AMReX_VisMF.cpp and AMReX_FArrayBox.cpp.
#ifndef ExaBricksFilesPlotfile_h
#define ExaBricksFilesPlotfile_h

#include <filesystem>
#include <string>

namespace exabricks
{
/// What is wrong with the plotfile in a folder, with what was expected and found where; empty: its
/// headers fit together, and each box's data lie in a file that is long enough. Reads the headers
/// and the first line of each box, not the values.
std::string findPlotfileFault(const std::filesystem::path& folder);
}

#endif
