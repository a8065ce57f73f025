// SPDX-License-Identifier: BSD-3-Clause
// What the run did, for people and for programs.

#ifndef ExaBricksRenderReport_h
#define ExaBricksRenderReport_h

#include "OpenAMR.h"
#include "Options.h"

#include <iosfwd>

namespace render
{

class Picture;

struct Run
{
  const Options& Asked;
  const AMRFile& File;
  const Picture& Result;
  ArrayInfo Array;
  double ReadTime = 0.0;  // seconds
  bool LogChosen = false; // for the options' Log, as they left it open
};

// What is drawn, such as log10(velocity, component 2).
std::string arrayText(const Options& options, const ArrayInfo& array);

void printArrays(std::ostream& out, const AMRFile& file);
void printReport(std::ostream& out, const Run& run);

// JSON; times in seconds, memory in bytes, lengths in the data's.
std::string statisticsJson(const Run& run);

}

#endif
