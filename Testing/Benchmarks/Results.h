// SPDX-License-Identifier: BSD-3-Clause
// What was measured, and the CSV files that it is written to. Utilities/report draws tables and
// charts from the files alone, and knows their columns.
#ifndef ExaBricksBenchmarksResults_h
#define ExaBricksBenchmarksResults_h

#include "Accuracy/CsvTable.h"
#include "Method.h"

#include <utility>

namespace exabricks
{
namespace benchmarks
{
/// One method on one scene with one value of its parameter. Errors are of red, green and blue over
/// black, with a peak of 1, against the scene's truth.
struct Result
{
  std::string scene;
  std::string method;
  Role role = Role::Ours;
  std::string parameter;
  double value = NotMeasured;
  int rounds = 0;
  double wall = NotMeasured; // seconds, medians
  double cpu = NotMeasured;
  double march = NotMeasured;
  double setUp = NotMeasured; // seconds
  double resampling = NotMeasured;
  double hostBytes = NotMeasured;
  double deviceBytes = NotMeasured;
  double rmse = NotMeasured;
  double psnr = NotMeasured;
  double psnrDrawn = NotMeasured; // over the pixels that the truth or the picture draws
  double ssim = NotMeasured;
  double psnrRGBA = NotMeasured; // with opacity, of methods that have it
  double psnrRGBADrawn = NotMeasured;
  double rmseOwn = NotMeasured; // against the integral of the method's own reconstruction
  double samples = NotMeasured; // for a pixel of the picture that is compared
  std::string note;
};

/// The error tolerance that growth is measured with.
constexpr double GrowthTolerance = 0.01;

/// What a scene is cut into, and what that takes.
struct SceneMeasurements
{
  std::string scene;
  std::string group;
  double levels = 0;
  double blocks = 0;
  double leafCells = 0;
  double bricks = 0;
  double regions = 0;
  double activeRegions = 0;
  double structureTime = NotMeasured; // seconds
  double gatherTime = NotMeasured;
  double rangesTime = NotMeasured;
  double scalarBytes = NotMeasured; // on the device
  double brickBytes = NotMeasured;
  double regionBytes = NotMeasured;     // lists and k-d tree, where the latter is drawn with
  double regionHostBytes = NotMeasured; // regions, lists, k-d tree, value ranges
  double kdTreeBytes = NotMeasured;
  double accelerationBytes = NotMeasured; // of ray query
  double surfaceBytes = NotMeasured;
  double kdTreeTotal = NotMeasured; // all on the device, with tables
  double rayQueryTotal = NotMeasured;
  double hostBytes = NotMeasured;
  double frameKdTree = NotMeasured; // seconds, basis, step 1; where growth is measured
  double frameRayQuery = NotMeasured;
  double frameByTolerance = NotMeasured; // k-d tree, GrowthTolerance
  double frameOfAllLevels = NotMeasured; // so too, and none left out
  double levelsLeftOut = NotMeasured;    // in the former
  double truthTime = NotMeasured;        // seconds
  double truthError = NotMeasured;
  double meanOpacity = NotMeasured;
};

struct Results
{
  std::vector<Result> rows;
  std::vector<SceneMeasurements> scenes;
  std::vector<SceneMeasurements> growth;
  accuracy::CsvTable changes;
  std::vector<std::pair<std::string, std::string>> machine; // name, what it is
};

/// results.csv, scenes.csv, growth.csv, changes.csv, machine.csv: those there is something for.
/// Whole or not at all. Times are in the units that the columns' names end with.
void writeResults(const Results& results, const std::string& folder);

std::string nameOf(Role role);
}
}

#endif
