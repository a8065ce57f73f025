// SPDX-License-Identifier: BSD-3-Clause
// What the mapper does not do, it says: an error with the name of a blend mode or device that it
// cannot use, a warning, once, for settings that it draws without.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkMultiVolume.h"
#include "vtkShaderProperty.h"
#include "vtkStringArray.h"

int TestUnsupportedRequests(int, char*[])
{
  test::Checks checks;
  test::Messages messages;
  test::Stage stage(test::makeAMR(test::cornerRefined(), test::constant(1.0)), 50);
  test::setConstantColor(stage.Property(), 0.5);
  test::lookAlongZ(stage.renderer, 4.0, 4.0, 4.0, 8.0);
  vtkExaBricksVolumeMapper* mapper = stage.mapper;
  const double drawn = test::opacityOf(0.5, 8.0);

  mapper->SetBlendMode(17);
  for (int i = 0; i < 3; ++i)
  {
    checks.Equal(
      test::Picture(stage.window).Coverage(), 0.0, "an unknown blend mode draws nothing");
    checks.Expect(!mapper->GetDrawn(), "not drawn");
  }
  checks.Equal(messages.Errors().size(), 1, "errors of an unknown blend mode");
  checks.Says(messages.TakeErrors(), { "17", "SetBlendModeToComposite" }, "an unknown blend mode");
  mapper->SetBlendModeToComposite();
  checks.Near(test::Picture(stage.window).Center()[0], drawn, test::OneStep, "composite is drawn");

  // Data of which nothing can show.
  test::Stage nowhere(test::makeAMR(test::cornerRefined(), test::constant(std::nan(""))), 20);
  test::setConstantColor(nowhere.Property(), 0.5);
  test::Picture(nowhere.window);
  test::Picture(nowhere.window);
  checks.Equal(messages.Warnings().size(), 1, "warnings of data without values");
  checks.Says(messages.TakeWarnings(), { "No cell", "finite value" }, "data without values");

  vtkNew<vtkMultiVolume> several;
  mapper->Render(stage.renderer, several);
  checks.Says(messages.TakeErrors(), { "vtkMultiVolume", "Add a vtkVolume" }, "a vtkMultiVolume");
  checks.Near(test::Picture(stage.window).Center()[0], drawn, test::OneStep, "a volume is drawn");

  // Gradients count for absorption alone.
  vtkNew<vtkPiecewiseFunction> gradients;
  gradients->AddPoint(0.0, 0.5);
  stage.Property()->SetGradientOpacity(gradients);
  mapper->SetBlendModeToMaximumIntensity();
  test::Picture(stage.window);
  checks.Says(messages.TakeWarnings(), { "Gradient opacity", "composite" }, "gradient opacity");
  mapper->SetBlendModeToComposite();
  stage.Property()->SetGradientOpacity(nullptr);

  // A copy of a property has a function of gradients that changes nothing, and warns of nothing.
  vtkSmartPointer<vtkVolumeProperty> property = stage.Property();
  vtkNew<vtkVolumeProperty> copy;
  copy->DeepCopy(property);
  stage.volume->SetProperty(copy);
  checks.Expect(copy->HasGradientOpacity(), "a copy has a function of gradients");
  checks.Near(test::Picture(stage.window).Center()[0], drawn, test::OneStep, "with a copy");
  checks.Silent(messages.TakeWarnings(), "no warnings of a copy");
  stage.volume->SetProperty(property);

  // Of data much smaller than the default unit distance nothing would be seen.
  {
    const test::Lattice small{ { 0.0, 0.0, 0.0 }, { 1e-3, 1e-3, 1e-3 } };
    test::Stage faint(test::makeAMR(test::cornerRefined(), test::constant(1.0), small), 20);
    test::setConstantColor(faint.Property(), 0.5);
    test::lookAlongZ(faint.renderer, 4e-3, 4e-3, 4e-3, 8e-3);
    test::Picture(faint.window);
    faint.Property()->GetScalarOpacity()->AddPoint(2.0, 0.6);
    test::Picture(faint.window);
    checks.Equal(messages.Warnings().size(), 1, "warnings of a volume next to transparent");
    checks.Says(messages.TakeWarnings(),
      { "nearly transparent", "SetScalarOpacityUnitDistance", "0.00028" }, "next to transparent");
    faint.Property()->SetScalarOpacityUnitDistance(0.00028);
    checks.Expect(test::Picture(faint.window).Center()[0] > 0.5, "it shows with that distance");
    checks.Silent(messages.TakeWarnings(), "nothing to say");
  }

  // Each said once, over several pictures, and drawn without.
  const auto warnsOnce = [&](const std::string& word, const std::function<void()>& set)
  {
    set();
    for (int i = 0; i < 3; ++i)
    {
      checks.Near(
        test::Picture(stage.window).Center()[0], drawn, test::OneStep, "drawn without " + word);
    }
    checks.Equal(messages.Warnings().size(), 1, "warnings of " + word);
    checks.Says(messages.TakeWarnings(), { word, "is drawn w" }, "warning of " + word);
  };
  warnsOnce("vtkShaderProperty",
    [&]
    {
      stage.volume->GetShaderProperty()->AddFragmentShaderReplacement(
        "//VTK::Base::Impl", true, "discard;", false);
    });
  stage.volume->GetShaderProperty()->ClearAllShaderReplacements();
  warnsOnce(
    "Colors of categories", [&] { property->GetRGBTransferFunction()->SetIndexedLookup(true); });
  property->GetRGBTransferFunction()->SetIndexedLookup(false);
  warnsOnce("ClippedVoxelIntensity", [&] { property->UseClippedVoxelIntensityOn(); });
  property->UseClippedVoxelIntensityOff();
  {
    test::Stage coded(test::makeAMR(test::cornerRefined(), test::constant(1.0)), 20);
    coded.volume->GetShaderProperty()->SetFragmentShaderCode("void main() {}");
    test::Picture(coded.window);
    checks.Says(messages.TakeWarnings(), { "vtkShaderProperty", "without" }, "code of a shader");
  }

  checks.Silent(messages.TakeErrors(), "no errors");

  // Devices are named in the error, to choose from.
  vtkNew<vtkStringArray> devices;
  vtkExaBricksVolumeMapper::GetDevices(devices);
  checks.Expect(devices->GetNumberOfValues() > 0, "there is a device");
  mapper->SetDevice("abacus");
  checks.Equal(test::Picture(stage.window).Coverage(), 0.0, "no device draws nothing");
  checks.Equal(messages.Errors().size(), 1, "errors of a wrong device");
  const std::string inUse = [&]
  {
    mapper->SetDevice("");
    test::Picture picture(stage.window);
    checks.Near(picture.Center()[0], drawn, test::OneStep, "the best device draws");
    return mapper->GetDeviceName();
  }();
  checks.Says(messages.TakeErrors(), { "abacus", inUse }, "a wrong device");
  checks.Expect(devices->GetValue(0).find("0") == 0, "lines of devices begin with their index");

  // By index and by a part of the name.
  mapper->SetDevice("0");
  checks.Near(test::Picture(stage.window).Center()[0], drawn, test::OneStep, "device by index");
  mapper->SetDevice(inUse.substr(0, 6).c_str());
  checks.Near(test::Picture(stage.window).Center()[0], drawn, test::OneStep, "device by name");
  checks.Silent(messages.TakeErrors(), "no errors at the end");
  return checks.Status();
}
