// SPDX-License-Identifier: BSD-3-Clause
// Run by mpiexec on several processes: the AMR is dealt to them in some way, redistributed, drawn
// in parts, and the parts are put one over the other. The picture has to be that of one process.
//
//   mpiexec -n 4 DrawOnRanks <scene> <looks> [<folder for pictures>]
#include "AMR.h"
#include "Stage.h"

#include "vtkExaBricksRedistribute.h"
#include "vtkExaBricksSceneSource.h"

#include "vtkContourValues.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMPIController.h"
#include "vtkPNGWriter.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkXMLUniformGridAMRReader.h"

#include <array>
#include <functional>
#include <iostream>
#include <vector>

namespace
{
constexpr int Size = 200;

struct Scene
{
  vtkSmartPointer<vtkOverlappingAMR> whole;
  std::function<void(test::Stage&)> look; // sets colours, opacities and camera
};

// The shipped data, a Rayleigh-Taylor instability of three levels.
Scene readData(const std::string& file)
{
  vtkNew<vtkXMLUniformGridAMRReader> reader;
  reader->SetFileName(file.c_str());
  reader->SetMaximumLevelsToReadByDefault(0);
  reader->Update();
  Scene scene;
  scene.whole = vtkOverlappingAMR::SafeDownCast(reader->GetOutputDataObject(0));
  scene.look = [](test::Stage& stage)
  {
    stage.mapper->SetScalarModeToUseCellFieldData();
    stage.mapper->SelectScalarArray("magvort");
    vtkVolumeProperty* property = stage.Property();
    property->GetRGBTransferFunction()->AddRGBPoint(0.0, 0.1, 0.2, 0.9);
    property->GetRGBTransferFunction()->AddRGBPoint(4.0, 0.9, 0.9, 0.3);
    property->GetRGBTransferFunction()->AddRGBPoint(13.0, 1.0, 0.2, 0.1);
    property->GetScalarOpacity()->AddPoint(1.0, 0.0);
    property->GetScalarOpacity()->AddPoint(12.0, 0.8);
    property->SetScalarOpacityUnitDistance(0.02);
    stage.renderer->ResetCamera(stage.mapper->GetBounds());
    stage.renderer->GetActiveCamera()->Azimuth(35.0);
    stage.renderer->GetActiveCamera()->Elevation(20.0);
  };
  return scene;
}

Scene makeScene(vtkExaBricksSceneSource* source)
{
  source->Update();
  Scene scene;
  scene.whole = vtkOverlappingAMR::SafeDownCast(source->GetOutputDataObject(0));
  scene.look = [source](test::Stage& stage)
  {
    stage.mapper->SetScalarModeToUseCellFieldData();
    stage.mapper->SelectScalarArray("value");
    source->InitializeProperty(stage.Property());
    source->InitializeCamera(stage.renderer->GetActiveCamera());
  };
  return scene;
}

// A process's blocks of all; the boxes of the others stay.
enum class Dealt
{
  InTurn, // as AMR readers deal them
  Badly,  // the last process has all fine ones, the first all coarse ones, and others none
  ToAll   // each has all of them
};
vtkSmartPointer<vtkOverlappingAMR> deal(vtkOverlappingAMR* whole, Dealt dealt, int rank, int ranks)
{
  return test::keepBlocks(whole,
    [=](unsigned int level, unsigned int number)
    {
      const int owner =
        dealt == Dealt::Badly ? (level == 0 ? 0 : ranks - 1) : static_cast<int>(number) % ranks;
      return dealt == Dealt::ToAll || owner == rank;
    });
}

// What is set beside the scene.
void setLooks(const std::string& looks, const double center[3], test::Stage& stage)
{
  vtkVolumeProperty* property = stage.Property();
  if (looks == "completed")
  {
    stage.mapper->SetReconstructionToCompleted();
  }
  else if (looks == "nearest")
  {
    stage.mapper->SetReconstructionToNearest();
  }
  else if (looks == "shaded")
  {
    property->ShadeOn();
    property->SetSpecular(0.3);
  }
  else if (looks == "isosurface")
  {
    double range[2];
    property->GetScalarOpacity()->GetRange(range);
    stage.mapper->SetBlendModeToIsoSurface();
    property->GetIsoSurfaceValues()->SetValue(0, 0.4 * range[0] + 0.6 * range[1]);
    property->GetIsoSurfaceValues()->SetValue(1, 0.7 * range[0] + 0.3 * range[1]);
    property->ShadeOn();
  }
  else if (looks == "clipped")
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(center[0], center[1], center[2]);
    plane->SetNormal(-0.3, 0.8, 0.4);
    stage.mapper->AddClippingPlane(plane);
  }
  else if (looks == "long-steps")
  {
    stage.mapper->SetStepScale(2.5);
  }
  else if (looks == "gradient-opacity")
  {
    property->GetGradientOpacity()->AddPoint(0.0, 0.0);
    property->GetGradientOpacity()->AddPoint(2.0, 1.0);
  }
}

std::vector<unsigned char> drawImage(test::Stage& stage)
{
  stage.mapper->RenderToImageOn();
  stage.window->Render();
  vtkNew<vtkImageData> image;
  stage.mapper->GetColorImage(image);
  std::vector<unsigned char> bytes(4 * Size * Size, 0);
  if (image->GetNumberOfPoints() == Size * Size)
  {
    const auto* const from = static_cast<const unsigned char*>(image->GetScalarPointer());
    std::copy_n(from, bytes.size(), bytes.begin());
    for (std::size_t i = 0; i < bytes.size(); i += 4) // white beyond the bounds
    {
      std::fill_n(&bytes[i], bytes[i + 3] == 0 ? 3 : 0, static_cast<unsigned char>(0));
    }
  }
  return bytes;
}

// Pictures one over the other, those in front first.
std::vector<unsigned char> blend(const std::vector<unsigned char>& all, vtkIdList* order)
{
  const std::size_t size = 4 * Size * Size;
  std::vector<unsigned char> result(size);
  for (std::size_t i = 0; i < size; i += 4)
  {
    double color[4] = { 0.0, 0.0, 0.0, 0.0 };
    for (vtkIdType n = 0; n < order->GetNumberOfIds(); ++n)
    {
      const unsigned char* const part = &all[size * static_cast<std::size_t>(order->GetId(n)) + i];
      const double left = 1.0 - color[3];
      for (int k = 0; k < 4; ++k)
      {
        color[k] += left * part[k] / 255.0;
      }
    }
    for (int k = 0; k < 4; ++k)
    {
      result[i + static_cast<std::size_t>(k)] =
        static_cast<unsigned char>(std::lround(255.0 * std::min(color[k], 1.0)));
    }
  }
  return result;
}

void save(const std::vector<unsigned char>& bytes, const std::string& file)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(Size, Size, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (std::size_t i = 0; i < bytes.size() / 4; ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      static_cast<unsigned char*>(image->GetScalarPointer())[3 * i + k] = bytes[4 * i + k];
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(image);
  writer->Write();
}

struct Likeness
{
  double decibel = 0.0; // over the pixels that are drawn in either
  int most = 0;         // of 255
  double drawn = 0.0;   // of all pixels
};
Likeness compare(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  Likeness found;
  double squares = 0.0;
  int drawn = 0;
  for (std::size_t i = 0; i < a.size(); i += 4)
  {
    drawn += a[i + 3] != 0 || b[i + 3] != 0;
    for (std::size_t k = 0; k < 4; ++k)
    {
      const int off = std::abs(int(a[i + k]) - int(b[i + k]));
      found.most = std::max(found.most, off);
      squares += off * off / (255.0 * 255.0) / 4.0;
    }
  }
  found.decibel = squares > 0.0 ? -10.0 * std::log10(squares / drawn) : 1000.0;
  found.drawn = static_cast<double>(drawn) / (Size * Size);
  return found;
}
}

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  const int rank = controller->GetLocalProcessId();
  const int ranks = controller->GetNumberOfProcesses();
  if (argc < 3)
  {
    std::cerr << "DrawOnRanks <scene> <looks> [<folder for pictures>]\n";
    controller->Finalize();
    return EXIT_FAILURE;
  }
  const std::string name = argv[1];
  const std::string looks = argv[2];
  int status = EXIT_SUCCESS;
  {
    vtkNew<vtkExaBricksSceneSource> source;
    source->SetNumberOfLeafCells(60000);
    name == "Exajet-wing" ? source->SetSceneToExajetWing() : source->SetSceneToCloud();
    const Scene scene =
      name == "Cloud" || name == "Exajet-wing" ? makeScene(source) : readData(name);

    test::KeepDisplay display;
    test::Stage alone(scene.whole, Size);
    scene.look(alone);
    std::array<double, 3> center;
    std::copy_n(alone.mapper->GetCenter(), 3, center.begin());
    setLooks(looks, center.data(), alone);
    const std::vector<unsigned char> expected =
      rank == 0 ? drawImage(alone) : std::vector<unsigned char>();

    for (const Dealt dealt : { Dealt::InTurn, Dealt::Badly, Dealt::ToAll })
    {
      vtkNew<vtkExaBricksRedistribute> redistribute;
      redistribute->SetInputData(deal(scene.whole, dealt, rank, ranks));
      redistribute->SetForCompleted(looks == "completed");
      redistribute->Update();
      test::Stage stage(
        vtkOverlappingAMR::SafeDownCast(redistribute->GetOutputDataObject(0)), Size);
      stage.mapper->SetInputConnection(redistribute->GetOutputPort());
      scene.look(stage);
      stage.renderer->GetActiveCamera()->DeepCopy(alone.renderer->GetActiveCamera());
      setLooks(looks, center.data(), stage);

      const std::vector<unsigned char> part = drawImage(stage);
      std::vector<unsigned char> all(rank == 0 ? part.size() * static_cast<std::size_t>(ranks) : 0);
      controller->Gather(part.data(), all.data(), static_cast<vtkIdType>(part.size()), 0);
      vtkNew<vtkIdList> order;
      redistribute->GetFrontToBack(stage.renderer->GetActiveCamera(), nullptr, order);
      const vtkIdType cells[2] = { redistribute->GetNumberOfCellsToDraw(),
        redistribute->GetNumberOfCells() };
      std::vector<vtkIdType> allCells(2 * static_cast<std::size_t>(ranks));
      controller->Gather(cells, allCells.data(), 2, 0);
      if (rank == 0)
      {
        const std::vector<unsigned char> picture = ranks == 1 ? part : blend(all, order);
        const Likeness likeness = compare(picture, expected);
        std::cout << name.substr(name.rfind('/') + 1) << ", " << looks << ", " << ranks
                  << " processes, dealt "
                  << (dealt == Dealt::InTurn     ? "in turn"
                         : dealt == Dealt::Badly ? "badly"
                                                 : "to all")
                  << ": " << likeness.decibel << " dB, most " << likeness.most << " of 255, drawn "
                  << likeness.drawn << "; cells drawn and held:";
        for (const vtkIdType number : allCells)
        {
          std::cout << " " << number;
        }
        std::cout << "\n";
        // Each process rounds its picture to 8 bits; by that alone there are 54 to 59 dB. Gradients
        // jump between cells: at the face of a part the next one takes that of its own side.
        const int most = looks == "shaded" ? 12 : 2;
        if (!(likeness.decibel >= 54.0) || likeness.most > most || !(likeness.drawn > 0.05))
        {
          std::cout << "FAILED: expected 54 dB, " << most
                    << " of 255 at most, and something drawn\n";
          status = EXIT_FAILURE;
        }
        if (argc > 3)
        {
          save(picture, std::string(argv[3]) + "/ranks.png");
          save(expected, std::string(argv[3]) + "/alone.png");
        }
      }
    }
  }
  controller->Broadcast(&status, 1, 0);
  controller->Finalize();
  return status;
}
