// SPDX-License-Identifier: BSD-3-Clause
// Writes files whole or not at all: under another name in the same folder first, which is then
// taken back to the right one. A symbolic link stays, and the file that it leads to is replaced;
// that file's owner and permissions are kept. What is there and is no regular file, such as a
// device, a FIFO or /dev/stdout, is written to as it is. All throw Failure(OutputUnwritable).

#ifndef ExaBricksRenderOutput_h
#define ExaBricksRenderOutput_h

#include <string>

class vtkImageData;

namespace render
{

// Before the long work: could a file be written there? Opens nothing that is no regular file.
void checkWritable(const std::string& path);

// The name of a file as long as it is not finished, and what takes its place then.
std::string temporaryBeside(const std::string& path);
void replaceBy(const std::string& path, const std::string& finished);

void writeText(const std::string& path, const std::string& text);

// Of a picture's file: .png, .jpg (of .jpeg too), .tif (of .tiff too), or another one in small
// letters.
std::string pictureEnding(const std::string& path);
// Whether the picture's colors are floats there.
bool holdsFloats(const std::string& path);
// PNG or JPEG, or of floats TIFF, by the ending.
void writePicture(const std::string& path, vtkImageData* image);

}

#endif
