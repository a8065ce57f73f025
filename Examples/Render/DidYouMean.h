// SPDX-License-Identifier: BSD-3-Clause
// For a name that is not known: the one that may have been meant.

#ifndef ExaBricksRenderDidYouMean_h
#define ExaBricksRenderDidYouMean_h

#include <string>
#include <vector>

namespace render
{

// " Did you mean 'viridis'?", if one of the known names differs in few letters; else nothing.
std::string didYouMean(const std::string& name, const std::vector<std::string>& known);

}

#endif
