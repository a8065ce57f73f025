// SPDX-License-Identifier: BSD-3-Clause
// What the mapper does not do, it says: an error with the name of a blend mode or device that it
// cannot use, a warning, once, for settings that it draws without.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkImageData.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
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

  const std::pair<int, const char*> modes[] = {
    { vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, "maximum intensity" },
    { vtkVolumeMapper::MINIMUM_INTENSITY_BLEND, "minimum intensity" },
    { vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, "average intensity" },
    { vtkVolumeMapper::ADDITIVE_BLEND, "additive" },
    { vtkVolumeMapper::ISOSURFACE_BLEND, "iso-surface" }, { vtkVolumeMapper::SLICE_BLEND, "slice" }
  };
  for (const auto& mode : modes)
  {
    mapper->SetBlendMode(mode.first);
    checks.Equal(
      test::Picture(stage.window).Coverage(), 0.0, std::string(mode.second) + " draws nothing");
    checks.Equal(messages.Errors().size(), 1, std::string("errors of ") + mode.second);
    checks.Says(messages.TakeErrors(), { mode.second, "SetBlendModeToComposite" }, mode.second);
  }
  mapper->SetBlendModeToComposite();
  checks.Near(test::Picture(stage.window).Center()[0], drawn, test::OneStep, "composite is drawn");

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
    checks.Says(messages.TakeWarnings(), { word, "not supported yet" }, "warning of " + word);
  };
  vtkVolumeProperty* property = stage.Property();
  warnsOnce("Shading", [&] { property->ShadeOn(); });
  warnsOnce("Gradient opacity",
    [&]
    {
      vtkNew<vtkPiecewiseFunction> gradient;
      gradient->AddPoint(0.0, 0.0);
      gradient->AddPoint(1.0, 1.0);
      property->SetGradientOpacity(gradient);
    });
  warnsOnce("Cropping",
    [&]
    {
      mapper->CroppingOn();
      mapper->SetCroppingRegionPlanes(2.0, 3.0, 2.0, 3.0, 2.0, 3.0);
    });
  warnsOnce("Clipping planes",
    [&]
    {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(4.0, 4.0, 4.0);
      mapper->AddClippingPlane(plane);
    });
  warnsOnce("2-D transfer functions",
    [&]
    {
      vtkNew<vtkImageData> table;
      table->SetDimensions(2, 2, 1);
      table->AllocateScalars(VTK_FLOAT, 4);
      property->SetTransferFunction2D(table);
      property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
    });
  property->SetTransferFunctionMode(vtkVolumeProperty::TF_1D);
  checks.Expect(messages.Errors().empty(), "no errors: " + messages.TakeErrors());

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
  checks.Expect(messages.Errors().empty(), "no errors at the end: " + messages.TakeErrors());
  return checks.Status();
}
