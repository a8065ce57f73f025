// SPDX-License-Identifier: BSD-3-Clause
// What VTK expects of any volume mapper: bounds, events, time to draw, selection, printing, and
// setters that keep to their ranges.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkExaBricksSceneSource.h"

#include "vtkBoundingBox.h"
#include "vtkCallbackCommand.h"
#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"
#include "vtkHardwareSelector.h"
#include "vtkObjectFactory.h"
#include "vtkSelection.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <sstream>

namespace
{
void record(vtkObject*, unsigned long event, void* list, void*)
{
  static_cast<std::vector<unsigned long>*>(list)->push_back(event);
}

// A window that does not draw with OpenGL.
class OtherWindow : public vtkRenderWindow
{
public:
  static OtherWindow* New();
  vtkTypeMacro(OtherWindow, vtkRenderWindow);
};
vtkStandardNewMacro(OtherWindow);

// Takes the mapper's array away, so that what it has just brought up to date fails.
void spoil(vtkObject* caller, unsigned long, void*, void*)
{
  auto* mapper = vtkExaBricksVolumeMapper::SafeDownCast(caller);
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectScalarArray("there is none");
  mapper->Update();
}

std::string print(vtkObject* object)
{
  std::ostringstream text;
  object->Print(text);
  return text.str();
}
}

int TestMapperInterface(int, char*[])
{
  test::Checks checks;
  test::Stage stage(50);
  vtkExaBricksVolumeMapper* mapper = stage.mapper;

  // Bounds: none without data, those of the AMR as soon as its source can tell them.
  vtkNew<vtkTrivialProducer> producer;
  checks.Expect(!vtkBoundingBox::IsValid(mapper->GetBounds()), "bounds without input");
  producer->SetOutput(vtkNew<vtkOverlappingAMR>());
  mapper->SetInputConnection(producer->GetOutputPort());
  checks.Expect(
    !vtkBoundingBox::IsValid(mapper->GetBounds()), "bounds of an AMR never initialised");
  const test::Lattice lattice{ { -4.0, 0.0, 1.0 }, { 0.5, 1.0, 2.0 } };
  // What programs ask their image for, an AMR of one block tells.
  const std::vector<test::Block> one{ { 0, { 0, 0, 0 }, { 8, 8, 8 } } };
  producer->SetOutput(test::makeAMR(one, [](double x, double, double) { return 2.0 * x; }));
  checks.Expect(mapper->GetInput() != nullptr, "the input of one block");
  if (mapper->GetInput())
  {
    checks.Equal(mapper->GetInput()->GetScalarRange()[0], 1.0, "its least value");
    checks.Equal(mapper->GetInput()->GetScalarRange()[1], 15.0, "its greatest value");
  }
  vtkNew<vtkExaBricksSceneSource> source;
  mapper->SetInputConnection(source->GetOutputPort());
  mapper->GetInput();
  checks.Expect(
    vtkOverlappingAMR::SafeDownCast(source->GetOutputDataObject(0))->GetNumberOfLevels() > 0,
    "an input comes up to date when it is asked for");
  mapper->SetInputConnection(producer->GetOutputPort());
  producer->SetOutput(test::makeAMR(test::cornerRefined(), test::constant(1.0), lattice));
  producer->Update();
  checks.Expect(!mapper->GetInput(), "an AMR of several blocks is no data set");
  const double expected[6] = { -4.0, 0.0, 0.0, 8.0, 1.0, 17.0 };
  double bounds[6];
  mapper->GetBounds(bounds);
  for (int i = 0; i < 6; ++i)
  {
    checks.Near(bounds[i], expected[i], 1e-12, "bound " + std::to_string(i));
    checks.Near(stage.volume->GetBounds()[i], expected[i], 1e-12, "bound of the volume");
  }

  // Events and time.
  test::setConstantColor(stage.Property(), 0.02);
  stage.renderer->ResetCamera();
  const test::Picture first(stage.window);
  checks.Near(first.Center()[0], test::opacityOf(0.02, 16.0), test::OneStep, "middle");
  checks.Equal(first.At(0, 0)[0], 0.0, "corner");
  std::vector<unsigned long> events;
  vtkNew<vtkCallbackCommand> recorder;
  recorder->SetCallback(record);
  recorder->SetClientData(&events);
  mapper->AddObserver(vtkCommand::VolumeMapperRenderStartEvent, recorder);
  mapper->AddObserver(vtkCommand::VolumeMapperRenderEndEvent, recorder);
  for (int i = 0; i < 2; ++i)
  {
    events.clear();
    checks.Equal(test::Picture(stage.window).Difference(first), 0.0, "the same picture");
    checks.Expect(events ==
        std::vector<unsigned long>{
          vtkCommand::VolumeMapperRenderStartEvent, vtkCommand::VolumeMapperRenderEndEvent },
      "one start event and one end event for a picture");
    checks.Expect(mapper->GetTimeToDraw() > 0.0, "time to draw");
  }
  checks.Expect(
    mapper->GetMarchTime() > 0.0 && mapper->GetUploadTime() > 0.0, "times of the parts");

  // Nothing is made again for another picture, nor bricks for other colours.
  const vtkMTimeType made = mapper->GetBuilder()->GetOutput()->GetMTime();
  stage.Property()->GetRGBTransferFunction()->AddRGBPoint(2.0, 0.0, 1.0, 0.0);
  const test::Picture still(stage.window);
  checks.Near(still.Center()[0], 0.5 * test::opacityOf(0.02, 16.0), test::OneStep, "new colours");
  checks.Equal(mapper->GetBuilder()->GetOutput()->GetMTime(), made, "time of the builder's output");

  // Selection: the volume is found, and colours are not taken for ids.
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(stage.renderer);
  selector->SetArea(0, 0, 49, 49);
  auto selected = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  checks.Equal(selected->GetNumberOfNodes(), 1, "props in a selection");
  checks.Equal(test::Picture(stage.window).Difference(still), 0.0, "drawn again after a selection");

  // An aborted picture draws nothing and crashes nothing.
  stage.window->SetAbortRender(1);
  mapper->Render(stage.renderer, stage.volume);
  stage.window->SetAbortRender(0);
  checks.Expect(!mapper->GetDrawn(), "not drawn: aborted");

  // Progress is told between the pieces of a picture, and whoever hears it may abort there.
  vtkNew<vtkCallbackCommand> abortAtFirst;
  abortAtFirst->SetCallback(
    [](vtkObject*, unsigned long, void* window, void* done)
    {
      if (*static_cast<double*>(done) > 0.0)
      {
        static_cast<vtkRenderWindow*>(window)->SetAbortRender(1);
      }
    });
  abortAtFirst->SetClientData(stage.window);
  const unsigned long tag =
    mapper->AddObserver(vtkCommand::VolumeMapperRenderProgressEvent, abortAtFirst);
  mapper->Render(stage.renderer, stage.volume);
  checks.Expect(stage.window->GetAbortRender() != 0, "progress was told");
  checks.Expect(!mapper->GetDrawn(), "not drawn: aborted on its way");
  mapper->RemoveObserver(tag);
  stage.window->SetAbortRender(0);
  checks.Equal(test::Picture(stage.window).Difference(still), 0.0, "drawn again after an abort");

  // Whether the volume is in the last picture, also where VTK does not call the mapper for it.
  test::Picture(stage.window);
  checks.Expect(mapper->GetDrawn(), "drawn");
  stage.volume->VisibilityOff();
  checks.Equal(test::Picture(stage.window).Coverage(), 0.0, "invisible");
  checks.Expect(!mapper->GetDrawn(), "not drawn: invisible");
  stage.volume->VisibilityOn();
  test::Picture(stage.window);
  checks.Expect(mapper->GetDrawn(), "drawn: visible again");
  stage.renderer->DrawOff();
  checks.Expect(!mapper->GetDrawn(), "not drawn: its renderer does not draw");
  stage.renderer->DrawOn();
  test::Picture(stage.window);
  vtkCamera* camera = stage.renderer->GetActiveCamera();
  camera->Yaw(180.0);
  checks.Equal(test::Picture(stage.window).Coverage(), 0.0, "out of sight");
  checks.Expect(!mapper->GetDrawn(), "not drawn: out of sight");
  camera->Yaw(180.0);
  test::Picture(stage.window);
  checks.Expect(mapper->GetDrawn(), "drawn: in sight again");
  stage.renderer->RemoveVolume(stage.volume);
  test::Picture(stage.window);
  checks.Expect(!mapper->GetDrawn(), "not drawn: removed");
  {
    test::Stage second(50);
    second.renderer->RemoveVolume(second.volume);
    second.renderer->AddVolume(stage.volume);
    second.renderer->ResetCamera();
    test::Picture(second.window);
    checks.Expect(mapper->GetDrawn(), "drawn: in another window");
  }
  checks.Expect(!mapper->GetDrawn(), "not drawn: the other window is gone");
  stage.renderer->AddVolume(stage.volume);

  // A window that does not draw with OpenGL, and an update that fails after the start event.
  {
    test::Messages messages;
    vtkNew<OtherWindow> otherWindow;
    vtkNew<vtkRenderer> otherRenderer;
    otherRenderer->SetRenderWindow(otherWindow);
    mapper->Render(otherRenderer, stage.volume);
    mapper->Render(otherRenderer, stage.volume);
    checks.Expect(!mapper->GetDrawn(), "not drawn: no OpenGL");
    checks.Equal(messages.Errors().size(), 1, "errors of another kind of window");
    checks.Says(messages.TakeErrors(), { "OpenGL", "OtherWindow" }, "another kind of window");
    checks.Equal(mapper->IsRenderSupported(otherWindow, nullptr), 0, "support without OpenGL");
    otherRenderer->SetRenderWindow(nullptr);

    vtkNew<vtkCallbackCommand> spoiler;
    spoiler->SetCallback(spoil);
    const unsigned long tag =
      mapper->AddObserver(vtkCommand::VolumeMapperRenderStartEvent, spoiler);
    checks.Equal(test::Picture(stage.window).Coverage(), 0.0, "an update that fails meanwhile");
    checks.Expect(!mapper->GetDrawn(), "not drawn: an update that fails meanwhile");
    checks.Says(messages.TakeErrors(), { "there is none" }, "an update that fails meanwhile");
    mapper->RemoveObserver(tag);
    mapper->SelectScalarArray("value");
    checks.Equal(test::Picture(stage.window).Difference(still), 0.0, "drawn after that");
    checks.Silent(messages.TakeErrors(), "no errors after that");
  }

  // Whether it can draw at all, before anything is drawn.
  {
    test::Messages messages;
    vtkNew<vtkExaBricksVolumeMapper> fresh;
    checks.Equal(fresh->IsRenderSupported(stage.window, stage.Property()), 1, "support");
    checks.Equal(fresh->IsRenderSupported(nullptr, nullptr), 0, "support without a window");
    fresh->SetDevice("abacus");
    checks.Equal(fresh->IsRenderSupported(stage.window, nullptr), 0, "support without the device");
    checks.Silent(messages.TakeErrors(), "asking is no error");
  }

  // Ranges of the setters.
  checks.Equal(mapper->GetStepScale(), 1.0, "default step scale");
  mapper->SetStepScale(0.0);
  checks.Equal(mapper->GetStepScale(), 0.001, "least step scale");
  mapper->SetStepScale(1e9);
  checks.Equal(mapper->GetStepScale(), 1000.0, "greatest step scale");
  checks.Equal(mapper->GetErrorTolerance(), 0.0, "default error tolerance");
  mapper->SetErrorTolerance(-1.0);
  checks.Equal(mapper->GetErrorTolerance(), 0.0, "least error tolerance");
  mapper->SetErrorTolerance(7.0);
  checks.Equal(mapper->GetErrorTolerance(), 1.0, "greatest error tolerance");
  checks.Equal(mapper->GetEarlyTerminationOpacity(), 0.999, "default early termination");
  mapper->SetEarlyTerminationOpacity(2.0);
  checks.Equal(mapper->GetEarlyTerminationOpacity(), 1.0, "greatest early termination");
  mapper->SetReconstruction(17);
  checks.Expect(mapper->GetReconstructionAsString() == std::string("Completed"), "reconstruction");
  mapper->SetTraversal(-1);
  checks.Expect(mapper->GetTraversalAsString() == std::string("Automatic"), "traversal");
  mapper->SetVectorComponent(-3);
  checks.Equal(mapper->GetVectorComponent(), 0, "least component");

  // Printing names every member.
  checks.Says(print(mapper),
    { "Reconstruction: Completed", "StepScale: 1000", "ErrorTolerance: 1", "Traversal: Automatic",
      "EarlyTerminationOpacity: 1", "VectorMode: Disabled", "VectorComponent: 0", "Device: (best)",
      "DeviceName: ", "TraversalUsed: ", "NumberOfActiveRegions: ", "LevelsLeftOut: 0",
      "NumberOfRays: ", "DeviceMemory: " },
    "print of the mapper");
  checks.Says(print(mapper->GetBuilder()),
    { "VectorMode: Disabled", "VectorComponent: 0", "NumberOfStructureBuilds: 1" },
    "print of the builder");
  checks.Says(print(mapper->GetBuilder()->GetOutput()),
    { "Levels: 2", "Blocks: 2", "LeafCells: 960", "Bricks: ", "Regions: ", "ArrayName: value",
      "ScalarRange: 1, 1" },
    "print of the data");
  checks.Says(
    print(vtkSmartPointer<vtkExaBricksData>::New()), { "ArrayName: (none)" }, "empty data");
  checks.Says(print(vtkSmartPointer<vtkExaBricksVolumeMapper>::New()), { "TraversalUsed: none" },
    "new mapper");
  return checks.Status();
}
