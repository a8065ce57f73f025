// SPDX-License-Identifier: BSD-3-Clause
// All that is drawn of a data set: its structure, and the values of one array at one time step.
#ifndef ExaBricksCoreVolume_h
#define ExaBricksCoreVolume_h

#include "Core/Values.h"

namespace exabricks
{
/// Both parts are shared and never change. Another array or time step on equal boxes has other
/// values on the same structure.
struct Volume
{
  std::shared_ptr<const Structure> structure;
  std::shared_ptr<const Values> values;
  /// Of further components of the array. A cell has all of its components, or is absent.
  std::vector<std::shared_ptr<const Values>> furtherValues{};

  /// Whether there is anything to draw.
  explicit operator bool() const { return this->structure && this->values; }

  /// Of the values of all components, on the host.
  std::uint64_t valueBytes() const
  {
    std::uint64_t bytes = 0;
    for (std::size_t k = 0; k < this->components(); ++k)
    {
      bytes += this->valuesOf(k)->bytes();
    }
    return bytes;
  }

  std::size_t components() const { return 1 + this->furtherValues.size(); }
  const std::shared_ptr<const Values>& valuesOf(std::size_t component) const
  {
    return component == 0 ? this->values : this->furtherValues[component - 1];
  }
};
}

#endif
