// SPDX-License-Identifier: BSD-3-Clause
// Picking: VTK's pickers and selectors find the volume where it shows; vtkExaBricksPicker tells
// where it is first seen, and in which cell of the AMR.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkAssembly.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkContourValues.h"
#include "vtkExaBricksPicker.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkPlane.h"
#include "vtkProp3DCollection.h"
#include "vtkPropPicker.h"
#include "vtkRenderedAreaPicker.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkTransform.h"

namespace
{
constexpr int Size = 80; // pixels for a width of 16

// A cube from 0 to 8, refined in the eighth at its lower corner, seen from above: its pixels are
// from 20 to 60.
struct Scene : test::Stage
{
  vtkNew<vtkExaBricksPicker> picker;
  test::Checks& Checked;

  Scene(test::Checks& checks, const test::Field& field)
    : Stage(test::makeAMR(test::cornerRefined(), field), Size)
    , Checked(checks)
  {
    test::lookAlongZ(this->renderer, 4.0, 4.0, 4.0, 16.0);
  }

  // The middle of the pixel that shows (x, y).
  static double PixelOf(double x) { return (x + 4.0) / 16.0 * Size - 0.5; }

  bool Pick(double x, double y)
  {
    this->window->Render();
    return this->picker->Pick(PixelOf(x), PixelOf(y), 0.0, this->renderer) != 0;
  }

  // Picks at (x, y), and expects the volume there at a height.
  void PicksAt(double x, double y, double z, const std::string& what)
  {
    this->Checked.Expect(this->Pick(x, y), what + ": something is picked");
    vtkAssemblyPath* path = this->picker->GetPath();
    this->Checked.Expect(
      path && path->GetLastNode()->GetViewProp() == this->volume, what + ": the volume");
    const double* position = this->picker->GetPickPosition();
    this->Checked.Near(position[0], x, 1e-6, what + ": x");
    this->Checked.Near(position[1], y, 1e-6, what + ": y");
    this->Checked.Near(position[2], z, 1e-4, what + ": z");
  }

  void IsCell(
    int level, int block, const std::array<int, 3>& ijk, double value, const std::string& what)
  {
    this->Checked.Equal(this->picker->GetLevel(), level, what + ": level");
    this->Checked.Equal(this->picker->GetBlock(), block, what + ": block");
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Checked.Equal(this->picker->GetCellIJK()[axis], ijk[axis], what + ": index");
    }
    this->Checked.Equal(
      this->picker->GetCellId(), vtkIdType(ijk[0] + 8 * (ijk[1] + 8 * ijk[2])), what + ": id");
    this->Checked.Near(this->picker->GetValue(), value, 1e-5, what + ": value");
  }
};

double height(double, double, double z) { return z; }
}

int TestPicking(int, char*[])
{
  test::Checks checks;
  test::Messages messages;
  Scene scene(checks, height);
  scene.mapper->SetReconstructionToNearest();

  // Some opacity is reached on some way from the upper face down.
  test::setConstantColor(scene.Property(), 0.2);
  const double way = std::log(1.0 - 0.05) / std::log(1.0 - 0.2);
  scene.PicksAt(6.1, 6.1, 8.0 - way, "a twentieth of opacity");
  checks.Expect(scene.picker->GetVolume() == scene.volume, "the picked volume");
  scene.IsCell(0, 0, { 6, 6, 7 }, 7.5, "a coarse cell");
  scene.picker->SetVolumeOpacityIsovalue(0.75);
  scene.PicksAt(1.3, 2.7, 8.0 - std::log(0.25) / std::log(0.8), "three quarters of opacity");
  scene.IsCell(1, 0, { 2, 5, 3 }, 1.75, "a fine cell");
  scene.picker->SetVolumeOpacityIsovalue(0.95);
  checks.Expect(!scene.Pick(6.1, 6.1), "so much opacity is nowhere");
  checks.Equal(scene.picker->GetLevel(), -1, "no level");
  checks.Expect(std::isnan(scene.picker->GetValue()), "no value");
  scene.picker->SetVolumeOpacityIsovalue(0.05);
  checks.Expect(!scene.Pick(-2.0, 4.0), "beside the volume");

  // What is cut away is not picked, nor what is behind geometry.
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 5.0);
  plane->SetNormal(0.0, 0.0, -1.0);
  scene.mapper->AddClippingPlane(plane);
  scene.PicksAt(6.1, 6.1, 5.0 - way, "below a clipping plane");
  scene.mapper->RemoveAllClippingPlanes();
  const auto actor = test::addBox(scene.renderer, 5.0, 9.0, -1.0, 9.0, 8.5, 9.0);
  scene.renderer->ResetCameraClippingRange();
  checks.Expect(!scene.Pick(6.1, 6.1), "behind geometry");
  scene.PicksAt(1.3, 2.7, 8.0 - way, "beside geometry");

  // VTK's own: which prop shows there.
  vtkNew<vtkPropPicker> props;
  const auto prop = [&](double x, double y) -> vtkProp*
  {
    scene.window->Render();
    return props->Pick(Scene::PixelOf(x), Scene::PixelOf(y), 0.0, scene.renderer)
      ? props->GetViewProp()
      : nullptr;
  };
  checks.Expect(prop(1.3, 2.7) == scene.volume, "vtkPropPicker finds the volume");
  checks.Expect(prop(6.1, 2.7) == actor, "vtkPropPicker finds the actor before it");
  checks.Expect(prop(-2.0, 2.7) == nullptr, "vtkPropPicker finds nothing beside");
  vtkNew<vtkRenderedAreaPicker> area;
  area->AreaPick(Scene::PixelOf(1.0), Scene::PixelOf(1.0), Scene::PixelOf(7.0), Scene::PixelOf(7.0),
    scene.renderer);
  checks.Equal(area->GetProp3Ds()->GetNumberOfItems(), 2, "props in an area");
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  const auto x = [](double at) { return static_cast<unsigned int>(Scene::PixelOf(at)); };
  selector->SetArea(x(0.5), x(0.5), x(3.5), x(3.5));
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  checks.Equal(selection->GetNumberOfNodes(), 1, "nodes of a selection");
  checks.Expect(selection->GetNumberOfNodes() == 1 &&
      selection->GetNode(0)->GetProperties()->Get(vtkSelectionNode::PROP()) == scene.volume,
    "the selection is the volume");
  const test::Picture before(scene.window);
  scene.volume->PickableOff();
  checks.Expect(prop(1.3, 2.7) == nullptr, "vtkPropPicker leaves it out");
  checks.Expect(!scene.Pick(1.3, 2.7), "what is not pickable is not picked");
  scene.volume->PickableOn();
  checks.Equal(
    test::Picture(scene.window).Difference(before), 0.0, "picking leaves the picture alone");

  // Surfaces, and greatest values, where they are. The volume may be moved.
  Scene smooth(checks,
    [](double px, double py, double pz)
    { return 10.0 - std::abs(pz - 5.2) - 0.1 * px - 0.1 * py; });
  test::setConstantColor(smooth.Property(), 0.5);
  smooth.mapper->SetBlendModeToMaximumIntensity();
  smooth.Property()->GetRGBTransferFunction()->AddRGBPoint(10.0, 0.0, 1.0, 0.0);
  checks.Expect(smooth.Pick(6.1, 6.1), "a maximum is picked");
  checks.Near(smooth.picker->GetPickPosition()[2], 5.5, 0.5, "in the cell of the maximum");
  Scene layers(checks, height);
  test::setConstantColor(layers.Property(), 0.5);
  layers.mapper->SetBlendModeToIsoSurface();
  layers.Property()->GetIsoSurfaceValues()->SetValue(0, 3.3);
  layers.PicksAt(6.1, 6.1, 3.3, "an iso-surface");
  vtkNew<vtkTransform> moved;
  moved->Translate(0.0, 0.0, 2.0);
  layers.volume->SetUserTransform(moved);
  layers.PicksAt(6.1, 6.1, 5.3, "a moved one");
  layers.IsCell(0, 0, { 6, 6, 3 }, 3.5, "the same cell");

  // An assembly moves its parts, and is the first of the picked path.
  vtkNew<vtkAssembly> assembly;
  layers.renderer->RemoveVolume(layers.volume);
  assembly->AddPart(layers.volume);
  assembly->SetPosition(0.0, 0.0, 1.0);
  layers.renderer->AddActor(assembly);
  layers.PicksAt(6.1, 6.1, 6.3, "a part of an assembly");
  checks.Expect(layers.picker->GetAssembly() == assembly, "the assembly is picked");
  assembly->PickableOff();
  checks.Expect(!layers.Pick(6.1, 6.1), "an assembly that is not pickable");

  // Opaque cells: the cell that is seen, not the transparent one in front of it, from any side.
  Scene cells(checks,
    [](double px, double py, double pz)
    { return std::hypot(px - 4.0, py - 4.0, pz - 4.0) < 3.0 ? 1.0 : 0.0; });
  cells.mapper->SetReconstructionToNearest();
  cells.Property()->GetRGBTransferFunction()->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  cells.Property()->GetScalarOpacity()->AddPoint(0.5, 0.0);
  cells.Property()->GetScalarOpacity()->AddPoint(0.6, 1.0);
  for (int side = 0; side < 6; ++side)
  {
    vtkCamera* camera = cells.renderer->GetActiveCamera();
    camera->Azimuth(61.0);
    camera->Elevation(side % 2 == 0 ? 33.0 : -33.0);
    camera->OrthogonalizeViewUp();
    cells.renderer->ResetCameraClippingRange();
    cells.window->Render();
    for (int at = 30; at < 52; at += 3)
    {
      checks.Expect(cells.picker->Pick(at, 81 - at, 0.0, cells.renderer) != 0, "a cell is picked");
      checks.Equal(cells.picker->GetValue(), 1.0, "the cell that is seen");
    }
  }

  checks.Silent(messages.TakeErrors() + messages.TakeWarnings(), "nothing to say");
  checks.Equal(cells.picker->Pick(1.0, 1.0, 0.0, nullptr), 0, "no renderer");
  checks.Says(messages.TakeErrors(), { "renderer", "found none" }, "no renderer");
  vtkNew<vtkRenderer> alone;
  checks.Equal(cells.picker->Pick(1.0, 1.0, 0.0, alone), 0, "no window");
  checks.Says(messages.TakeErrors(), { "without a window" }, "no window");
  return checks.Status();
}
