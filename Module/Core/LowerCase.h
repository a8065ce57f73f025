// SPDX-License-Identifier: BSD-3-Clause
// Names that are the same in capital letters or not.
#ifndef ExaBricksCoreLowerCase_h
#define ExaBricksCoreLowerCase_h

#include <algorithm>
#include <cctype>
#include <string>

namespace exabricks
{
inline std::string lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}
}

#endif
