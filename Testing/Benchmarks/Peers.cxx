// SPDX-License-Identifier: BSD-3-Clause
#include "Methods.h"

#include "Blocks.h"
#include "Display.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiBlockVolumeMapper.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkResampleToImage.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkUniformGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolumeProperty.h"

namespace exabricks
{
namespace benchmarks
{
namespace
{
constexpr int ResampledCells = 256; // along each axis

// The blocks with the one array. `blanked`: covered cells as vtkUniformGrid blanks them.
vtkSmartPointer<vtkMultiBlockDataSet> makeBlocks(const Subject& subject, bool blanked)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  render::ForEachBlock(subject.amr(),
    [&](vtkDataSet* from)
    {
      vtkSmartPointer<vtkImageData> block;
      block.TakeReference(blanked ? vtkUniformGrid::New() : vtkImageData::New());
      block->CopyStructure(from);
      block->GetCellData()->SetScalars(from->GetCellData()->GetArray(subject.array().c_str()));
      auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
        from->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
      if (blanked && ghosts)
      {
        block->GetCellData()->AddArray(ghosts);
      }
      blocks->SetBlock(blocks->GetNumberOfBlocks(), block);
    });
  return blocks;
}

// Cells as large as make 256 along each axis, with the value of the finest cell at their middle.
vtkSmartPointer<vtkImageData> resample(const Subject& subject)
{
  const vtkExaBricksData::Contents& contents = subject.contents();
  const Box& bounds = contents.Structure->tree.bounds;
  const glm::dvec3 lo = contents.World(glm::dvec3(0.0));
  const glm::dvec3 hi = contents.World(2.0 * glm::dvec3(bounds.size()));
  const glm::dvec3 cell = (hi - lo) / static_cast<double>(ResampledCells);
  vtkNew<vtkResampleToImage> sample;
  sample->SetInputDataObject(subject.amr());
  sample->UseInputBoundsOff();
  const glm::dvec3 first = lo + 0.5 * cell;
  const glm::dvec3 last = hi - 0.5 * cell;
  sample->SetSamplingBounds(first.x, last.x, first.y, last.y, first.z, last.z);
  sample->SetSamplingDimensions(ResampledCells, ResampledCells, ResampledCells);
  sample->Update();

  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetOrigin(lo.x, lo.y, lo.z);
  image->SetSpacing(cell.x, cell.y, cell.z);
  image->SetDimensions(ResampledCells + 1, ResampledCells + 1, ResampledCells + 1);
  image->GetCellData()->SetScalars(
    sample->GetOutput()->GetPointData()->GetArray(subject.array().c_str()));
  return image;
}

// A window with the subject's camera and functions.
Method makeWindowMethod(
  const Subject& subject, const Request& request, const std::string& name, vtkVolumeMapper* mapper)
{
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(subject.property()->GetRGBTransferFunction());
  property->SetScalarOpacity(subject.property()->GetScalarOpacity());
  property->SetScalarOpacityUnitDistance(subject.property()->GetScalarOpacityUnitDistance());
  property->SetInterpolationTypeToLinear();
  property->ShadeOff();
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  renderer->SetBackground(0.0, 0.0, 0.0);
  renderer->SetActiveCamera(subject.renderer()->GetActiveCamera());
  auto window = render::MakeWindow();
  window->AddRenderer(renderer);
  window->SetDesiredUpdateRate(0.0001); // never coarser for the sake of speed

  Method method;
  method.name = name;
  const auto drawAt = [window](const std::array<int, 2>& size)
  {
    window->SetSize(size[0], size[1]);
    window->Render();
    window->WaitForCompletion();
  };
  method.draw = [=, size = request.draw.Size] { drawAt(size); };
  method.picture = [=, size = request.accuracySize]
  {
    drawAt(size);
    return readWindow(window);
  };
  return method;
}

Method makeMultiBlock(const Subject& subject, const Request& request, bool blanked)
{
  Method method;
  Costs setUp;
  setUp.measure(
    [&]
    {
      vtkNew<vtkMultiBlockVolumeMapper> mapper;
      // Never destroyed: where VTK 9.1 cannot sort the blocks, it keeps some of their mappers
      // twice, and frees them twice.
      mapper->Register(nullptr);
      mapper->SetInputDataObject(makeBlocks(subject, blanked));
      mapper->SetRequestedRenderMode(vtkSmartVolumeMapper::GPURenderMode);
      mapper->SetScalarModeToUseCellFieldData();
      mapper->SelectScalarArray(subject.array().c_str());
      mapper->SetVectorMode(subject.component() >= 0 ? vtkSmartVolumeMapper::COMPONENT
                                                     : vtkSmartVolumeMapper::MAGNITUDE);
      mapper->SetVectorComponent(std::max(subject.component(), 0));
      method = makeWindowMethod(subject, request,
        blanked ? "vtkMultiBlockVolumeMapper, covered cells blanked"
                : "vtkMultiBlockVolumeMapper, all blocks",
        mapper);
      method.draw();
    });
  method.setUp = setUp.wall.front();
  return method;
}

Method makeResampled(const Subject& subject, const Request& request)
{
  Method method;
  Costs setUp;
  setUp.measure(
    [&]
    {
      vtkNew<vtkGPUVolumeRayCastMapper> mapper;
      mapper->SetInputData(resample(subject));
      mapper->SetScalarModeToUseCellData();
      mapper->AutoAdjustSampleDistancesOff();
      mapper->LockSampleDistanceToInputSpacingOff();
      mapper->UseJitteringOff();
      const glm::dvec3 spacing = subject.contents().Spacing;
      mapper->SetSampleDistance(static_cast<float>(std::min({ spacing.x, spacing.y, spacing.z })));
      method = makeWindowMethod(
        subject, request, "vtkResampleToImage 256^3, vtkGPUVolumeRayCastMapper", mapper);
      method.draw();
    });
  method.setUp = setUp.wall.front();
  return method;
}
}

std::vector<Method> makePeers(const Subject& subject, const Request& request)
{
  return { makeMultiBlock(subject, request, false), makeMultiBlock(subject, request, true),
    makeResampled(subject, request) };
}
}
}
