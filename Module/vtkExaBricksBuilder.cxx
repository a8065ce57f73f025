// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksBuilder.h"

#include "Adapters/AMRCellSource.h"
#include "Adapters/AMRCompatibility.h"
#include "Adapters/AMRPart.h"
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
#include "vtkVolumeProperty.h" // for VTK_MAX_VRCOMP

#include <algorithm>
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

// Why a block without the array that `request` names cannot be read.
std::string describeMissingArray(vtkInformation* request, vtkDataSet* block, int amrLevel)
{
  const char* name =
    request->Has(vtkDataObject::FIELD_NAME()) ? request->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  const bool points =
    request->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_POINTS;
  return (name ? std::string("expected a ") + (points ? "point" : "cell") + " array '" + name + "'"
               : std::string("expected active scalars")) +
    " in every block, found " + listArrays(block) + " in one of level " + std::to_string(amrLevel) +
    ". Let the reader read it (readers may enable none: SetCellArrayStatus(), after "
    "UpdateInformation()), and choose it by name (of the mapper: "
    "SetScalarModeToUseCellFieldData() and SelectScalarArray())";
}

std::string nameOf(vtkDataArray* array)
{
  return array->GetName() ? array->GetName() : "(unnamed)";
}

vtkSmartPointer<vtkDataArray> convertToCells(vtkImageData* grid, vtkDataArray* pointArray)
{
  vtkNew<vtkImageData> points;
  points->CopyStructure(grid);
  points->GetPointData()->AddArray(pointArray);
  vtkNew<vtkPointDataToCellData> convert;
  convert->SetInputData(points);
  convert->Update();
  return vtkDataSet::SafeDownCast(convert->GetOutput())->GetCellData()->GetArray(0);
}
}

struct vtkExaBricksBuilder::vtkInternals
{
  std::shared_ptr<const exabricks::Structure> Structure; // kept while the boxes stay the same
  bool ReportedConversion = false;
  bool ReportedUnread = false;
  exabricks::UnfinishedRun Unfinished;

  explicit vtkInternals(vtkExaBricksBuilder* self)
    : Self(self)
  {
  }

  std::shared_ptr<const exabricks::BrickedVolume> Build(vtkOverlappingAMR* amr);

private:
  std::string FindArrays(const exabricks::AMRInput& input, exabricks::AMRCellSource& source,
    exabricks::BrickedVolume& bricked);
  std::string FindArray(vtkImageData* grid, int amrLevel, bool takesPoints,
    vtkSmartPointer<vtkDataArray>& array, std::string& name);
  std::string FindSecondArray(
    vtkImageData* grid, int amrLevel, bool takesPoints, vtkSmartPointer<vtkDataArray>& array);
  std::vector<std::optional<exabricks::Range>> FindWholeRanges(
    vtkOverlappingAMR* amr, const exabricks::BrickedVolume& bricked) const;
  std::string CheckArray(vtkDataArray* array, vtkImageData* grid, bool onPoints) const;
  vtkSmartPointer<vtkDataArray> ToCells(vtkDataArray* array, vtkImageData* grid);
  bool UpdateStructure(const exabricks::Hierarchy& hierarchy, double& seconds);
  void ReadValues(exabricks::AMRCellSource& source, exabricks::BrickedVolume& bricked);
  exabricks::Progress ProgressBetween(double from, double to);

  vtkExaBricksBuilder* const Self;
};

// Null if it cannot be built, which is reported here, or if it was aborted.
std::shared_ptr<const exabricks::BrickedVolume> vtkExaBricksBuilder::vtkInternals::Build(
  vtkOverlappingAMR* amr)
{
  const int* const levels = this->Self->LevelRange;
  if (levels[1] < std::max(levels[0], 0))
  {
    vtkErrorWithObjectMacro(this->Self,
      "Expected a LevelRange from one level to the same or a finer one, found "
        << levels[0] << " to " << levels[1] << ". Call SetLevelRange().");
    return nullptr;
  }
  if (exabricks::isPart(amr) && !exabricks::getFirstBlock(amr))
  {
    return nullptr; // there were not enough cells for all processes
  }
  exabricks::AMRInput input = exabricks::readAMR(amr,
    { static_cast<unsigned int>(std::max(levels[0], 0)), static_cast<unsigned int>(levels[1]) });
  if (!input.fault.empty())
  {
    vtkErrorWithObjectMacro(this->Self, << input.fault << ".");
    return nullptr;
  }
  if (!input.unread.empty() && !this->ReportedUnread)
  {
    this->ReportedUnread = true; // once, as the next time step is read as this one
    vtkWarningWithObjectMacro(this->Self, << input.unread);
  }
  int association = vtkDataObject::FIELD_ASSOCIATION_CELLS;
  if (this->Self->GetInputArrayToProcess(0, input.grids.front(), association) &&
    association == vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    exabricks::takePoints(input);
  }
  exabricks::AMRCellSource source(
    input, this->Self->VectorMode == COMPONENT ? this->Self->VectorComponent : -1);
  auto bricked = std::make_shared<exabricks::BrickedVolume>();
  const std::string fault = this->FindArrays(input, source, *bricked);
  if (!fault.empty())
  {
    vtkErrorWithObjectMacro(this->Self, << fault << ".");
    return nullptr;
  }
  source.setWholeRanges(this->FindWholeRanges(amr, *bricked));
  if (!this->UpdateStructure(input.hierarchy, bricked->structureTime))
  {
    return nullptr;
  }
  const exabricks::Stopwatch watch;
  bricked->origin = input.hierarchy.origin;
  bricked->spacing = input.hierarchy.spacing;
  bricked->amrLevel = input.amrLevel;
  bricked->onPoints = input.onPoints;
  bricked->joined = this->Self->SecondArrayName != nullptr;
  bricked->volume.structure = this->Structure;
  this->ReadValues(source, *bricked);
  bricked->valuesTime = watch.seconds();
  return bricked->volume ? bricked : nullptr;
}

// Points each block of `source` to its array, and sets its name and number of components. Returns
// why it cannot.
std::string vtkExaBricksBuilder::vtkInternals::FindArrays(const exabricks::AMRInput& input,
  exabricks::AMRCellSource& source, exabricks::BrickedVolume& bricked)
{
  for (std::size_t b = 0; b < input.grids.size(); ++b)
  {
    vtkSmartPointer<vtkDataArray> array;
    const std::string fault = this->FindArray(input.grids[b],
      input.amrLevel[input.hierarchy.blocks[b].level], input.onPoints, array, bricked.arrayName);
    if (!fault.empty())
    {
      return fault;
    }
    const int components = array->GetNumberOfComponents();
    if (b > 0 && components != bricked.components && this->Self->VectorMode == DISABLED)
    {
      return "expected the same number of components of array '" + bricked.arrayName +
        "' in every block, found " + std::to_string(bricked.components) + " and " +
        std::to_string(components) + ". Check the reader or filter that made it";
    }
    bricked.components = components;
    const int type = array->GetDataType();
    bricked.brightest = type == VTK_FLOAT || type == VTK_DOUBLE ? 1.0 : array->GetDataTypeMax();
    source.setArray(static_cast<int>(b), array);
    if (this->Self->SecondArrayName)
    {
      if (components > 1 && this->Self->VectorMode == DISABLED)
      {
        return "expected one component of array '" + bricked.arrayName + "' beside array '" +
          this->Self->SecondArrayName + "', found " + std::to_string(components) +
          ". Call SetVectorModeToMagnitude(), or SetVectorModeToComponent() and "
          "SetVectorComponent()";
      }
      vtkSmartPointer<vtkDataArray> second;
      const std::string missing = this->FindSecondArray(
        input.grids[b], input.amrLevel[input.hierarchy.blocks[b].level], input.onPoints, second);
      if (!missing.empty())
      {
        return missing;
      }
      source.setSecondArray(static_cast<int>(b), second, this->Self->SecondComponent);
    }
  }
  return {};
}

// Of each component that is read, where the AMR is a part of a larger one that tells them.
std::vector<std::optional<exabricks::Range>> vtkExaBricksBuilder::vtkInternals::FindWholeRanges(
  vtkOverlappingAMR* amr, const exabricks::BrickedVolume& bricked) const
{
  const vtkExaBricksBuilder& self = *this->Self;
  const bool each = self.VectorMode == DISABLED && !self.SecondArrayName;
  std::vector<std::optional<exabricks::Range>> ranges;
  for (int k = 0; k < (each ? bricked.components : 1); ++k)
  {
    const int component = bricked.components == 1 ? 0
      : each                                      ? k
      : self.VectorMode == COMPONENT              ? self.VectorComponent
                                                  : -1;
    ranges.push_back(exabricks::findWholeRange(amr, bricked.arrayName, component));
  }
  if (self.SecondArrayName)
  {
    ranges.push_back(exabricks::findWholeRange(amr, self.SecondArrayName, self.SecondComponent));
  }
  return ranges;
}

// The same of the second array, which belongs to the same cells or points.
std::string vtkExaBricksBuilder::vtkInternals::FindSecondArray(
  vtkImageData* grid, int amrLevel, bool takesPoints, vtkSmartPointer<vtkDataArray>& array)
{
  int association = vtkDataObject::FIELD_ASSOCIATION_CELLS;
  this->Self->GetInputArrayToProcess(0, grid, association);
  const bool onPoints = association == vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataSetAttributes* data =
    onPoints ? static_cast<vtkDataSetAttributes*>(grid->GetPointData()) : grid->GetCellData();
  array = data->GetArray(this->Self->SecondArrayName);
  if (!array)
  {
    return std::string("expected a ") + (onPoints ? "point" : "cell") + " array '" +
      this->Self->SecondArrayName + "' in every block, found " + listArrays(grid) +
      " in one of level " + std::to_string(amrLevel) +
      ". Let the reader read it, or choose another one (of the mapper: SetOpacityArrayName(), "
      "SetTransfer2DYAxisArray())";
  }
  const std::string fault = this->CheckArray(array, grid, onPoints);
  if (!fault.empty())
  {
    return fault;
  }
  const int components = array->GetNumberOfComponents();
  if (components > 1 && this->Self->SecondComponent >= components)
  {
    return "expected a component below " + std::to_string(components) + " of array '" +
      this->Self->SecondArrayName + "', found " + std::to_string(this->Self->SecondComponent);
  }
  array = onPoints && !takesPoints ? this->ToCells(array, grid) : array;
  return {};
}

// Whether it has a value for each point or cell; else why not.
std::string vtkExaBricksBuilder::vtkInternals::CheckArray(
  vtkDataArray* array, vtkImageData* grid, bool onPoints) const
{
  const vtkIdType expected = onPoints ? grid->GetNumberOfPoints() : grid->GetNumberOfCells();
  return array->GetNumberOfTuples() >=
      expected // as for VTK's mappers, what is too much is left out
    ? ""
    : "expected at least " + std::to_string(expected) + " values in array '" + nameOf(array) +
      "', one for each " + (onPoints ? "point" : "cell") + " of a block's grid, found " +
      std::to_string(array->GetNumberOfTuples()) + ". Check the reader or filter that made it";
}

vtkSmartPointer<vtkDataArray> vtkExaBricksBuilder::vtkInternals::ToCells(
  vtkDataArray* array, vtkImageData* grid)
{
  if (!this->ReportedConversion)
  {
    this->ReportedConversion = true;
    vtkWarningWithObjectMacro(this->Self,
      "'" << nameOf(array)
          << "' is a point array of several blocks, or of hidden cells: it is "
             "converted to cells with vtkPointDataToCellData.");
  }
  return convertToCells(grid, array);
}

// The block's array, as one of cells, unless points are taken. Returns why there is none that can
// be drawn.
std::string vtkExaBricksBuilder::vtkInternals::FindArray(vtkImageData* grid, int amrLevel,
  bool takesPoints, vtkSmartPointer<vtkDataArray>& array, std::string& name)
{
  int association = vtkDataObject::FIELD_ASSOCIATION_CELLS;
  array = this->Self->GetInputArrayToProcess(0, grid, association);
  if (!array)
  {
    return describeMissingArray(this->Self->GetInputArrayInformation(0), grid, amrLevel);
  }
  name = nameOf(array);
  const bool onPoints = association == vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const std::string fault = this->CheckArray(array, grid, onPoints);
  if (!fault.empty())
  {
    return fault;
  }
  const int components = array->GetNumberOfComponents();
  if (components > 1 && this->Self->VectorMode == COMPONENT &&
    this->Self->VectorComponent >= components)
  {
    return "expected a component below " + std::to_string(components) + " of array '" + name +
      "', found VectorComponent " + std::to_string(this->Self->VectorComponent);
  }
  if (components > VTK_MAX_VRCOMP && this->Self->VectorMode == DISABLED)
  {
    return "expected at most " + std::to_string(VTK_MAX_VRCOMP) + " components in array '" + name +
      "', found " + std::to_string(components) +
      ". Call SetVectorModeToMagnitude(), or SetVectorModeToComponent() and SetVectorComponent()";
  }
  array = onPoints && !takesPoints ? this->ToCells(array, grid) : array;
  return {};
}

// Keeps the structure while the boxes stay the same. False: it was aborted.
bool vtkExaBricksBuilder::vtkInternals::UpdateStructure(
  const exabricks::Hierarchy& hierarchy, double& seconds)
{
  if (this->Structure && this->Structure->hierarchy.sameStructure(hierarchy))
  {
    return true;
  }
  const exabricks::Stopwatch watch;
  this->Structure.reset(); // first, as two of them may be too much memory
  auto structure = std::make_shared<const exabricks::Structure>(
    exabricks::buildStructure(hierarchy, this->ProgressBetween(0.0, 0.5)));
  if (structure->tree.nodes.empty())
  {
    return false;
  }
  if (structure->partlyCoveredBoxes > 0)
  {
    vtkWarningWithObjectMacro(this->Self,
      "Finer blocks cover some coarse cells in part: the rest of these cells is "
      "drawn with their value.");
  }
  ++this->Self->NumberOfStructureBuilds;
  seconds = watch.seconds();
  this->Structure = std::move(structure);
  return true;
}

// Without values, if it was aborted.
void vtkExaBricksBuilder::vtkInternals::ReadValues(
  exabricks::AMRCellSource& source, exabricks::BrickedVolume& bricked)
{
  const int components = this->Self->SecondArrayName ? 2
    : this->Self->VectorMode == DISABLED             ? bricked.components
                                                     : 1;
  exabricks::Volume& volume = bricked.volume;
  for (int k = 0; k < components; ++k)
  {
    if (components > 1)
    {
      source.selectOfAll(k);
    }
    auto values = exabricks::makeValues(*volume.structure, source,
      this->ProgressBetween(0.5 + 0.5 * k / components, 0.5 + 0.5 * (k + 1) / components));
    if (!values)
    {
      volume = {};
      return;
    }
    if (k == 0)
    {
      volume.values = std::move(values);
    }
    else
    {
      volume.furtherValues.push_back(std::move(values));
    }
  }
}

// Reports the progress of a stage as the filter's own, and stops it when the filter is aborted.
exabricks::Progress vtkExaBricksBuilder::vtkInternals::ProgressBetween(double from, double to)
{
  return [this, from, to](double done)
  {
    this->Self->UpdateProgress(from + (to - from) * done);
    const bool aborted = exabricks::isAborted(this->Self);
    this->Unfinished.set(aborted);
    return !aborted;
  };
}

vtkExaBricksBuilder::vtkExaBricksBuilder()
  : Internals(new vtkInternals(this))
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataSetAttributes::SCALARS);
  // The output is there from the start, so that it can be asked even if a filter before this one
  // fails.
  vtkNew<vtkExaBricksData> output;
  this->GetExecutive()->SetOutputData(0, output);
}

vtkExaBricksBuilder::~vtkExaBricksBuilder() { this->SetSecondArrayName(nullptr); }

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
    // Without a volume the output stays empty, and the reason has been reported: if this returned
    // 0, the executive would add an unclear error of its own.
    if (auto bricked = this->Internals->Build(amr))
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
        << " bytes for the values of each component alone. Read fewer levels.");
    }
  }
  catch (const std::exception& error)
  {
    this->Internals->Structure.reset();
    vtkErrorMacro(<< error.what() << ".");
  }
  return 1;
}

const char* vtkExaBricksBuilder::GetVectorModeAsString(int mode)
{
  return mode == DISABLED ? "Disabled" : mode == COMPONENT ? "Component" : "Magnitude";
}

void vtkExaBricksBuilder::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VectorMode: " << GetVectorModeAsString(this->VectorMode) << "\n";
  os << indent << "VectorComponent: " << this->VectorComponent << "\n";
  os << indent << "SecondArrayName: " << (this->SecondArrayName ? this->SecondArrayName : "(none)")
     << "\n";
  os << indent << "SecondComponent: " << this->SecondComponent << "\n";
  os << indent << "LevelRange: " << this->LevelRange[0] << ", " << this->LevelRange[1] << "\n";
  os << indent << "NumberOfStructureBuilds: " << this->NumberOfStructureBuilds << "\n";
}
