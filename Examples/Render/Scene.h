// SPDX-License-Identifier: BSD-3-Clause
// A picture's settings as a file: what --stats writes, and what the viewer saves.

#ifndef ExaBricksRenderScene_h
#define ExaBricksRenderScene_h

#include "Options.h"

#include <string>

namespace render
{

// Takes all that a scene sets. Throws Failure(BadArguments) where the file is no scene, or sets
// what is not known here.
void readScene(const std::string& path, Options& options);

}

#endif
