// SPDX-License-Identifier: BSD-3-Clause
// Writes files whole or not at all: under another name in the same folder first, which is then
// taken back to the right one. All throw Failure(OutputUnwritable).

#ifndef Output_h
#define Output_h

#include <string>

class vtkImageData;

namespace render
{

// Before the long work: could a file be written there?
void CheckWritable(const std::string& path);

void WriteText(const std::string& path, const std::string& text);
void WritePNG(const std::string& path, vtkImageData* image);

}

#endif
