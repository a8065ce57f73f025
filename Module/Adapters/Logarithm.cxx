// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/Logarithm.h"

#include "Adapters/AMRCompatibility.h"

#include "vtkArrayDispatch.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"

#include <cmath>
#include <limits>

namespace exabricks
{
namespace
{
struct LogarithmWorker
{
  template <class ArrayType>
  void operator()(ArrayType* in, vtkDoubleArray* out, int component) const
  {
    auto result = vtk::DataArrayValueRange<1>(out).begin();
    for (const auto tuple : vtk::DataArrayTupleRange(in))
    {
      double value = 0.0;
      if (component >= 0)
      {
        value = static_cast<double>(tuple[component]);
      }
      else
      {
        for (const auto v : tuple)
        {
          value += static_cast<double>(v) * static_cast<double>(v);
        }
        value = std::sqrt(value);
      }
      *result++ = value > 0.0 ? std::log10(value) : std::numeric_limits<double>::quiet_NaN();
    }
  }
};
}

std::string addLogarithm(vtkOverlappingAMR* amr, const std::string& array, int component)
{
  const std::string which = component < 0 ? "" : ", component " + std::to_string(component);
  std::string name = "log10(" + array + ")";
  forEachBlock(amr,
    [&](vtkDataSet* block)
    {
      vtkDataArray* in = block->GetCellData()->GetArray(array.c_str());
      if (!in || component >= in->GetNumberOfComponents())
      {
        return;
      }
      if (in->GetNumberOfComponents() > 1)
      {
        name = "log10(" + array + which + ")";
      }
      // The magnitude of a scalar would lose its sign.
      const int taken = in->GetNumberOfComponents() == 1 ? 0 : component;
      vtkNew<vtkDoubleArray> out;
      out->SetName(name.c_str());
      out->SetNumberOfTuples(in->GetNumberOfTuples());
      LogarithmWorker worker;
      if (!vtkArrayDispatch::Dispatch::Execute(in, worker, out.Get(), taken))
      {
        worker(in, out.Get(), taken);
      }
      block->GetCellData()->AddArray(out);
    });
  return name;
}
}
