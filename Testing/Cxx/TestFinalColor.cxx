// SPDX-License-Identifier: BSD-3-Clause
// Window and level of the picture's colours, and colours of values below and above the range of the
// colour function.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include <limits>

int TestFinalColor(int, char*[])
{
  test::Checks checks;
  test::Messages messages;
  constexpr double opacity = 0.5;

  // A colour of 0.6 at half of opacity, in front of white.
  test::Stage stage(test::makeAMR(test::cornerRefined(), test::constant(1.0)), 20);
  test::setConstantColor(stage.Property(), opacity, { 0.6, 0.2, 0.0 });
  stage.Property()->SetScalarOpacityUnitDistance(8.0);
  stage.renderer->SetBackground(1.0, 1.0, 1.0);
  test::lookAlongZ(stage.renderer, 4.0, 4.0, 4.0, 4.0);
  const auto shows = [&](double red, double green, double blue, const std::string& what)
  {
    const test::Picture::Color color = test::Picture(stage.window).Center();
    checks.Near(color[0], 0.5 + opacity * red, test::OneStep, what + ", red");
    checks.Near(color[1], 0.5 + opacity * green, test::OneStep, what + ", green");
    checks.Near(color[2], 0.5 + opacity * blue, test::OneStep, what + ", blue");
  };
  shows(0.6, 0.2, 0.0, "as it is");
  stage.mapper->SetFinalColorWindow(2.0);
  shows(0.3 + 0.25, 0.1 + 0.25, 0.25, "a wide window");
  stage.mapper->SetFinalColorWindow(0.5);
  stage.mapper->SetFinalColorLevel(0.4);
  shows(1.2 - 0.3, 0.4 - 0.3, 0.0, "a narrow one");
  stage.mapper->SetFinalColorWindow(0.0);
  test::Picture(stage.window);
  checks.Says(messages.TakeErrors(), { "FinalColorWindow", "not 0" }, "no window");
  stage.mapper->SetFinalColorWindow(-1.0);
  stage.mapper->SetFinalColorLevel(-0.5);
  shows(0.0, 0.0, 0.0, "below black");
  stage.mapper->SetFinalColorLevel(std::numeric_limits<double>::infinity());
  test::Picture(stage.window);
  checks.Says(messages.TakeErrors(), { "FinalColorLevel", "inf" }, "an infinite level");

  // Values 0, 1 and 2, side by side, of which the function has 0.5 to 1.5.
  test::Stage three(test::makeAMR({ { 0, { 0, 0, 0 }, { 3, 1, 1 } } },
                      [](double x, double, double) { return std::floor(x); }),
    30);
  three.mapper->SetReconstructionToNearest();
  test::lookAlongZ(three.renderer, 1.5, 0.5, 0.5, 3.0);
  vtkColorTransferFunction* colors = three.Property()->GetRGBTransferFunction();
  colors->AddRGBPoint(0.5, 0.0, 0.0, 0.5);
  colors->AddRGBPoint(1.5, 0.0, 0.5, 0.0);
  three.Property()->GetScalarOpacity()->AddPoint(0.0, 1.0);
  const auto side = [&](double red, int pixel, const std::string& what) {
    checks.Near(test::Picture(three.window).At(pixel, 15)[0], red, test::OneStep, what + ", red");
  };
  side(0.0, 5, "below, as the first");
  side(0.0, 25, "above, as the last");
  colors->SetBelowRangeColor(0.8, 0.0, 0.0);
  colors->UseBelowRangeColorOn();
  colors->SetAboveRangeColor(0.4, 0.0, 0.0);
  colors->UseAboveRangeColorOn();
  side(0.8, 5, "below");
  side(0.0, 15, "within");
  side(0.4, 25, "above");
  checks.Silent(messages.TakeErrors() + messages.TakeWarnings(), "nothing to say");
  return checks.Status();
}
