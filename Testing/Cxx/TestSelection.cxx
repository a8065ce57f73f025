// SPDX-License-Identifier: BSD-3-Clause
// Selection: vtkHardwareSelector tells which cells of which blocks are seen in an area of the
// window, the same that vtkExaBricksPicker tells pixel by pixel.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkContourValues.h"
#include "vtkExaBricksPicker.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkPlane.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <set>

namespace
{
constexpr unsigned int Size = 60; // pixels

// A ball in a cube from 0 to 8 that is refined in the eighth at its lower corner.
double ball(double x, double y, double z) { return 4.0 - std::hypot(x - 3.7, y - 4.1, z - 4.3); }

struct Scene : test::Stage
{
  vtkNew<vtkHardwareSelector> selector;
  vtkNew<vtkExaBricksPicker> picker;

  Scene()
    : Stage(test::makeAMR(test::cornerRefined(), ball), Size)
  {
    vtkPiecewiseFunction* opacity = this->Property()->GetScalarOpacity();
    opacity->RemoveAllPoints();
    opacity->AddPoint(0.0, 0.0);
    opacity->AddPoint(4.0, 0.4);
    vtkCamera* camera = this->renderer->GetActiveCamera();
    camera->SetFocalPoint(4.0, 4.0, 4.0);
    camera->SetPosition(-12.0, -9.0, -14.0);
    camera->SetViewAngle(34.0);
    this->renderer->ResetCameraClippingRange();
    this->selector->SetRenderer(this->renderer);
    this->selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
    this->selector->SetArea(0, 0, Size - 1, Size - 1);
  }

  // Compares each third pixel with the picker, of which so large a part may differ: cells seen
  // edge on, and opacities of 0.05 but for rounding. Returns how many of them have a cell.
  int IsAsPicked(test::Checks& checks, const std::string& what, double mayDiffer = 0.03)
  {
    auto* amr = vtkOverlappingAMR::SafeDownCast(this->mapper->GetDataObjectInput());
    this->window->Render();
    checks.Expect(this->selector->CaptureBuffers(), what + ": selected");
    this->window->Render();
    int cells = 0;
    int others = 0;
    for (unsigned int y = 1; y < Size; y += 3)
    {
      for (unsigned int x = 1; x < Size; x += 3)
      {
        const unsigned int at[2] = { x, y };
        const vtkHardwareSelector::PixelInformation pixel = this->selector->GetPixelInformation(at);
        const bool selected = pixel.Valid && pixel.Prop == this->volume;
        const bool picked = this->picker->Pick(x, y, 0.0, this->renderer) != 0;
        cells += picked ? 1 : 0;
        const bool same = selected == picked &&
          (!picked ||
            (pixel.AttributeID == this->picker->GetCellId() &&
              pixel.CompositeID ==
                exabricks::numberOfBlock(amr, static_cast<unsigned int>(this->picker->GetLevel()),
                  static_cast<unsigned int>(this->picker->GetBlock()))));
        others += same ? 0 : 1;
      }
    }
    checks.Expect(cells > 30, what + ": pixels with cells, " + std::to_string(cells));
    checks.Expect(
      others <= mayDiffer * cells, what + ": pixels of other cells, " + std::to_string(others));
    return cells;
  }
};
}

int TestSelection(int, char*[])
{
  test::Checks checks;
  test::Messages messages;
  Scene scene;
  const int all = scene.IsAsPicked(checks, "composite");

  scene.renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.renderer->GetActiveCamera()->SetParallelScale(6.0);
  scene.renderer->ResetCameraClippingRange();
  scene.IsAsPicked(checks, "parallel projection");
  scene.renderer->GetActiveCamera()->ParallelProjectionOff();

  // The cells of an area, as a selection of the AMR: a node for each block.
  const auto x = Size / 2;
  scene.selector->SetArea(x - 4, x - 4, x + 4, x + 4);
  auto selection = vtkSmartPointer<vtkSelection>::Take(scene.selector->Select());
  std::set<int> blocks;
  for (unsigned int i = 0; i < selection->GetNumberOfNodes(); ++i)
  {
    vtkSelectionNode* node = selection->GetNode(i);
    checks.Equal(node->GetContentType(), int(vtkSelectionNode::INDICES), "cells by their numbers");
    blocks.insert(node->GetProperties()->Get(vtkSelectionNode::COMPOSITE_INDEX()));
    auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
    for (vtkIdType k = 0; ids && k < ids->GetNumberOfValues(); ++k)
    {
      checks.Expect(ids->GetValue(k) >= 0 && ids->GetValue(k) < 512, "a cell of a block");
    }
  }
  checks.Expect(blocks == std::set<int>{ 1 }, "the refined block is before the other");
  scene.selector->SetArea(0, 0, Size - 1, Size - 1);

  // Where the camera is in the volume.
  scene.renderer->GetActiveCamera()->SetPosition(2.0, 1.0, -0.5);
  scene.renderer->ResetCameraClippingRange();
  scene.IsAsPicked(checks, "from within the bounds");
  scene.renderer->GetActiveCamera()->SetPosition(-12.0, -9.0, -14.0);
  scene.renderer->ResetCameraClippingRange();

  // What is cut away, or hidden, is not selected.
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(4.0, 4.0, 4.0);
  plane->SetNormal(1.0, 0.0, 0.3);
  scene.mapper->AddClippingPlane(plane);
  scene.IsAsPicked(checks, "clipped");
  scene.mapper->RemoveAllClippingPlanes();
  const auto actor = test::addBox(scene.renderer, -1.0, 4.0, -1.0, 3.0, -1.5, -1.0);
  scene.renderer->ResetCameraClippingRange();
  checks.Expect(scene.IsAsPicked(checks, "beside geometry") < all, "some is hidden");
  scene.renderer->RemoveActor(actor);
  scene.renderer->ResetCameraClippingRange();

  scene.mapper->SetBlendModeToMaximumIntensity();
  scene.IsAsPicked(checks, "maximum", 0.1); // which is flat where it is
  scene.mapper->SetBlendModeToIsoSurface();
  scene.Property()->GetIsoSurfaceValues()->SetValue(0, 1.2);
  scene.IsAsPicked(checks, "an iso-surface");
  scene.mapper->SetBlendModeToSlice();
  plane->SetNormal(1.0, 1.0, 1.0);
  scene.Property()->SetSliceFunction(plane);
  scene.IsAsPicked(checks, "a slice");
  scene.mapper->SetBlendModeToComposite();

  // A volume has no points to select.
  scene.selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  scene.window->Render();
  selection = vtkSmartPointer<vtkSelection>::Take(scene.selector->Select());
  checks.Equal(selection->GetNumberOfNodes(), 0, "no points");

  checks.Silent(messages.TakeErrors() + messages.TakeWarnings(), "nothing to say");
  return checks.Status();
}
