// SPDX-License-Identifier: BSD-3-Clause
// Several processes that do each step together: what one of them has to say stops all, and bytes go
// from each to each.
#ifndef ExaBricksAdaptersProcesses_h
#define ExaBricksAdaptersProcesses_h

#include <exception>
#include <new>
#include <string>
#include <vector>

class vtkMultiProcessController;

namespace exabricks
{
struct Processes
{
  vtkMultiProcessController* controller = nullptr;
  int rank = 0;
  int count = 1;

  Processes() = default;
  explicit Processes(vtkMultiProcessController* ofController);

  /// What the first process that has a fault says, and which one it is, on all of them; nothing if
  /// none has.
  std::string agree(const std::string& fault) const;

  /// [process] of both: as many bytes come as `received` has room for. What was sent is freed.
  void exchange(std::vector<std::vector<unsigned char>>& sent,
    std::vector<std::vector<unsigned char>>& received) const;
};

/// What goes wrong in `work` on this process, which must not leave the others waiting for it.
template <typename Work>
std::string guard(const Work& work)
{
  try
  {
    work();
  }
  catch (const std::bad_alloc&)
  {
    return "out of memory for what it holds of the AMR";
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return {};
}
}

#endif
