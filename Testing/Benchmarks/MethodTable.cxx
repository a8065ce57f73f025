// SPDX-License-Identifier: BSD-3-Clause
#include "Method.h"

namespace exabricks
{
namespace benchmarks
{
const char* const StepScale = "step scale";
const char* const ErrorTolerance = "error tolerance";
const char* const CellLocation = "cell location";
const char* const ByTolerance = "basis, by tolerance";
const char* const ByToleranceOfAllLevels = "by tolerance, all levels";
const char* const NativeMarch = "native march, k-d tree";

std::vector<MethodKind> listMethods()
{
  std::vector<MethodKind> methods;
  for (const auto& group :
    { listDirectMethods(), listVariantMethods(), listNativeMethods(), listWindowMethods() })
  {
    methods.insert(methods.end(), group.begin(), group.end());
  }
  return methods;
}
}
}
