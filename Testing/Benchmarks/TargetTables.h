// SPDX-License-Identifier: BSD-3-Clause
// What the renderer was asked to reach, and whether it does.
#ifndef ExaBricksBenchmarksTargetTables_h
#define ExaBricksBenchmarksTargetTables_h

#include "Results.h"

namespace exabricks
{
namespace benchmarks
{
/// The scene with known camera and functions that a frame's time was asked for.
extern const char* const TargetScene;

/// On that scene: the fastest of ours that is accurate enough, against the peer to beat. Empty if
/// either was not measured.
std::string frameTargetTable(const Results& results);
/// Processor time of ours by the k-d tree against the native march's, at step 1, scene by scene.
std::string nativeTargetTable(const Results& results);
/// The error that was asked for and the one got, over the drawn pixels, scene by scene.
std::string toleranceTargetTable(const Results& results);
/// What it takes with all levels, and without those that the tolerance allows to leave out; where
/// there are any.
std::string levelsTable(const Results& results);
/// Samples for 50 dB by fixed steps and by an error tolerance, scene by scene.
std::string samplesTargetTable(const Results& results);
}
}

#endif
