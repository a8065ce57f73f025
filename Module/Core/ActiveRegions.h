// SPDX-License-Identifier: BSD-3-Clause
// Space skipping: the parts of regions in which the transfer function shows anything, and what the
// two traversals walk.
#ifndef ExaBricksCoreActiveRegions_h
#define ExaBricksCoreActiveRegions_h

#include "Core/StepWeights.h"
#include "Core/Volume.h"

namespace exabricks
{
/// Of what is below a node, or in a box: by it those that cannot change a ray's extreme are passed.
enum class Extreme
{
  None,
  Greatest, // value
  Least
};

/// What is made beside the tree.
struct ActiveForm
{
  bool boxes = true; // whether the boxes are listed too
  Extreme extreme = Extreme::None;
  bool undefined = false; // whether cells show whose value is undefined
};

/// A region is active as a whole, or cut between macrocells where it shows nothing in some.
struct ActiveRegions
{
  std::size_t regions = 0;  // in which anything shows
  std::size_t boxCount = 0; // into which they are cut
  /// In the order of the tree's leaves; empty unless they are asked for.
  std::vector<layout::ActiveBox> boxes;
  /// The regions' k-d tree down to these boxes, without the parts where nothing is active.
  std::vector<layout::KdNode> nodes;
  /// Normalised values, [box] and [node]; empty unless they are asked for.
  std::vector<float> boxExtremes;
  std::vector<float> nodeExtremes;
};

/// `weights` choose the step of each box; if null, it is one cell of the finest brick everywhere.
/// Throws std::length_error, with a message for the user, if the nodes' links have no room for all.
ActiveRegions selectActiveRegions(const Volume& volume, const TransferFunction& transfer,
  const StepWeights* weights = nullptr, const ActiveForm& form = {});

/// The same for several components, each with the function by which it shows, or null where it does
/// not matter: what any of them shows is active.
ActiveRegions selectActiveRegions(const Volume& volume,
  const std::vector<const TransferFunction*>& transfers, const StepWeights* weights = nullptr,
  const ActiveForm& form = {});

/// The same with each region that has bricks, as a whole, whatever its values: for comparisons.
ActiveRegions selectAllRegions(const Volume& volume, const ActiveForm& form = {});

/// Orders the boxes, with their extremes, by recursive median splits along the longest axis of
/// their centres. Builders that halve the array of boxes as given (Mesa's) make a good hierarchy of
/// it.
void sortByMedianSplits(ActiveRegions& active);
}

#endif
