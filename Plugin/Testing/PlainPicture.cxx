// SPDX-License-Identifier: BSD-3-Clause
// PlainPicture <picture.png> <leaf cells> <width> <height> <unit distance> <reconstruction>
// <position> <focal point> <view up> (three numbers each) <angle> <blend mode>
//
// The scene Exajet-wing through plain VTK, without ParaView, with the transfer function of
// Support.py: what the picture through ParaView is compared with.
#include "vtkExaBricksSceneSource.h"
#include "vtkExaBricksVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkWindowToImageFilter.h"

#include <cstdlib>
#include <iostream>
#include <vector>

int main(int argc, char** argv)
{
  if (argc != 18)
  {
    std::cerr << "expected 17 arguments, found " << argc - 1 << "\n";
    return EXIT_FAILURE;
  }
  std::vector<double> values;
  for (int i = 2; i < argc; ++i)
  {
    values.push_back(std::atof(argv[i]));
  }
  vtkNew<vtkExaBricksSceneSource> source;
  source->SetSceneToExajetWing();
  source->SetNumberOfLeafCells(static_cast<vtkIdType>(values[0]));

  vtkNew<vtkExaBricksVolumeMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectScalarArray("value");
  mapper->SetReconstruction(static_cast<int>(values[4]));
  mapper->SetBlendMode(static_cast<int>(values[15]));

  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.1, 0.2, 0.8);
  color->AddRGBPoint(0.4, 1.0, 0.9, 0.6);
  color->AddRGBPoint(1.0, 1.0, 0.2, 0.1);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(0.1, 0.0);
  opacity->AddPoint(1.0, 0.6);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(color);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetScalarOpacityUnitDistance(values[3]);

  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetOffScreenRendering(1);
  window->SetSize(static_cast<int>(values[1]), static_cast<int>(values[2]));
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(&values[5]);
  camera->SetFocalPoint(&values[8]);
  camera->SetViewUp(&values[11]);
  camera->SetViewAngle(values[14]);
  renderer->ResetCameraClippingRange();
  window->Render();

  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->SetFileName(argv[1]);
  writer->Write();
  return mapper->GetDrawn() ? EXIT_SUCCESS : EXIT_FAILURE;
}
