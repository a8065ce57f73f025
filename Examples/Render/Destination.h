// SPDX-License-Identifier: BSD-3-Clause
// Where the bytes go that are written to a path: symbolic links, devices, FIFOs and descriptors.

#ifndef ExaBricksRenderDestination_h
#define ExaBricksRenderDestination_h

#include <string>

namespace render
{

struct Destination
{
  std::string Target;  // the path, its symbolic links followed
  int Descriptor = -1; // an open one, if the path is one's name: /dev/stdout, /dev/fd/3
  bool Replace = true; // a regular file, or none yet; anything else is written to as it is
};

// Throws Failure(OutputUnwritable).
[[noreturn]] void refuseOutput(const std::string& path, const std::string& why);

// Throws Failure(OutputUnwritable) where the path leads nowhere, or to what takes no bytes.
Destination findDestination(const std::string& path);

// For what is not to be replaced. Opens nothing: that would wait at a FIFO that nobody reads, and
// may disturb a device. Where it may not be written, errno says why.
bool mayBeWritten(const Destination& destination);

}

#endif
