// SPDX-License-Identifier: BSD-3-Clause
// Values of options: numbers, sizes, vectors, colours, opacity points. All but ParseNumber throw
// Failure(BadArguments) and name the option, what it takes and what was found.

#ifndef ParseValues_h
#define ParseValues_h

#include "Options.h"

namespace render
{

/// The same in every locale; false for "inf", "nan", and where something is left over.
bool ParseNumber(const std::string& text, double& value);

std::array<int, 2> ParseSize(const std::string& option, const std::string& text);
Vector3 ParseVector(const std::string& option, const std::string& text);
Vector3 ParseColor(const std::string& option, const std::string& text);
std::optional<int> ParseComponent(const std::string& option, const std::string& text);
std::vector<OpacityPoint> ParseOpacity(const std::string& option, const std::string& text);

}

#endif
