// SPDX-License-Identifier: BSD-3-Clause
// A run of a filter that ends without its output, as it was aborted or there was no memory for it.
// The pipeline would take the empty output for up to date.
#ifndef ExaBricksAdaptersUnfinishedRun_h
#define ExaBricksAdaptersUnfinishedRun_h

#include "vtkAlgorithm.h"
#include "vtkTimeStamp.h"
#include "vtkVersionMacros.h"

namespace exabricks
{
/// Whether the filter is asked to stop.
inline bool isAborted(vtkAlgorithm* filter)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  return filter->CheckAbort() || filter->GetAbortExecute();
#else
  return filter->GetAbortExecute() != 0;
#endif
}

class UnfinishedRun
{
public:
  void set(bool unfinished) { this->Unfinished = unfinished; }

  /// The run had the memory that it needed.
  void setEnoughMemory() { this->NoMemoryReported = false; }

  /// There was no memory for the run. Each picture tries anew, so it is to be reported once as long
  /// as it stays: returns whether that is now.
  bool setOutOfMemory()
  {
    this->Unfinished = true;
    const bool reports = !this->NoMemoryReported;
    this->NoMemoryReported = true;
    return reports;
  }

  /// The filter's modification time, `own` but for this: later than its output as long as the last
  /// run is unfinished, so that the next update runs again.
  vtkMTimeType modificationTime(vtkMTimeType own) const
  {
    if (!this->Unfinished)
    {
      return own;
    }
    vtkTimeStamp now;
    now.Modified();
    return now.GetMTime();
  }

private:
  bool Unfinished = false;
  bool NoMemoryReported = false;
};
}

#endif
