// SPDX-License-Identifier: BSD-3-Clause
// What VTK has to say during the run: errors are kept, so that the run can end with one clear
// message; warnings are printed. Also the progress of long work.

#ifndef ExaBricksRenderMessages_h
#define ExaBricksRenderMessages_h

#include "Failure.h"

#include <string>

class vtkAlgorithm;

namespace render
{

// "ERROR: In file.cxx, line 7\nvtkClass (0x1234): text\n\n" -> "text"
std::string textOf(const char* message);

// Takes VTK's messages from here on.
void takeMessages(bool quiet);

// Throws a Failure with the errors that came since the last call, if there were any.
// doing: what was going on, such as "The input could not be read".
void throwIfErrors(ExitCode code, const std::string& doing);

// One line on a terminal that is written over, plain lines elsewhere, all on the error stream;
// nothing when quiet.
class Progress
{
public:
  // Says what is going on, until the end of the scope.
  Progress(const std::string& what, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Follows the progress events of an algorithm, which has to live as long as this.
  void Follow(vtkAlgorithm* algorithm);
  void Show(double fraction);

private:
  const std::string What;
  const bool Quiet;
  const bool Terminal;
  int Percent = -1;
  vtkAlgorithm* Followed = nullptr;
  unsigned long Observer = 0;
};

}

#endif
