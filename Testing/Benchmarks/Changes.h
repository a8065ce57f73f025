// SPDX-License-Identifier: BSD-3-Clause
// What a change of colours, of opacity or of the camera costs.
#ifndef ExaBricksBenchmarksChanges_h
#define ExaBricksBenchmarksChanges_h

#include "Accuracy/CsvTable.h"
#include "Scene.h"

namespace exabricks
{
namespace benchmarks
{
/// Each change is made to and fro, so many times, by both traversals in turn:
///   colours (red and blue change places); opacities scaled, which show the same values; opacities
///   cut off below the middle of the values that show; the camera rolled by 5 degrees.
/// Appends a line for each to `table`: medians of all, of making the colour tables and of choosing
/// the active regions (where they were made anew), and of the march; and what was kept.
void measureChanges(const Scene& scene, const Size& size, int rounds, accuracy::CsvTable& table);
}
}

#endif
