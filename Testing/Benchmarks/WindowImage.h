// SPDX-License-Identifier: BSD-3-Clause
#ifndef ExaBricksBenchmarksWindowImage_h
#define ExaBricksBenchmarksWindowImage_h

#include "Reference/Oracle.h" // Image

class vtkRenderWindow;

namespace exabricks
{
namespace benchmarks
{
/// What a window shows; 8 bits a channel, opaque.
reference::Image readWindow(vtkRenderWindow* window);
}
}

#endif
