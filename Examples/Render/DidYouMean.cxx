// SPDX-License-Identifier: BSD-3-Clause

#include "DidYouMean.h"

#include "ParseValues.h"

#include <algorithm>
#include <numeric>

namespace render
{

namespace
{

// How many letters have to be put in, taken out or changed (Levenshtein).
std::size_t distance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({ row[j] + 1, row[j + 1] + 1, changed });
    }
  }
  return row.back();
}

}

std::string didYouMean(const std::string& name, const std::vector<std::string>& known)
{
  const std::string* best = nullptr;
  std::size_t least = std::max<std::size_t>(name.size() / 3, 1) + 1;
  for (const std::string& other : known)
  {
    const std::size_t letters = distance(lowerCase(name), lowerCase(other));
    if (letters < least)
    {
      least = letters;
      best = &other;
    }
  }
  return best ? " Did you mean '" + *best + "'?" : std::string();
}

}
