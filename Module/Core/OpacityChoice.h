// SPDX-License-Identifier: BSD-3-Clause
// Which values of a data set nobody has looked at yet are worth showing: what is rare is shown,
// what is common is clear.
#ifndef ExaBricksCoreOpacityChoice_h
#define ExaBricksCoreOpacityChoice_h

#include <cstdint>
#include <vector>

namespace exabricks
{
/// How much each value is shown, in [0, 1], linear between points at equal distances over the range
/// of the values.
struct Interest
{
  std::vector<double> points; // the first and the last at the ends of the range

  /// At `t` of the range, in [0, 1].
  double at(double t) const;
};

/// From a histogram of leaf cells over the range of values. `belowToo`: values below the most
/// common one show as well as those above. Of a logarithm they are better left out: there they are
/// the near-nothing of far and empty space.
///
/// The most common values, which together hold 80 % of the cells, are the background and are clear:
/// the near-zero part of a field that decays, both phases of a fluid, the one value of a nearly
/// constant field. The others show the more, the rarer they are and the farther from the most
/// common value. Without rare values, as in a uniform histogram, the interest rises along the
/// range.
Interest chooseInterest(const std::vector<std::uint64_t>& cells, bool belowToo);
}

#endif
