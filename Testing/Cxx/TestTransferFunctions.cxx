// SPDX-License-Identifier: BSD-3-Clause
// Colours and opacities are those that VTK's own functions give, at every value: any colour space,
// scale, midpoint, sharpness and rule for values outside of the nodes. Read off blocks of one
// value.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkDiscretizableColorTransferFunction.h"

namespace
{
constexpr double Width = 2.0; // of a block, along all axes

// A row of blocks, each of one value.
struct Row
{
  std::vector<double> values;
  test::Stage stage;
  std::unique_ptr<test::Picture> picture;

  explicit Row(const std::vector<double>& blockValues)
    : values(blockValues)
  {
    std::vector<test::Block> blocks;
    for (std::size_t i = 0; i < this->values.size(); ++i)
    {
      blocks.push_back({ 0, { static_cast<int>(2 * i), 0, 0 }, { 2, 2, 2 } });
    }
    const int n = static_cast<int>(this->values.size());
    this->stage.mapper->SetInputData(test::makeAMR(blocks,
      [this](double x, double, double)
      { return this->values[static_cast<std::size_t>(x / Width)]; }));
    this->stage.mapper->SetReconstructionToNearest(); // no values in between
    this->stage.window->SetSize(10 * n, 10);
    test::lookAlongZ(this->stage.renderer, n, 1.0, 1.0, Width);
  }

  void Render() { this->picture = std::make_unique<test::Picture>(this->stage.window); }

  test::Picture::Color ColorOf(std::size_t block) const
  {
    return this->picture->At(static_cast<int>(10 * block + 5), 5);
  }

  // Every block shows what the property's functions give for its value.
  void Check(test::Checks& checks, const std::string& what)
  {
    this->Render();
    vtkVolumeProperty* property = this->stage.Property();
    for (std::size_t i = 0; i < this->values.size(); ++i)
    {
      const double value = this->values[i];
      double rgb[3];
      if (property->GetColorChannels() == 1)
      {
        rgb[0] = rgb[1] = rgb[2] = property->GetGrayTransferFunction()->GetValue(value);
      }
      else
      {
        property->GetRGBTransferFunction()->GetColor(value, rgb);
      }
      const double opacity = test::opacityOf(property->GetScalarOpacity()->GetValue(value), Width,
        property->GetScalarOpacityUnitDistance());
      for (int c = 0; c < 3; ++c)
      {
        checks.Near(this->ColorOf(i)[c], opacity * rgb[c], test::OneStep,
          what + ", channel " + std::to_string(c) + " at " + std::to_string(value));
      }
    }
  }
};

// Values at nodes, between and outside of them.
const std::vector<double> someValues{ 0.01, 0.1, 0.5, 1.0, 1.7, 2.9, 4.0, 6.3, 9.5, 20.0, 55.0,
  60.0, 99.0, 100.0, 120.0 };

void addNodes(vtkColorTransferFunction* color, double midpoint = 0.5, double sharpness = 0.0)
{
  color->RemoveAllPoints();
  color->AddRGBPoint(0.1, 0.1, 0.2, 0.9, midpoint, sharpness);
  color->AddRGBPoint(4.0, 0.9, 0.1, 0.3, midpoint, sharpness);
  color->AddRGBPoint(100.0, 0.3, 1.0, 0.1, midpoint, sharpness);
}

void checkColors(test::Checks& checks)
{
  Row row(someValues);
  test::setConstantColor(row.stage.Property(), 1.0);
  vtkColorTransferFunction* color = row.stage.Property()->GetRGBTransferFunction();
  addNodes(color);
  row.Check(checks, "RGB");
  color->SetClamping(0);
  row.Check(checks, "without clamping");
  color->SetClamping(1);
  color->SetScaleToLog10();
  row.Check(checks, "logarithmic");
  color->SetScaleToLinear();
  color->SetColorSpaceToHSV();
  row.Check(checks, "HSV");
  color->HSVWrapOff();
  row.Check(checks, "HSV without wrap");
  color->SetColorSpaceToLab();
  row.Check(checks, "Lab");
  color->SetColorSpaceToDiverging();
  row.Check(checks, "diverging");
  color->SetScaleToLog10();
  row.Check(checks, "diverging, logarithmic");
  color->SetScaleToLinear();
  color->SetColorSpaceToStep();
  row.Check(checks, "step");
  color->SetColorSpaceToRGB();
  for (const double midpoint : { 0.2, 0.8 })
  {
    for (const double sharpness : { 0.0, 0.4, 1.0 })
    {
      addNodes(color, midpoint, sharpness);
      row.Check(checks,
        "colour midpoint " + std::to_string(midpoint) + ", sharpness " + std::to_string(sharpness));
    }
  }

  vtkNew<vtkPiecewiseFunction> gray;
  gray->AddPoint(0.1, 0.2);
  gray->AddPoint(4.0, 1.0);
  gray->AddPoint(100.0, 0.5);
  row.stage.Property()->SetColor(gray);
  checks.Equal(row.stage.Property()->GetColorChannels(), 1, "channels of a gray function");
  row.Check(checks, "gray");
  gray->ClampingOff();
  row.Check(checks, "gray without clamping");
}

// Discretised, a function has steps of one color each: in blocks, and in a field that passes
// through all values between two of them.
void checkSteps(test::Checks& checks)
{
  std::vector<double> values = someValues;
  for (int i = 0; i < 60; ++i)
  {
    values.push_back(0.1 + 1.6601 * i);
  }
  Row row(values);
  test::setConstantColor(row.stage.Property(), 0.9);
  vtkNew<vtkDiscretizableColorTransferFunction> color;
  row.stage.Property()->SetColor(color);
  addNodes(color);
  for (const int steps : { 1, 3, 7, 64 })
  {
    color->DiscretizeOn();
    color->SetNumberOfValues(steps);
    row.Check(checks, std::to_string(steps) + " steps");
    color->SetUseLogScale(true);
    row.Check(checks, std::to_string(steps) + " steps, logarithmic");
    color->SetUseLogScale(false);
  }
  color->SetColorSpaceToLab();
  row.Check(checks, "64 steps, Lab");
  color->UseBelowRangeColorOn();
  color->SetBelowRangeColor(1.0, 0.0, 1.0);
  color->UseAboveRangeColorOn();
  color->SetAboveRangeColor(0.0, 1.0, 1.0);
  row.Check(checks, "colors below and above the range");
  color->DiscretizeOff();
  row.Check(checks, "not discretised");

  // From 0 at the left to 8 at the right, nearly opaque: each pixel has the color of its value.
  test::Stage ramp(
    test::makeAMR({ { 0, { 0, 0, 0 }, { 8, 8, 8 } } }, [](double x, double, double) { return x; }));
  vtkNew<vtkDiscretizableColorTransferFunction> bands;
  bands->AddRGBPoint(0.5, 0.0, 0.0, 0.0);
  bands->AddRGBPoint(7.5, 1.0, 1.0, 1.0);
  bands->DiscretizeOn();
  bands->SetNumberOfValues(4);
  test::setConstantColor(ramp.Property(), 1.0);
  ramp.Property()->SetColor(bands);
  test::lookAlongZ(ramp.renderer, 4.0, 4.0, 4.0, 8.0);
  const test::Picture picture(ramp.window);
  for (int x = 0; x < 100; ++x)
  {
    double expected[3];
    bands->GetColor(std::min(std::max(0.08 * (x + 0.5), 0.5), 7.5), expected);
    checks.Near(picture.At(x, 50)[0], expected[0], test::OneStep,
      "steps between cells, at pixel " + std::to_string(x));
  }
}

// Colors of categories: those of the annotated values alone, all others have the NaN color. Only
// the values of cells themselves have categories: values between them keep the colors between the
// nodes.
void checkCategories(test::Checks& checks)
{
  Row row(someValues);
  test::setConstantColor(row.stage.Property(), 0.9);
  const vtkNew<vtkColorTransferFunction> plain;
  const vtkNew<vtkDiscretizableColorTransferFunction> discretizable;
  const std::vector<vtkColorTransferFunction*> functions{ plain, discretizable };
  for (vtkColorTransferFunction* color : functions)
  {
    row.stage.Property()->SetColor(color);
    addNodes(color);
    color->SetNanColor(0.5, 0.6, 0.7);
    for (const double value : { 0.01, 0.5, 1.7, 20.0, 120.0 })
    {
      color->SetAnnotation(vtkVariant(value), std::to_string(value));
    }
    color->IndexedLookupOn();
    color->Build();
    row.Check(checks, std::string("categories of a ") + color->GetClassName());
    checks.Near(row.ColorOf(2)[0], 0.9 * test::opacityOf(0.9, 2.0), test::OneStep, "the second");
    checks.Near(
      row.ColorOf(3)[0], 0.5 * test::opacityOf(0.9, 2.0), test::OneStep, "of no category");
  }

  row.stage.mapper->SetReconstructionToBasis();
  test::Messages messages;
  row.Render();
  checks.Says(messages.TakeWarnings(), { "Colors of categories", "SetReconstructionToNearest" },
    "categories between cells");
  row.stage.Property()->GetRGBTransferFunction()->IndexedLookupOff();
  row.Check(checks, "no categories any more");
  row.stage.Property()->GetRGBTransferFunction()->IndexedLookupOn();
  row.stage.mapper->SetReconstructionToNearest();
  row.Check(checks, "nearest again");
}

void checkOpacities(test::Checks& checks)
{
  Row row(someValues);
  test::setConstantColor(row.stage.Property(), 0.0, { 1.0, 0.8, 0.6 });
  vtkPiecewiseFunction* opacity = row.stage.Property()->GetScalarOpacity();
  const auto addOpacities = [&](double midpoint, double sharpness)
  {
    opacity->RemoveAllPoints();
    opacity->AddPoint(0.1, 0.9, midpoint, sharpness);
    opacity->AddPoint(4.0, 0.0, midpoint, sharpness);
    opacity->AddPoint(9.5, 0.0, midpoint, sharpness);
    opacity->AddPoint(100.0, 0.4, midpoint, sharpness);
  };
  addOpacities(0.5, 0.0);
  for (const double unit : { 0.1, 1.0, 2.0, 30.0 })
  {
    row.stage.Property()->SetScalarOpacityUnitDistance(unit);
    row.Check(checks, "unit distance " + std::to_string(unit));
  }
  row.stage.Property()->SetScalarOpacityUnitDistance(1.0);
  opacity->ClampingOff();
  row.Check(checks, "opacity without clamping");
  checks.Expect(row.ColorOf(0)[0] == 0.0 && row.ColorOf(14)[0] == 0.0, "nothing outside of nodes");
  opacity->ClampingOn();
  opacity->SetUseLogScale(true);
  row.Check(checks, "logarithmic opacity");
  opacity->SetUseLogScale(false);
  for (const double midpoint : { 0.2, 0.8 })
  {
    for (const double sharpness : { 0.0, 0.4, 1.0 })
    {
      addOpacities(midpoint, sharpness);
      row.Check(checks,
        "opacity midpoint " + std::to_string(midpoint) + ", sharpness " +
          std::to_string(sharpness));
    }
  }
}

// What VTK's mappers lose between two entries of their tables is drawn here, and is not skipped.
void checkSpike(test::Checks& checks)
{
  Row row({ 0.0, 0.31416, 0.5, 1.0 });
  test::setConstantColor(row.stage.Property(), 0.0);
  vtkPiecewiseFunction* opacity = row.stage.Property()->GetScalarOpacity();
  opacity->AddPoint(0.31416 - 0.5e-4, 0.0);
  opacity->AddPoint(0.31416, 0.5);
  opacity->AddPoint(0.31416 + 0.5e-4, 0.0);
  row.Check(checks, "spike");
  checks.Near(row.ColorOf(1)[0], 0.75, test::OneStep, "opacity of the spike");

  // Where nothing has an opacity nothing is drawn, and no region is left.
  opacity->RemovePoint(0.31416);
  row.Check(checks, "no spike");
  checks.Equal(row.stage.mapper->GetNumberOfActiveRegions(), 0, "active regions without the spike");
}
}

int TestTransferFunctions(int, char*[])
{
  test::Checks checks;
  const test::KeepDisplay display;
  checkColors(checks);
  checkSteps(checks);
  checkCategories(checks);
  checkOpacities(checks);
  checkSpike(checks);
  return checks.Status();
}
