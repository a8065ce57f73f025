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

  /// Whether there is anything to draw.
  explicit operator bool() const { return this->structure && this->values; }
};
}

#endif
