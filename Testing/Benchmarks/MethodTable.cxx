// SPDX-License-Identifier: BSD-3-Clause
#include "Method.h"

namespace exabricks
{
namespace benchmarks
{
const char* const StepScale = "step scale";
const char* const ErrorTolerance = "error tolerance";

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
