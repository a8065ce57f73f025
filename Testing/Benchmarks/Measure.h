// SPDX-License-Identifier: BSD-3-Clause
// Measures methods on a scene, all in turn, and judges their pictures.
#ifndef ExaBricksBenchmarksMeasure_h
#define ExaBricksBenchmarksMeasure_h

#include "Results.h"

namespace exabricks
{
namespace benchmarks
{
struct Plan
{
  std::vector<MethodKind> methods;
  bool quick = false;             // few values of parameters
  std::vector<double> stepScales; // instead of the methods' own; empty: those
  int largestGrid = 512;          // of methods that resample
  Size size{ { 512, 512 } };      // of the frames that are timed
  Size accuracySize{ { 256, 256 } };
  int rounds = 5;
  double budget = 5.0;  // seconds of timed frames for a method and value: no more rounds beyond
  std::string pictures; // folder to write pictures to; empty: none
  bool verbose = true;  // says what goes on, on the error stream
  int changes = 0;      // rounds of measuring changes; 0: none
};

/// Appends to `results`. Every method is drawn once, untimed, for each value of its parameter, then
/// so many times in turn, A B C A B C, so that a load on the machine falls on all of them.
void measureScene(const Scene& scene, const std::string& group, const Plan& plan, Results& results);

/// Structure and memory of a scene; `frames`: and the time of a frame at step 1, if not 0.
SceneMeasurements measureStructure(
  const Scene& scene, const std::string& group, const Size& size, int frames);

/// Says it on the error stream.
void say(const std::string& what);
}
}

#endif
