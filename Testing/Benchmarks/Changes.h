// SPDX-License-Identifier: BSD-3-Clause
// What a change of colours, of opacity or of the camera costs.
#ifndef ExaBricksBenchmarksChanges_h
#define ExaBricksBenchmarksChanges_h

#include "Methods.h"

namespace exabricks
{
namespace benchmarks
{
struct Change
{
  Change(const std::string& changed, const std::string& by)
    : what(changed)
    , traversal(by)
  {
  }

  std::string what;
  std::string traversal;
  Costs total;               // from VTK's functions to tables on the device; of the camera: a frame
  std::vector<double> color; // of the tables, where they were made anew
  std::vector<double> opacity; // of active regions and their tree, likewise
  std::vector<double> march;
  // Never done anew: the renderer's own times of them stayed as they were.
  bool keptVolume = true;
  bool keptColors = true;
  bool keptOpacity = true;
};

/// Each change is made to and fro, by both traversals in turn:
///   colours (red and blue change places); opacities scaled, which show the same values; opacities
///   cut off below the middle of the values that show; the camera turned by 5 degrees.
std::vector<Change> measureChanges(
  const Subject& subject, const Request& request, DirectRenderer& kdTree, DirectRenderer& rayQuery);

double meanOpacity(const reference::Image& image);
}
}

#endif
