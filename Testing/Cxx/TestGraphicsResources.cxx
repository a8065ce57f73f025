// SPDX-License-Identifier: BSD-3-Clause
// Windows, mappers and graphics resources go away in any order, and come back.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include <memory>

namespace
{
constexpr double Opacity = 0.3;

std::unique_ptr<test::Stage> makeStage(vtkOverlappingAMR* amr)
{
  auto stage = std::make_unique<test::Stage>(amr, 40);
  test::setConstantColor(stage->Property(), Opacity);
  test::lookAlongZ(stage->renderer, 4.0, 4.0, 4.0, 8.0);
  return stage;
}
}

int TestGraphicsResources(int, char*[])
{
  test::Checks checks;
  const test::KeepDisplay display;
  auto amr = test::makeAMR(test::cornerRefined(), test::constant(1.0));
  auto stage = makeStage(amr);
  const auto draws = [&](vtkRenderWindow* window, const std::string& what)
  {
    checks.Near(
      test::Picture(window).Center()[0], test::opacityOf(Opacity, 8.0), test::OneStep, what);
  };

  // Released before anything was drawn, twice, and drawn again after that.
  stage->mapper->ReleaseGraphicsResources(stage->window);
  draws(stage->window, "after a release of nothing");
  checks.Expect(stage->mapper->GetDeviceMemory() > 0, "device memory in use");
  stage->mapper->ReleaseGraphicsResources(stage->window);
  stage->mapper->ReleaseGraphicsResources(stage->window);
  stage->mapper->ReleaseGraphicsResources(nullptr);
  draws(stage->window, "after a second release");

  // All of the window's resources, as when it is hidden or embedded elsewhere.
  stage->window->Finalize();
  draws(stage->window, "after the window was finalised");

  // The window goes first: its mapper draws in another one.
  vtkSmartPointer<vtkVolume> volume = stage->volume.Get();
  vtkSmartPointer<vtkExaBricksVolumeMapper> mapper = stage->mapper.Get();
  stage.reset();
  stage = makeStage(amr);
  stage->renderer->RemoveVolume(stage->volume);
  stage->renderer->AddVolume(volume);
  draws(stage->window, "in another window");

  // The mapper goes first.
  volume->SetMapper(nullptr);
  mapper = nullptr;
  stage->renderer->RemoveVolume(volume);
  volume = nullptr;
  checks.Equal(test::Picture(stage->window).Coverage(), 0.0, "nothing is left of the volume");
  stage->renderer->AddVolume(stage->volume);
  draws(stage->window, "another mapper in the same window");

  // One volume in two windows by turns.
  auto other = makeStage(amr);
  other->renderer->RemoveVolume(other->volume);
  other->renderer->AddVolume(stage->volume);
  for (int turn = 0; turn < 2; ++turn)
  {
    draws(stage->window, "in the first window");
    draws(other->window, "in the second window");
  }
  other.reset();
  draws(stage->window, "in the first window, the second gone");

  // Its renderer goes, its window stays.
  stage->window->RemoveRenderer(stage->renderer);
  stage->window->Render();
  stage->window->AddRenderer(stage->renderer);
  draws(stage->window, "the renderer is back");
  return checks.Status();
}
