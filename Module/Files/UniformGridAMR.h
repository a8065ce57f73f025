// SPDX-License-Identifier: BSD-3-Clause
// AMR of VTK's XML formats (.vthb, .vth): whether the levels and boxes that it lists fit together,
// and fit the .vti file of each block. The format: VTK, IO/XML/vtkXMLUniformGridAMRWriter.cxx.
#ifndef ExaBricksFilesUniformGridAMR_h
#define ExaBricksFilesUniformGridAMR_h

#include <filesystem>
#include <string>

namespace exabricks
{
/// What is wrong with it, with what was expected and found where; empty: nothing was found. Reads
/// the XML of all files, and how long the data of each array are, not the values.
std::string findUniformGridAMRFault(const std::filesystem::path& path);
}

#endif
