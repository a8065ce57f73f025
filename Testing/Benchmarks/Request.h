// SPDX-License-Identifier: BSD-3-Clause
// The command line of exabricks-benchmark, checked as far as it can be without scenes.
#ifndef ExaBricksBenchmarksRequest_h
#define ExaBricksBenchmarksRequest_h

#include "Measure.h"
#include "SceneTable.h"

namespace exabricks
{
namespace benchmarks
{
struct Request
{
  enum class Task
  {
    Measure,
    List // scenes and methods
  };
  Task task = Task::Measure;
  std::string folder; // of results
  std::vector<std::string> data;
  InputScene input;
  std::vector<std::string> scenes;  // names or groups; empty: those of --quick or --full
  std::vector<std::string> methods; // likewise
  double leafCells = 0.0;           // of scenes made by code; 0: as many as each has by itself
  bool growth = false;
  double largest = 1e7;
  bool full = false;
  bool structure = false; // the sweep of brick sizes
  bool march = false;     // what a march does
  int ranks = 0;          // most processes to simulate; 0: none
  Plan plan;
};

/// False: there is nothing left to do (--help was answered). Throws render::Failure.
bool parseRequest(int argc, char** argv, Request& request);
}
}

#endif
