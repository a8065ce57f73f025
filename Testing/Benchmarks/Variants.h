// SPDX-License-Identifier: BSD-3-Clause
// The methods of marching that the benchmark compares: our own, other ones on the same buffers and
// rays, and ours with one thing taken away.
#ifndef ExaBricksBenchmarksVariants_h
#define ExaBricksBenchmarksVariants_h

#include "VariantRenderer.h"

#include <functional>

namespace exabricks
{
namespace benchmarks
{
struct Variant
{
  std::string name;
  std::string what; // in a few words, for tables
  /// For a VariantRenderer of this volume; null: our own method, of VolumeRenderer.
  /// Made for Reconstruction::Basis.
  std::function<std::shared_ptr<const MarchProgram>(const Volume&)> makeProgram;
};

/// "ours" first.
const std::vector<Variant>& variants();
/// Our own march, whose picture is, per pixel, the number of samples of the field (red), intervals
/// (green), regions entered (blue) and steps down the tree (opacity); of Completed too.
const Variant& countingVariant();
/// The same of what lanes share. Needs a device with ballots of subgroups.
const Variant& laneCountingVariant();
/// The one of `variants` with that name; throws std::out_of_range if there is none.
const Variant& findVariant(const std::string& name);
}
}

#endif
