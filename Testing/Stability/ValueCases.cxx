// SPDX-License-Identifier: BSD-3-Clause
// Arrays whose values are all alike, at the limits of their type, or of many sizes.
#include "MakeAMR.h"

#include "Cxx/AMR.h"

#include "vtkFloatArray.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

namespace exabricks
{
namespace stability
{
namespace
{
constexpr char asZeroToOne[] =
  "normalised in double precision, so that the picture is that of values from 0 to 1";

// The shell from exactly 0 to exactly 1, with some cells at both ends.
reference::CellField shellFromZeroToOne(const Hierarchy& hierarchy)
{
  return [shell = shellField(hierarchy)](int level, const Int3& cell)
  { return glm::clamp((shell(level, cell) - 0.1) / 0.8, 0.0, 1.0); };
}

// The shell from `lo` to `hi`, and the layers for it.
Setting shellBetween(double lo, double hi, vtkDataArray* like = nullptr)
{
  const Hierarchy hierarchy = twoLevels();
  AMROptions options;
  options.like = like;
  const reference::CellField share = shellFromZeroToOne(hierarchy);
  Setting setting = fieldSetting(
    hierarchy,
    [=](int level, const Int3& cell)
    {
      const double s = share(level, cell);
      return (1.0 - s) * lo + s * hi;
    },
    30.0, options);
  if (like)
  {
    setting.field = nullptr; // the type rounds
  }
  setting.transfer = layers(lo, hi);
  return setting;
}

Setting constantArray()
{
  Setting setting = fieldSetting(twoLevels(), [](int, const Int3&) { return 42.0; });
  setting.transfer = { { 40.0, { 0.1, 0.4, 0.8, 0.0 } }, { 50.0, { 0.9, 0.4, 0.3, 0.1 } } };
  return setting;
}

// All of int64, which double precision cannot hold between its ends.
Setting int64Limits()
{
  constexpr double most = 9223372036854774784.0; // the largest double below 2^63
  Setting setting = shellBetween(-9223372036854775808.0, most, vtkNew<vtkTypeInt64Array>());
  test::forEachGrid(setting.amr,
    [](unsigned int, vtkUniformGrid* grid)
    {
      vtkDataArray* values = grid->GetCellData()->GetScalars();
      for (vtkIdType cell = 0; cell < values->GetNumberOfTuples(); ++cell)
      {
        if (values->GetTuple1(cell) >= most)
        {
          values->SetVariantValue(cell, vtkVariant(std::numeric_limits<long long>::max()));
        }
      }
    });
  return setting;
}

// From 1e-3 to 1e3, with a layer in each decade.
Setting sixDecades()
{
  const Hierarchy hierarchy = twoLevels();
  const reference::CellField share = shellFromZeroToOne(hierarchy);
  Setting setting = fieldSetting(hierarchy,
    [=](int level, const Int3& cell) { return std::pow(10.0, 6.0 * share(level, cell) - 3.0); });
  setting.transfer.clear();
  for (int half = 0; half <= 12; ++half)
  {
    const double hue = half / 12.0;
    setting.transfer.push_back({ std::pow(10.0, 0.5 * half - 3.0),
      { hue, 0.5 + 0.5 * std::cos(6.0 * hue), 1.0 - hue, half % 2 == 0 ? 0.0 : 0.2 } });
  }
  return setting;
}
}

std::vector<Case> valueCases()
{
  constexpr double doubleMax = std::numeric_limits<double>::max();
  constexpr double floatMax = std::numeric_limits<float>::max();
  return {
    { "ConstantArray", "a range of no width: 0 / 0, nothing drawn", constantArray, 100.0, 100.0,
      "a constant is exact whatever the step; float32 alone errs" },
    { "DoubleLimits", "max - min overflows",
      []
      {
        // VTK's functions add a value to itself: their nodes can be half of the largest double.
        Setting setting = shellBetween(-doubleMax, doubleMax);
        setting.transfer = layers(-0.5 * doubleMax, 0.5 * doubleMax);
        return setting;
      },
      50.0, 100.0, "as UInt8Limits, but layers half as wide: 12 dB of second order less" },
    { "FloatLimits", "max - min overflows in float32",
      [] { return shellBetween(-floatMax, floatMax, vtkNew<vtkFloatArray>()); }, 60.0, 100.0,
      asZeroToOne },
    { "Int64Limits", "max - min overflows in int64", int64Limits, 60.0, 100.0, asZeroToOne },
    { "UInt8Limits", "values are taken for fixed point between 0 and 1",
      [] { return shellBetween(0.0, 255.0, vtkNew<vtkUnsignedCharArray>()); }, 60.0, 100.0,
      asZeroToOne },
    { "Denormals", "flushed to 0: a range of no width",
      [] { return shellBetween(std::numeric_limits<double>::denorm_min(), 2e-308); }, 60.0, 100.0,
      asZeroToOne },
    { "FloatDenormals", "flushed to 0: a range of no width",
      [] { return shellBetween(0.0, 1e-38, vtkNew<vtkFloatArray>()); }, 60.0, 100.0, asZeroToOne },
    { "LeastDenormals", "half of them is rounded; flushed to 0",
      [] { return shellBetween(0.0, 1000.0 * std::numeric_limits<double>::denorm_min()); }, 60.0,
      100.0, asZeroToOne },
    { "RangeOfThousandUlps", "float32 sees one value", [] { return shellBetween(1e6, 1e6 + 1e-7); },
      60.0, 100.0, asZeroToOne },
    { "SixDecades", "tables and fixed point show the highest decade alone", sixDecades, 40.0, 90.0,
      "in a step values pass several decades; how long a ray stays in the lower ones depends on "
      "the "
      "field's slope beside a kink, which two samples know to first order: 6 dB for half the step. "
      "Nearest: values keep their relative precision towards the lower end" },
  };
}
}
}
