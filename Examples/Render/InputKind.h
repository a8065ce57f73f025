// SPDX-License-Identifier: BSD-3-Clause
// What kind of data set a path leads to, by its name and by its first bytes: VTK's readers can
// crash on what they do not expect.

#ifndef ExaBricksRenderInputKind_h
#define ExaBricksRenderInputKind_h

#include <string>

namespace render
{

enum class InputKind
{
  AMReX,
  Enzo,
  Flash,
  VTKHDF,
  XML
};

// Throws Failure(InputUnreadable) with what is missing.
InputKind findInputKind(const std::string& path);

}

#endif
