// SPDX-License-Identifier: BSD-3-Clause
// Arrays of every type are read as they are, without a copy of another type, and values of any size
// are normalised without loss.

#include "AMR.h"
#include "Checks.h"

#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"
#include "vtkIdTypeArray.h"
#include "vtkSOADataArrayTemplate.h"

#include <limits>

namespace
{
constexpr int Bins = 7;

struct Result
{
  double range[2];
  std::vector<vtkIdType> histogram;
  vtkIdType leafCells;
};

// Repeatable, and between 0 and 100, which fits every type; whole, too.
double mixed(double x, double y, double z)
{
  return std::floor(std::fmod(31.0 * x + 17.0 * y * y + 7.0 * z * x, 101.0));
}

// Reads `field` from arrays of the kind that `make` makes.
Result build(const test::Field& field, const std::function<vtkSmartPointer<vtkDataArray>()>& make)
{
  auto amr = test::makeAMR(test::cornerRefined(), field);
  test::forEachGrid(amr,
    [&](unsigned int, vtkUniformGrid* grid)
    {
      vtkDataArray* doubles = grid->GetCellData()->GetScalars();
      vtkSmartPointer<vtkDataArray> array = make();
      array->SetName("typed");
      array->SetNumberOfComponents(1); // which a struct of arrays wants to be told
      array->SetNumberOfTuples(doubles->GetNumberOfTuples());
      for (vtkIdType i = 0; i < doubles->GetNumberOfTuples(); ++i)
      {
        array->SetComponent(i, 0, doubles->GetComponent(i, 0));
      }
      grid->GetCellData()->SetScalars(array);
    });
  vtkNew<vtkExaBricksBuilder> builder;
  builder->SetInputDataObject(amr);
  builder->Update();
  Result result;
  vtkExaBricksData* data = builder->GetOutput();
  data->GetScalarRange(result.range);
  result.leafCells = data->GetNumberOfLeafCells();
  vtkNew<vtkIdTypeArray> counts;
  data->GetHistogram(Bins, counts);
  for (vtkIdType bin = 0; bin < counts->GetNumberOfTuples(); ++bin)
  {
    result.histogram.push_back(counts->GetValue(bin));
  }
  return result;
}

std::function<vtkSmartPointer<vtkDataArray>()> ofType(int type)
{
  return [type]
  { return vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type)); };
}
}

int TestArrayTypes(int, char*[])
{
  test::Checks checks;
  const Result doubles = build(mixed, ofType(VTK_DOUBLE));
  checks.Expect(doubles.range[1] > doubles.range[0] + 50.0, "the values differ");
  vtkIdType sum = 0;
  for (const vtkIdType count : doubles.histogram)
  {
    sum += count;
  }
  checks.Equal(doubles.leafCells, 8 * 8 * 8 - 4 * 4 * 4 + 8 * 8 * 8, "leaf cells");
  checks.Equal(sum, doubles.leafCells, "each leaf cell is counted once");

  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT })
  {
    const Result typed = build(mixed, ofType(type));
    const std::string name = vtkImageScalarTypeNameMacro(type);
    checks.Equal(typed.range[0], doubles.range[0], "least value as " + name);
    checks.Equal(typed.range[1], doubles.range[1], "greatest value as " + name);
    checks.Expect(typed.histogram == doubles.histogram, "histogram as " + name);
  }
  const Result structOfArrays =
    build(mixed, [] { return vtkSmartPointer<vtkSOADataArrayTemplate<float>>::New(); });
  checks.Expect(structOfArrays.histogram == doubles.histogram, "histogram as struct of arrays");
  const auto even = [](double x, double y, double z) { return std::fmod(mixed(x, y, z), 2.0); };
  checks.Expect(build(even, ofType(VTK_BIT)).histogram == build(even, ofType(VTK_INT)).histogram,
    "histogram as bits");

  // A small range on top of a large number, and the largest range there is.
  const Result offset =
    build([](double x, double y, double z) { return 4503599627370496.0 + mixed(x, y, z); },
      ofType(VTK_LONG_LONG));
  checks.Equal(
    offset.range[1] - offset.range[0], doubles.range[1] - doubles.range[0], "2^52 + value");
  checks.Expect(offset.histogram == doubles.histogram, "histogram of 2^52 + value");
  constexpr double most = std::numeric_limits<double>::max();
  const Result wide =
    build([](double x, double, double) { return x < 1.0 ? -most
                                           : x > 7.0    ? most
                                                        : 0.0; },
      ofType(VTK_DOUBLE));
  checks.Expect(wide.range[0] == -most && wide.range[1] == most, "range of all doubles");
  checks.Expect(wide.histogram[Bins / 2] > wide.histogram[0] && wide.histogram[0] > 0 &&
      wide.histogram[Bins - 1] > 0,
    "values across all doubles are told apart");
  return checks.Status();
}
