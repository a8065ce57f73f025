// SPDX-License-Identifier: BSD-3-Clause
// Values of options: numbers, sizes, vectors, colours, opacity points. All but ParseNumber throw
// Failure(BadArguments) and name the option, what it takes and what was found.

#ifndef ExaBricksRenderParseValues_h
#define ExaBricksRenderParseValues_h

#include "Options.h"

namespace render
{

/// The same in every locale; false for "inf", "nan", and where something is left over.
bool parseNumber(const std::string& text, double& value);

std::string lowerCase(std::string text);

std::array<int, 2> parseSize(const std::string& option, const std::string& text);
Vector3 parseVector(const std::string& option, const std::string& text);
Vector3 parseColor(const std::string& option, const std::string& text);
std::optional<int> parseComponent(const std::string& option, const std::string& text);
std::vector<double> parseNumbers(const std::string& option, const std::string& text);
std::vector<OpacityPoint> parseOpacity(const std::string& option, const std::string& text);

}

#endif
