// SPDX-License-Identifier: BSD-3-Clause
// Whether what is asked for on the command line holds together.
#ifndef ExaBricksRenderCheckOptions_h
#define ExaBricksRenderCheckOptions_h

#include "Options.h"

namespace render
{

/// Whether a file of that name can be written: a picture, or a video.
bool hasOutputEnding(const std::string& path);

/// Throws Failure, with words for the user, where two options exclude one another, or one needs
/// another. The flags: whether options were given whose values alone do not tell it.
void checkTogether(
  const Options& o, bool viewGiven, bool stepGiven, bool fpsGiven, bool backgroundGiven);

}

#endif
