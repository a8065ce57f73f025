// SPDX-License-Identifier: BSD-3-Clause
// A field as a function of the place, whatever it is reconstructed by.
#ifndef ExaBricksReferenceFieldFunction_h
#define ExaBricksReferenceFieldFunction_h

#include "Reference/Oracle.h"

#include <functional>
#include <optional>

namespace exabricks
{
namespace reference
{
/// The normalised value at a logical position; none where nothing is.
using FieldFunction = std::function<std::optional<double>(const glm::dvec3& logical)>;

/// The oracle's, which has to live as long.
inline FieldFunction fieldOf(
  const Oracle& oracle, Reconstruction reconstruction = Reconstruction::Basis)
{
  return [&oracle, reconstruction](const glm::dvec3& logical)
  { return oracle.sample(logical, reconstruction); };
}
}
}

#endif
