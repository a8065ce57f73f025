// SPDX-License-Identifier: BSD-3-Clause
// Links of the k-d trees' nodes (layout::KdNode), which have 30 bits for an index.
#ifndef ExaBricksCoreKdLink_h
#define ExaBricksCoreKdLink_h

#include "Layout.h"

#include <cstddef>
#include <stdexcept>
#include <string>

namespace exabricks
{
/// Returns `index`, of a node, a region, or an entry of the brick lists, for a link. Throws
/// std::length_error, with a message for the user, where a link has no room for it.
inline std::uint32_t checkIndex(std::size_t index)
{
  if (index >= layout::KD_NO_REGION)
  {
    throw std::length_error(
      "expected regions with fewer than 2^30 nodes and entries of lists, found at least " +
      std::to_string(index) + ". Read fewer levels");
  }
  return static_cast<std::uint32_t>(index);
}

/// `kind`: the axis of a split, or layout::KD_LEAF.
inline std::uint32_t makeLink(std::size_t index, std::uint32_t kind)
{
  return 4 * checkIndex(index) + kind;
}

/// A node of a tree that becomes a part of a larger one, where places of nodes and what leaves link
/// to lie so much farther on. The caller has checked that the last of them has room: without a
/// check, and without branches, a tree is moved in half the time.
inline layout::KdNode moveLink(layout::KdNode node, std::size_t byNodes, std::size_t byLeaves)
{
  const bool isLeaf = (node.link & 3) == layout::KD_LEAF;
  node.link += 4 * static_cast<std::uint32_t>(isLeaf ? byLeaves : byNodes);
  return node;
}
}

#endif
