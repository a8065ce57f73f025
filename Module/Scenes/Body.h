// SPDX-License-Identifier: BSD-3-Clause
// Solid bodies of a few parts: how far a place is from them, and their surface as triangles.
#ifndef ExaBricksScenesBody_h
#define ExaBricksScenesBody_h

#include "Scenes/StandIn.h"

namespace exabricks
{
/// A cone from `from` to `to`, with round or flat ends.
struct Rod
{
  glm::dvec3 from;
  glm::dvec3 to;
  double radiusFrom;
  double radiusTo;
  bool round = true;
};

/// A thin lens from its root to its tip, whose chord lies along x.
struct Wing
{
  glm::dvec3 root; // middle of the chord
  glm::dvec3 tip;
  double rootChord; // half of it
  double tipChord;  // half of it
  double thickness; // half of it, at the root; at the tip it is a third of that
};

struct Body
{
  std::vector<Rod> rods;
  std::vector<Wing> wings;

  /// 0 inside the body.
  double distance(const glm::dvec3& p) const;
  /// Closed surfaces, one for each part.
  TriangleMesh mesh() const;
};

/// How strong the wake of a rod is behind it, in a flow along x, in [0, 1].
double wakeOf(const Rod& rod, const glm::dvec3& p, double length);
}

#endif
