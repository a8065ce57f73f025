// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksData.h"

#include "Adapters/BrickedVolume.h"
#include "Adapters/TransferFunctionInput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkExaBricksData);

namespace
{
// Whether a histogram can be put into the array, which is 0 for each bin then.
bool prepareBins(vtkExaBricksData* self, int bins, vtkDataArray* array)
{
  if (bins < 1 || !array)
  {
    vtkErrorWithObjectMacro(
      self, "Expected at least one bin and an array to put the numbers into.");
    return false;
  }
  array->SetNumberOfComponents(1);
  array->SetNumberOfTuples(bins);
  array->Fill(0.0);
  return true;
}

// Calls f(bin, volume in finest cells) for each leaf cell with a value.
template <typename F>
void forEachBin(const exabricks::BrickedVolume* bricked, int bins, const F& f)
{
  if (!bricked)
  {
    return;
  }
  const exabricks::Structure& structure = *bricked->volume.structure;
  const exabricks::Values& values = *bricked->volume.values;
  for (std::size_t brick = 0; brick < structure.bricks.size(); ++brick)
  {
    const auto width = static_cast<double>(structure.width(structure.bricks[brick]));
    for (auto i = values.firstValue[brick]; i < values.firstValue[brick + 1]; ++i)
    {
      const float value = values.normalized[i];
      if (value >= 0.0f)
      {
        const auto bin = static_cast<std::int64_t>(static_cast<double>(value) * bins);
        f(static_cast<std::size_t>(std::min<std::int64_t>(bin, bins - 1)), width * width * width);
      }
    }
  }
}

// Writes boxes as voxels, with eight points each.
class VoxelWriter
{
public:
  explicit VoxelWriter(vtkUnstructuredGrid* output)
    : Output(output)
  {
    output->Initialize();
    this->Points->SetDataTypeToDouble();
  }

  void Add(const glm::dvec3& lo, const glm::dvec3& hi)
  {
    vtkIdType ids[8];
    for (int i = 0; i < 8; ++i)
    {
      ids[i] = this->Points->InsertNextPoint(
        i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z);
    }
    this->Cells->InsertNextCell(8, ids);
  }

  template <typename Array>
  static vtkSmartPointer<Array> MakeArray(const char* name, int components, vtkIdType cells)
  {
    auto array = vtkSmartPointer<Array>::New();
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(cells);
    return array;
  }

  void Finish()
  {
    this->Output->SetPoints(this->Points);
    this->Output->SetCells(VTK_VOXEL, this->Cells);
  }

private:
  vtkUnstructuredGrid* Output;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
};

// Sets a range of normalised values, in the array's own values; (1, 0) if it is empty.
void setRange(vtkDoubleArray* array, vtkIdType i, const exabricks::ValueRange& range,
  const exabricks::Range& all)
{
  const bool empty = !(range.min <= range.max);
  const double extent = all.max - all.min;
  array->SetTuple2(
    i, empty ? 1.0 : all.min + range.min * extent, empty ? 0.0 : all.min + range.max * extent);
}
}

vtkExaBricksData::vtkExaBricksData() = default;
vtkExaBricksData::~vtkExaBricksData() = default;

void vtkExaBricksData::SetBrickedVolume(std::shared_ptr<const exabricks::BrickedVolume> bricked)
{
  this->Bricked = std::move(bricked);
  this->Modified();
}

void vtkExaBricksData::Initialize()
{
  this->Superclass::Initialize();
  this->Bricked.reset();
}

void vtkExaBricksData::ShallowCopy(vtkDataObject* source)
{
  this->Superclass::ShallowCopy(source);
  if (const vtkExaBricksData* other = vtkExaBricksData::SafeDownCast(source))
  {
    this->SetBrickedVolume(other->Bricked);
  }
}

void vtkExaBricksData::DeepCopy(vtkDataObject* source)
{
  this->Superclass::DeepCopy(source);
  if (const vtkExaBricksData* other = vtkExaBricksData::SafeDownCast(source))
  {
    this->SetBrickedVolume(other->Bricked);
  }
}

unsigned long vtkExaBricksData::GetActualMemorySize()
{
  unsigned long size = this->Superclass::GetActualMemorySize();
  if (this->Bricked)
  {
    const exabricks::BrickedVolume& bricked = *this->Bricked;
    size += static_cast<unsigned long>(
      (bricked.volume.structure->bytes() + bricked.volume.valueBytes()) / 1024);
  }
  return size;
}

int vtkExaBricksData::GetNumberOfLevels()
{
  return this->Bricked ? this->Bricked->volume.structure->hierarchy.levels() : 0;
}

vtkIdType vtkExaBricksData::GetNumberOfBlocks()
{
  return this->Bricked
    ? static_cast<vtkIdType>(this->Bricked->volume.structure->hierarchy.blocks.size())
    : 0;
}

vtkIdType vtkExaBricksData::GetNumberOfLeafCells()
{
  return this->Bricked ? static_cast<vtkIdType>(this->Bricked->volume.structure->leafCells) : 0;
}

vtkIdType vtkExaBricksData::GetNumberOfBricks()
{
  return this->Bricked ? static_cast<vtkIdType>(this->Bricked->volume.structure->bricks.size()) : 0;
}

vtkIdType vtkExaBricksData::GetNumberOfRegions()
{
  return this->Bricked
    ? static_cast<vtkIdType>(this->Bricked->volume.structure->tree.regions.size())
    : 0;
}

vtkIdType vtkExaBricksData::GetNumberOfAbsentCells()
{
  return this->Bricked ? static_cast<vtkIdType>(this->Bricked->volume.values->absentCells) : 0;
}

void vtkExaBricksData::GetScalarRange(double range[2])
{
  const bool empty = !this->Bricked || this->Bricked->volume.values->range.empty();
  range[0] = empty ? 1.0 : this->Bricked->volume.values->range.min;
  range[1] = empty ? 0.0 : this->Bricked->volume.values->range.max;
}

const char* vtkExaBricksData::GetArrayName()
{
  return this->Bricked ? this->Bricked->arrayName.c_str() : nullptr;
}

void vtkExaBricksData::GetBounds(double bounds[6])
{
  vtkMath::UninitializeBounds(bounds);
  if (this->Bricked)
  {
    const exabricks::Box shown = this->Bricked->volume.structure->shown();
    const glm::dvec3 lo = this->Bricked->world(glm::dvec3(shown.lo));
    const glm::dvec3 hi = this->Bricked->world(glm::dvec3(shown.hi));
    for (int axis = 0; axis < 3; ++axis)
    {
      bounds[2 * axis] = lo[axis];
      bounds[2 * axis + 1] = hi[axis];
    }
  }
}

void vtkExaBricksData::GetFinestSpacing(double spacing[3])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    spacing[axis] = this->Bricked ? this->Bricked->spacing[axis] : 1.0;
  }
}

double vtkExaBricksData::GetStructureTime()
{
  return this->Bricked ? this->Bricked->structureTime : 0.0;
}

double vtkExaBricksData::GetScalarsTime()
{
  return this->Bricked ? this->Bricked->valuesTime : 0.0;
}

void vtkExaBricksData::GetHistogram(int bins, vtkIdTypeArray* counts)
{
  if (!prepareBins(this, bins, counts))
  {
    return;
  }
  vtkIdType* const count = counts->GetPointer(0);
  forEachBin(this->Bricked.get(), bins, [&](std::size_t bin, double) { ++count[bin]; });
}

void vtkExaBricksData::GetVolumeHistogram(int bins, vtkDoubleArray* shares)
{
  if (!prepareBins(this, bins, shares))
  {
    return;
  }
  double* const share = shares->GetPointer(0);
  double total = 0.0;
  forEachBin(this->Bricked.get(), bins,
    [&](std::size_t bin, double volume)
    {
      share[bin] += volume;
      total += volume;
    });
  for (int bin = 0; bin < bins && total > 0.0; ++bin)
  {
    share[bin] /= total;
  }
}

void vtkExaBricksData::GetBricksAsCells(vtkUnstructuredGrid* output)
{
  if (!output)
  {
    vtkErrorMacro("Expected an unstructured grid to put the bricks into, found none.");
    return;
  }
  VoxelWriter writer(output);
  if (!this->Bricked)
  {
    return;
  }
  const exabricks::BrickedVolume& bricked = *this->Bricked;
  const exabricks::Structure& structure = *bricked.volume.structure;
  const exabricks::Values& values = *bricked.volume.values;
  const vtkIdType n = this->GetNumberOfBricks();
  auto level = VoxelWriter::MakeArray<vtkIntArray>("Level", 1, n);
  auto cells = VoxelWriter::MakeArray<vtkIntArray>("Cells", 3, n);
  auto range = VoxelWriter::MakeArray<vtkDoubleArray>("Range", 2, n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const exabricks::Brick& brick = structure.bricks[i];
    const exabricks::Box box = structure.box(brick);
    writer.Add(bricked.origin + bricked.spacing * glm::dvec3(box.lo),
      bricked.origin + bricked.spacing * glm::dvec3(box.hi));
    level->SetValue(i, bricked.amrLevel[brick.level]);
    cells->SetTuple3(i, brick.cells.x, brick.cells.y, brick.cells.z);
    exabricks::ValueRange found;
    const float* ofBrick = values.ofBrick(static_cast<std::size_t>(i));
    for (std::uint64_t k = 0; k < brick.numberOfCells(); ++k)
    {
      if (ofBrick[k] >= 0.0f)
      {
        found.add({ ofBrick[k], ofBrick[k] });
      }
    }
    setRange(range, i, found, values.range);
  }
  writer.Finish();
  output->GetCellData()->AddArray(level);
  output->GetCellData()->AddArray(cells);
  output->GetCellData()->AddArray(range);
}

void vtkExaBricksData::GetRegionsAsCells(vtkUnstructuredGrid* output, vtkPiecewiseFunction* opacity)
{
  if (!output)
  {
    vtkErrorMacro("Expected an unstructured grid to put the regions into, found none.");
    return;
  }
  VoxelWriter writer(output);
  if (!this->Bricked)
  {
    return;
  }
  const exabricks::BrickedVolume& bricked = *this->Bricked;
  const exabricks::Structure& structure = *bricked.volume.structure;
  const exabricks::Values& values = *bricked.volume.values;
  const exabricks::TransferFunction transfer =
    exabricks::makeTransferFunction(opacity, values.range);
  const vtkIdType n = this->GetNumberOfRegions();
  auto level = VoxelWriter::MakeArray<vtkIntArray>("Level", 1, n);
  auto count = VoxelWriter::MakeArray<vtkIntArray>("BrickCount", 1, n);
  auto range = VoxelWriter::MakeArray<vtkDoubleArray>("Range", 2, n);
  auto active = VoxelWriter::MakeArray<vtkIntArray>("Active", 1, n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const exabricks::layout::Region& region = structure.tree.regions[i];
    writer.Add(bricked.world(glm::dvec3(region.lo)), bricked.world(glm::dvec3(region.hi)));
    int finest = -1;
    for (std::uint32_t k = 0; k < region.brickCount; ++k)
    {
      const std::uint32_t brick = structure.tree.brickLists[region.firstBrick + k];
      finest = std::max(finest, bricked.amrLevel[structure.bricks[brick].level]);
    }
    level->SetValue(i, finest);
    count->SetValue(i, static_cast<int>(region.brickCount));
    setRange(range, i, values.ranges.regions[i], values.range);
    active->SetValue(i, region.brickCount > 0 && transfer.visible(values.ranges.regions[i]));
  }
  writer.Finish();
  output->GetCellData()->AddArray(level);
  output->GetCellData()->AddArray(count);
  output->GetCellData()->AddArray(range);
  output->GetCellData()->AddArray(active);
}

void vtkExaBricksData::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  double range[2];
  this->GetScalarRange(range);
  os << indent << "Levels: " << this->GetNumberOfLevels() << "\n";
  os << indent << "Blocks: " << this->GetNumberOfBlocks() << "\n";
  os << indent << "LeafCells: " << this->GetNumberOfLeafCells() << "\n";
  os << indent << "AbsentCells: " << this->GetNumberOfAbsentCells() << "\n";
  os << indent << "Bricks: " << this->GetNumberOfBricks() << "\n";
  os << indent << "Regions: " << this->GetNumberOfRegions() << "\n";
  os << indent << "ArrayName: " << (this->Bricked ? this->Bricked->arrayName : "(none)") << "\n";
  os << indent << "ScalarRange: " << range[0] << ", " << range[1] << "\n";
  os << indent << "StructureTime: " << this->GetStructureTime() << " s\n";
  os << indent << "ScalarsTime: " << this->GetScalarsTime() << " s\n";
}
