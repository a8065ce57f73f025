// SPDX-License-Identifier: BSD-3-Clause
// Tables and charts of what was measured.
#ifndef ExaBricksBenchmarksReport_h
#define ExaBricksBenchmarksReport_h

#include "Results.h"

namespace exabricks
{
namespace benchmarks
{
/// Markdown, by the name of the file.
std::map<std::string, std::string> makeTables(const Results& results);

/// Draws all charts there is something for to PNG.
void drawCharts(const Results& results, const std::string& folder);

/// Both, into the folder: whole files, or none in their place.
void writeReport(const Results& results, const std::string& folder);

/// Of the scene's rows that are drawn with what a user gets who sets nothing: the fastest by the
/// basis; null if there is none.
const Result* findDefault(const Results& results, const std::string& scene);
/// In the order they were measured.
std::vector<std::string> sceneNames(const Results& results);
}
}

#endif
