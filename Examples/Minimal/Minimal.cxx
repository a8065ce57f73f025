// SPDX-License-Identifier: BSD-3-Clause
// Opens a .vthb file and shows one of its arrays as a volume, in a window to turn with the mouse.
//   Minimal Testing/Data/rt_medium/rt_medium.vthb magvort

#include "vtkCallbackCommand.h"
#include "vtkColorTransferFunction.h"
#include "vtkCommand.h"
#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"
#include "vtkExaBricksVolumeMapper.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkXMLUniformGridAMRReader.h"

#include <cstdlib>
#include <exception>
#include <iostream>

// VTK before 9.4 aborts the program after an error of its window; this ends it before, with words.
void endWithoutDisplay(vtkObject*, unsigned long, void*, void* message)
{
  std::cerr
    << static_cast<const char*>(message)
    << "Minimal needs a display to draw in. Without one, run it as xvfb-run -a Minimal ...\n";
  std::_Exit(1);
}

int main(int argc, char** argv)
{
  if (argc != 3)
  {
    std::cerr << "usage: Minimal FILE.vthb ARRAY\n";
    return 2;
  }
  vtkNew<vtkXMLUniformGridAMRReader> reader;
  reader->SetFileName(argv[1]);
  reader->SetMaximumLevelsToReadByDefault(0); // all of them

  vtkNew<vtkExaBricksVolumeMapper> mapper;
  mapper->SetInputConnection(reader->GetOutputPort());
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectScalarArray(argv[2]);
  try
  {
    mapper->Update();
  }
  catch (const std::exception& error) // of VTK's reader
  {
    std::cerr << argv[1] << " is damaged, or takes too much memory (" << error.what() << ")\n";
    return 1;
  }
  if (mapper->GetBuilder()->GetOutput()->GetNumberOfLeafCells() == 0)
  {
    return 1; // VTK has said why
  }
  double range[2];
  mapper->GetBuilder()->GetOutput()->GetScalarRange(range); // of the leaf cells
  double spacing[3];
  mapper->GetBuilder()->GetOutput()->GetFinestSpacing(spacing);

  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(range[0], 0.2, 0.3, 0.8);
  colors->AddRGBPoint(range[1], 1.0, 0.8, 0.3);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(range[0] + 0.1 * (range[1] - range[0]), 0.0);
  opacity->AddPoint(range[1], 0.2);

  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colors);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetInterpolationTypeToLinear(); // continuous, as the mapper draws it
  volume->GetProperty()->SetScalarOpacityUnitDistance(spacing[0]);

  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkCallbackCommand> onError;
  onError->SetCallback(endWithoutDisplay);
  window->AddObserver(vtkCommand::ErrorEvent, onError);
  window->SetSize(800, 600);
  window->AddRenderer(renderer);
  window->Render(); // before there is an interactor, which would not ask for the display
  if (!window->GetShowWindow())
  {
    std::cerr << "Drawn, but there is no display to show it on.\n"; // from VTK 9.4 on
    return 0;
  }
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Start();
  return 0;
}
