// SPDX-License-Identifier: BSD-3-Clause
// The scenes there are. To add one: a function that makes its Model, and a line in
// SceneTable.cxx (or in the list of its group).
#ifndef ExaBricksBenchmarksSceneTable_h
#define ExaBricksBenchmarksSceneTable_h

#include "Options.h" // of Examples/Render
#include "Scene.h"

namespace exabricks
{
namespace benchmarks
{
struct SceneKind
{
  std::string name;
  std::string group;  // "made", "stand-in", "data", "field"; --scenes takes it for all of them
  bool quick = false; // part of --quick
  bool full = false;
  /// About so many leaf cells, where `scalable`; 0: as many as it has by itself.
  std::function<Model(double leafCells)> make;
  bool scalable = false;
  bool thorough = true; // in --full, by all methods and with all values of parameters
};

/// A data set on the command line; `draw.Input` empty: none.
struct InputScene
{
  render::Options draw;
  std::string scene; // JSON file with camera and transfer function, or empty
};

/// `folders` are searched for the data sets with known names; those that are missing are told
/// to `missing`.
std::vector<SceneKind> listScenes(const std::vector<std::string>& folders, const InputScene& input,
  std::vector<std::string>& missing);

// The groups.
std::vector<SceneKind> listMadeScenes();
std::vector<SceneKind> listStandInScenes();
std::vector<SceneKind> listFieldScenes();
std::vector<SceneKind> listDataScenes(
  const std::vector<std::string>& folders, std::vector<std::string>& missing);

/// From a file that exabricks-render opens, with its defaults for what is not asked for.
Model makeDataModel(const std::string& name, const InputScene& input);
}
}

#endif
