// SPDX-License-Identifier: BSD-3-Clause
#include "PeerMappers.h"

#include "Blocks.h" // of Examples/Render

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiBlockVolumeMapper.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkResampleToImage.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkUniformGrid.h"
#include "vtkUnsignedCharArray.h"
#ifdef EXABRICKS_VTK_HAS_AMR_MAPPER
#include "vtkAMRVolumeMapper.h"
#endif

#include <algorithm>

namespace exabricks
{
namespace benchmarks
{
namespace
{
// The blocks with the one array. `blanked`: covered cells as vtkUniformGrid blanks them.
vtkSmartPointer<vtkMultiBlockDataSet> makeBlocks(const PeerData& data, bool blanked)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  render::forEachBlock(data.amr,
    [&](vtkDataSet* from)
    {
      vtkSmartPointer<vtkImageData> block;
      block.TakeReference(blanked ? vtkUniformGrid::New() : vtkImageData::New());
      block->CopyStructure(from);
      block->GetCellData()->SetScalars(from->GetCellData()->GetArray(data.array.c_str()));
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

// Cells as large as make `cells` along each axis, with the value of the finest cell at their
// middle.
vtkSmartPointer<vtkImageData> resample(const PeerData& data, int cells)
{
  const glm::dvec3 cell = (data.hi - data.lo) / static_cast<double>(cells);
  vtkNew<vtkResampleToImage> sample;
  sample->SetInputDataObject(data.amr);
  sample->UseInputBoundsOff();
  const glm::dvec3 first = data.lo + 0.5 * cell;
  const glm::dvec3 last = data.hi - 0.5 * cell;
  sample->SetSamplingBounds(first.x, last.x, first.y, last.y, first.z, last.z);
  sample->SetSamplingDimensions(cells, cells, cells);
  sample->Update();

  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetOrigin(data.lo.x, data.lo.y, data.lo.z);
  image->SetSpacing(cell.x, cell.y, cell.z);
  image->SetDimensions(cells + 1, cells + 1, cells + 1);
  image->GetCellData()->SetScalars(
    sample->GetOutput()->GetPointData()->GetArray(data.array.c_str()));
  return image;
}
}

vtkSmartPointer<vtkVolumeMapper> makeMultiBlockMapper(const PeerData& data, bool blanked)
{
  auto mapper = vtkSmartPointer<vtkMultiBlockVolumeMapper>::New();
  // Never destroyed: where VTK 9.1 cannot sort the blocks, it keeps some of their mappers twice,
  // and frees them twice.
  mapper->Register(nullptr);
  mapper->SetInputDataObject(makeBlocks(data, blanked));
  mapper->SetRequestedRenderMode(vtkSmartVolumeMapper::GPURenderMode);
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectScalarArray(data.array.c_str());
  mapper->SetVectorMode(
    data.component >= 0 ? vtkSmartVolumeMapper::COMPONENT : vtkSmartVolumeMapper::MAGNITUDE);
  mapper->SetVectorComponent(std::max(data.component, 0));
  return mapper;
}

vtkSmartPointer<vtkVolumeMapper> makeResampledMapper(const PeerData& data, int cells)
{
  auto mapper = vtkSmartPointer<vtkGPUVolumeRayCastMapper>::New();
  mapper->SetInputData(resample(data, cells));
  mapper->SetScalarModeToUseCellData();
  mapper->AutoAdjustSampleDistancesOff();
  mapper->LockSampleDistanceToInputSpacingOff();
  mapper->UseJitteringOff();
  mapper->SetSampleDistance(static_cast<float>(data.sampleDistance));
  return mapper;
}

vtkSmartPointer<vtkVolumeMapper> makeAMRMapper(const PeerData& data)
{
#ifdef EXABRICKS_VTK_HAS_AMR_MAPPER
  auto mapper = vtkSmartPointer<vtkAMRVolumeMapper>::New();
  mapper->SetInputData(data.amr);
  mapper->SetScalarMode(VTK_SCALAR_MODE_USE_CELL_FIELD_DATA);
  mapper->SelectScalarArray(data.array.c_str());
  mapper->SetRequestedRenderMode(vtkSmartVolumeMapper::GPURenderMode);
  return mapper;
#else
  (void)data;
  return nullptr;
#endif
}
}
}
