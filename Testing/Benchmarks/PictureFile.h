// SPDX-License-Identifier: BSD-3-Clause
#ifndef ExaBricksBenchmarksPictureFile_h
#define ExaBricksBenchmarksPictureFile_h

#include "Reference/Image.h"

#include <string>

namespace exabricks
{
namespace benchmarks
{
/// Letters and digits, "_" for all else, and ".png".
std::string pictureFileName(const std::string& text);
/// Over black, PNG.
void writePicture(
  const reference::Image& image, const std::string& folder, const std::string& name);
}
}

#endif
