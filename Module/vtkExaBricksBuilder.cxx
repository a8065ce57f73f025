// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksBuilder.h"

#include "Adapters/AMRCompatibility.h"
#include "Adapters/AMRInput.h"
#include "Adapters/BrickedVolume.h"
#include "Adapters/UnfinishedRun.h"
#include "Core/Stopwatch.h"
#include "vtkExaBricksData.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointDataToCellData.h"

#include <exception>
#include <new>
#include <set>

vtkStandardNewMacro(vtkExaBricksBuilder);

namespace
{
// The names of the arrays that the block has, for messages.
std::string listArrays(vtkDataSet* block)
{
  std::set<std::string> names;
  for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(block->GetCellData()),
         static_cast<vtkDataSetAttributes*>(block->GetPointData()) })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      const char* name = data->GetArrayName(i);
      if (name && std::string(name) != vtkDataSetAttributes::GhostArrayName())
      {
        names.insert("'" + std::string(name) + "'" +
          (block->GetPointData() == data ? " (points)" : " (cells)"));
      }
    }
  }
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text.empty() ? "no arrays" : text;
}
}

struct vtkExaBricksBuilder::vtkInternals
{
  std::shared_ptr<const exabricks::Structure> Structure; // of the last build, to be kept
  bool SaidPointsAreConverted = false;
  exabricks::UnfinishedRun Unfinished;

  // Points each block of `source` to its array. Returns the array's name; sets its number of
  // components, and `fault`.
  std::string FindArrays(vtkExaBricksBuilder* self, const exabricks::AMRInput& input,
    exabricks::AMRCellSource& source, int& components, std::string& fault);

  // Null if it cannot be built, which is said, or was aborted.
  std::shared_ptr<const exabricks::BrickedVolume> Build(
    vtkExaBricksBuilder* self, vtkOverlappingAMR* amr);
};

std::string vtkExaBricksBuilder::vtkInternals::FindArrays(vtkExaBricksBuilder* self,
  const exabricks::AMRInput& input, exabricks::AMRCellSource& source, int& components,
  std::string& fault)
{
  std::string name;
  for (std::size_t b = 0; b < input.grids.size(); ++b)
  {
    vtkImageData* grid = input.grids[b];
    int association = vtkDataObject::FIELD_ASSOCIATION_CELLS;
    vtkSmartPointer<vtkDataArray> array = self->GetInputArrayToProcess(0, grid, association);
    if (!array)
    {
      vtkInformation* wanted = self->GetInputArrayInformation(0);
      const char* wantedName = wanted->Has(vtkDataObject::FIELD_NAME())
        ? wanted->Get(vtkDataObject::FIELD_NAME())
        : nullptr;
      const exabricks::Block& block = input.hierarchy.blocks[b];
      const bool points =
        wanted->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_POINTS;
      fault = (wantedName ? std::string("expected a ") + (points ? "point" : "cell") + " array '" +
                    wantedName + "'"
                          : std::string("expected active scalars")) +
        " in every block, found " + listArrays(grid) + " in one of level " +
        std::to_string(input.amrLevel[block.level]) +
        ". Let the reader read it (readers may enable none), and choose it by name (of the mapper: "
        "SetScalarModeToUseCellFieldData() and SelectScalarArray())";
      return name;
    }
    name = array->GetName() ? array->GetName() : "(unnamed)";
    const bool onPoints = association == vtkDataObject::FIELD_ASSOCIATION_POINTS;
    const vtkIdType expected = onPoints ? grid->GetNumberOfPoints() : grid->GetNumberOfCells();
    if (array->GetNumberOfTuples() != expected)
    {
      fault = "expected " + std::to_string(expected) + " values in array '" + name +
        "', one for each " + (onPoints ? "point" : "cell") + " of a block's grid, found " +
        std::to_string(array->GetNumberOfTuples()) + ". Check the reader or filter that made it";
      return name;
    }
    if (array->GetNumberOfComponents() > 1 && self->VectorMode == COMPONENT &&
      self->VectorComponent >= array->GetNumberOfComponents())
    {
      fault = "expected a component below " + std::to_string(array->GetNumberOfComponents()) +
        " of array '" + name + "', found VectorComponent " + std::to_string(self->VectorComponent);
      return name;
    }
    if (onPoints)
    {
      vtkNew<vtkImageData> points;
      points->CopyStructure(grid);
      points->GetPointData()->AddArray(array);
      vtkNew<vtkPointDataToCellData> convert;
      convert->SetInputData(points);
      convert->Update();
      array = vtkDataSet::SafeDownCast(convert->GetOutput())->GetCellData()->GetArray(0);
      if (!this->SaidPointsAreConverted)
      {
        this->SaidPointsAreConverted = true;
        vtkWarningWithObjectMacro(self,
          "'" << name
              << "' is a point array: it is converted to cells with vtkPointDataToCellData.");
      }
    }
    components = array->GetNumberOfComponents();
    source.setArray(static_cast<int>(b), array);
  }
  return name;
}

std::shared_ptr<const exabricks::BrickedVolume> vtkExaBricksBuilder::vtkInternals::Build(
  vtkExaBricksBuilder* self, vtkOverlappingAMR* amr)
{
  const exabricks::AMRInput input = exabricks::readAMR(amr);
  if (!input.fault.empty())
  {
    vtkErrorWithObjectMacro(self, << input.fault << ".");
    return nullptr;
  }
  exabricks::AMRCellSource source(
    input, self->VectorMode == COMPONENT ? self->VectorComponent : -1);
  std::string fault;
  auto bricked = std::make_shared<exabricks::BrickedVolume>();
  bricked->arrayName = this->FindArrays(self, input, source, bricked->components, fault);
  if (!fault.empty())
  {
    vtkErrorWithObjectMacro(self, << fault << ".");
    return nullptr;
  }

  const auto progress = [self](double from, double to)
  {
    return [self, from, to](double done)
    {
      self->UpdateProgress(from + (to - from) * done);
      const bool aborted = exabricks::isAborted(self);
      self->Internals->Unfinished.set(aborted);
      return !aborted;
    };
  };
  const bool keep = this->Structure && this->Structure->hierarchy.sameStructure(input.hierarchy);
  if (!keep)
  {
    const exabricks::Stopwatch watch;
    this->Structure.reset();
    auto structure = std::make_shared<const exabricks::Structure>(
      exabricks::buildStructure(input.hierarchy, progress(0.0, 0.5)));
    if (structure->tree.nodes.empty())
    {
      return nullptr; // aborted
    }
    if (structure->partlyCoveredBoxes > 0)
    {
      vtkWarningWithObjectMacro(self,
        "Finer blocks cover some coarse cells in part: the rest of these cells is "
        "drawn with their value.");
    }
    ++self->NumberOfStructureBuilds;
    bricked->structureTime = watch.seconds();
    this->Structure = std::move(structure);
  }
  const exabricks::Stopwatch watch;
  bricked->volume.structure = this->Structure;
  bricked->origin = input.hierarchy.origin;
  bricked->spacing = input.hierarchy.spacing;
  bricked->amrLevel = input.amrLevel;
  bricked->volume.values = exabricks::makeValues(*this->Structure, source, progress(0.5, 1.0));
  if (!bricked->volume.values)
  {
    return nullptr; // aborted
  }
  bricked->valuesTime = watch.seconds();
  return bricked;
}

vtkExaBricksBuilder::vtkExaBricksBuilder()
  : Internals(new vtkInternals)
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataSetAttributes::SCALARS);
  // There from the start, so that it can be asked even if a filter before this one fails.
  vtkNew<vtkExaBricksData> output;
  this->GetExecutive()->SetOutputData(0, output);
}

vtkExaBricksBuilder::~vtkExaBricksBuilder() = default;

vtkMTimeType vtkExaBricksBuilder::GetMTime()
{
  return this->Internals->Unfinished.modificationTime(this->Superclass::GetMTime());
}

vtkExaBricksData* vtkExaBricksBuilder::GetOutput()
{
  return vtkExaBricksData::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkExaBricksBuilder::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkOverlappingAMR");
  return 1;
}

int vtkExaBricksBuilder::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkExaBricksData");
  return 1;
}

int vtkExaBricksBuilder::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!vtkExaBricksData::SafeDownCast(vtkDataObject::GetData(outputVector, 0)))
  {
    vtkNew<vtkExaBricksData> output;
    outputVector->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), output);
  }
  return 1;
}

int vtkExaBricksBuilder::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkOverlappingAMR* amr = vtkOverlappingAMR::GetData(inputVector[0], 0);
  vtkExaBricksData* output = vtkExaBricksData::SafeDownCast(
    outputVector->GetInformationObject(0)->Get(vtkDataObject::DATA_OBJECT()));
  output->Initialize();
  this->Internals->Unfinished.set(false);
  if (!amr)
  {
    vtkErrorMacro("Expected a vtkOverlappingAMR, found none. Set the input.");
    return 0;
  }

  try
  {
    // Without a volume the output stays empty, and the reason has been said: on 0 the executive
    // would add an unclear error of its own.
    if (auto bricked = this->Internals->Build(this, amr))
    {
      output->SetBrickedVolume(std::move(bricked));
    }
    this->Internals->Unfinished.setEnoughMemory();
  }
  catch (const std::bad_alloc&)
  {
    this->Internals->Structure.reset();
    if (this->Internals->Unfinished.setOutOfMemory())
    {
      vtkErrorMacro("Out of memory on the host: expected memory for bricks, regions and values of "
        << amr->GetNumberOfCells() << " cells, which are up to " << 4 * amr->GetNumberOfCells()
        << " bytes for the values alone. Read fewer levels.");
    }
  }
  catch (const std::exception& error)
  {
    this->Internals->Structure.reset();
    vtkErrorMacro(<< error.what() << ".");
  }
  return 1;
}

void vtkExaBricksBuilder::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VectorMode: " << (this->VectorMode == COMPONENT ? "Component" : "Magnitude")
     << "\n";
  os << indent << "VectorComponent: " << this->VectorComponent << "\n";
  os << indent << "NumberOfStructureBuilds: " << this->NumberOfStructureBuilds << "\n";
}
