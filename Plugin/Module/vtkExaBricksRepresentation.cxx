// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksRepresentation.h"

#include "Adapters/AMRCompatibility.h"
#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"
#include "vtkExaBricksRedistribute.h"
#include "vtkExaBricksStatistics.h"
#include "vtkExaBricksVolume.h"
#include "vtkExaBricksVolumeMapper.h"

#include "vtkAlgorithmOutput.h"
#include "vtkBoundingBox.h"
#include "vtkColorTransferFunction.h"
#include "vtkCommand.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkImplicitFunction.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOutlineSource.h"
#include "vtkPVRenderView.h"
#include "vtkPVTransferFunction2D.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"
#include "vtkVolumeProperty.h"

#include <iomanip>
#include <sstream>

vtkStandardNewMacro(vtkExaBricksRepresentation);

namespace
{
// Pieces that the view delivers.
constexpr int DATA = 0;
constexpr int OUTLINE = 1;

vtkBoundingBox findBounds(vtkOverlappingAMR* amr)
{
  vtkBoundingBox box;
  for (unsigned int level = 0; level < amr->GetNumberOfLevels(); ++level)
  {
    for (unsigned int index = 0; index < exabricks::numberOfBlocks(amr, level); ++index)
    {
      if (vtkDataSet* block = exabricks::getBlock(amr, level, index))
      {
        box.AddBounds(block->GetBounds());
      }
    }
  }
  return box;
}
}

vtkExaBricksRepresentation::vtkExaBricksRepresentation()
{
  vtkMath::UninitializeBounds(this->Bounds);
  this->Volume->SetMapper(this->Mapper);
  this->Volume->SetProperty(this->Property);
  this->Property->IndependentComponentsOn();
  this->Property->SetInterpolationTypeToLinear();
  this->Volume->AddObserver(
    vtkCommand::EndEvent, this, &vtkExaBricksRepresentation::UpdateStatistics);
}

vtkExaBricksRepresentation::~vtkExaBricksRepresentation() = default;

int vtkExaBricksRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkOverlappingAMR");
  // A client has no input.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkExaBricksRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkMath::UninitializeBounds(this->Bounds);
  vtkOverlappingAMR* amr = inputVector[0]->GetNumberOfInformationObjects() == 1
    ? vtkOverlappingAMR::GetData(inputVector[0], 0)
    : nullptr;
  vtkBoundingBox whole;
  if (this->IsOneOfSeveral())
  {
    // All ranks come here together.
    this->Redistribute->SetForCompleted(
      this->Mapper->GetReconstruction() == vtkExaBricksVolumeMapper::COMPLETED);
    this->Redistribute->SetInputDataObject(amr);
    this->Redistribute->Modified();
    this->Redistribute->Update();
    vtkDataObject* part = this->Redistribute->GetOutputDataObject(0);
    this->Data.TakeReference(part->NewInstance());
    this->Data->ShallowCopy(part);
    vtkMultiProcessController* controller = this->Redistribute->GetController();
    this->Redistribute->GetPartBounds(controller->GetLocalProcessId(), this->Bounds);
    for (int process = 0; process < controller->GetNumberOfProcesses(); ++process)
    {
      double bounds[6];
      this->Redistribute->GetPartBounds(process, bounds);
      whole.AddBounds(bounds);
    }
  }
  else if (amr)
  {
    this->Data.TakeReference(amr->NewInstance());
    this->Data->ShallowCopy(amr);
    whole = findBounds(amr);
    whole.GetBounds(this->Bounds);
  }
  else
  {
    // Data are not delivered to a client; views ask for an object of some kind all the same.
    this->Data = vtkSmartPointer<vtkPartitionedDataSet>::New();
  }
  if (whole.IsValid())
  {
    double bounds[6];
    whole.GetBounds(bounds);
    this->OutlineSource->SetBounds(bounds);
    this->OutlineSource->Update();
  }
  else
  {
    this->OutlineSource->GetOutput()->Initialize();
  }
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

bool vtkExaBricksRepresentation::IsOneOfSeveral()
{
  vtkMultiProcessController* controller = this->Redistribute->GetController();
  return controller && controller->GetNumberOfProcesses() > 1;
}

int vtkExaBricksRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0; // invisible
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    this->ProvideData(inInfo, outInfo);
  }
  else if (request == vtkPVView::REQUEST_UPDATE_LOD())
  {
    vtkPVRenderView::SetRequiresDistributedRenderingLOD(inInfo, this, true);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    this->TakeDeliveredData(inInfo);
  }
  return 1;
}

void vtkExaBricksRepresentation::ProvideData(vtkInformation* inInfo, vtkInformation* outInfo)
{
  vtkPVRenderView::SetPiece(
    inInfo, this, this->Data, this->Data ? this->Data->GetActualMemorySize() : 0, DATA);
  // The volume is drawn where its data are. A client that draws by itself, as its server cannot,
  // has the outline.
  vtkPVRenderView::SetDeliverToClientAndRenderingProcesses(
    inInfo, this, /*deliver_to_client=*/false, /*gather_before_delivery=*/false, DATA);
  vtkPVRenderView::SetRequiresDistributedRendering(inInfo, this, true);
  vtkPVRenderView::SetPiece(
    inInfo, this, this->OutlineSource->GetOutputDataObject(0), /*trueSize=*/0, OUTLINE);

  vtkPVRenderView::SetGeometryBounds(inInfo, this, this->Bounds, this->Volume->GetMatrix());
  // Each process draws a part, and the parts are blended from back to front.
  outInfo->Set(vtkPVRenderView::NEED_ORDERED_COMPOSITING(), 1);
  vtkPVRenderView::SetOrderedCompositingConfiguration(
    inInfo, this, vtkPVRenderView::USE_BOUNDS_FOR_REDISTRIBUTION);
}

void vtkExaBricksRepresentation::TakeDeliveredData(vtkInformation* inInfo)
{
  vtkAlgorithmOutput* data = vtkPVRenderView::GetPieceProducer(inInfo, this, DATA);
  vtkOverlappingAMR* amr = data
    ? vtkOverlappingAMR::SafeDownCast(data->GetProducer()->GetOutputDataObject(data->GetIndex()))
    : nullptr;
  this->Volume->SetOutlineConnection(vtkPVRenderView::GetPieceProducer(inInfo, this, OUTLINE));
  // No blocks: a client, an empty input, or one of several processes that got none.
  if (amr && exabricks::getFirstBlock(amr) && this->SelectArray(amr))
  {
    this->Mapper->SetInputConnection(data);
    this->Volume->SetOutlineOnly(false);
  }
  else
  {
    // Volumes that overlap it would draw the mapper's data too.
    this->Mapper->RemoveAllInputConnections(0);
    this->Volume->SetOutlineOnly(true);
  }
}

bool vtkExaBricksRepresentation::SelectArray(vtkOverlappingAMR* amr)
{
  vtkInformation* info = this->GetInputArrayInformation(0);
  const char* name = info && info->Has(vtkDataObject::FIELD_NAME())
    ? info->Get(vtkDataObject::FIELD_NAME())
    : nullptr;
  const int association = name && info->Has(vtkDataObject::FIELD_ASSOCIATION())
    ? info->Get(vtkDataObject::FIELD_ASSOCIATION())
    : vtkDataObject::FIELD_ASSOCIATION_NONE;
  const bool onPoints = association == vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const bool onCells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  if (!name || !name[0] || !(onPoints || onCells))
  {
    if (!this->ReportedNoArray)
    {
      vtkWarningMacro("ExaBricks draws an array of cells or points, found "
        << (name && name[0] ? name : "none")
        << ". Choose one to color by; until then the outline is drawn.");
    }
    this->ReportedNoArray = true;
    return false;
  }
  this->ReportedNoArray = false;
  if (onPoints && this->IsOneOfSeveral())
  {
    if (!this->ReportedPoints)
    {
      vtkWarningMacro("Several ranks draw arrays of cells alone, found '"
        << name
        << "' of points. Apply \"Point Data to Cell Data\"; until then the outline is drawn.");
    }
    this->ReportedPoints = true;
    return false;
  }
  this->ReportedPoints = false;
  if (onPoints)
  {
    this->Mapper->SetScalarModeToUsePointFieldData();
  }
  else
  {
    this->Mapper->SetScalarModeToUseCellFieldData();
  }
  this->Mapper->SelectScalarArray(name);
  this->SelectTransfer2D();

  vtkColorTransferFunction* color = this->Property->GetRGBTransferFunction();
  const bool component = color->GetVectorMode() == vtkScalarsToColors::COMPONENT;
  vtkDataArray* array = exabricks::getFirstBlock(amr)->GetAttributes(association)->GetArray(name);
  const int components = array ? array->GetNumberOfComponents() : 1;
  const bool each = !this->SelectSecondArray(amr, association) && !this->UseTransfer2D &&
    ((this->Components == DEPENDENT && (components == 2 || components == 4)) ||
      (this->Components == INDEPENDENT && components > 1 && components <= VTK_MAX_VRCOMP));
  this->Mapper->SetVectorMode(each ? vtkExaBricksVolumeMapper::DISABLED
      : component                  ? vtkExaBricksVolumeMapper::COMPONENT
                                   : vtkExaBricksVolumeMapper::MAGNITUDE);
  this->Mapper->SetVectorComponent(component ? color->GetVectorComponent() : 0);
  return true;
}

bool vtkExaBricksRepresentation::SelectSecondArray(vtkOverlappingAMR* amr, int association)
{
  const bool planar = this->UseTransfer2D && !this->UseGradientForTransfer2D;
  const bool opacity = this->UseSeparateOpacityArray && !this->UseTransfer2D;
  const OtherArray& other = planar ? this->ColorArray2 : this->OpacityArray;
  const bool wanted = (planar || opacity) && !other.name.empty();
  const bool fits = wanted && other.association == association;
  if (wanted && !fits && !this->ReportedSecondArray)
  {
    vtkWarningMacro(
      "Expected " << (planar ? "a second array for the 2-D transfer function" : "an opacity array")
                  << " of the same cells or points as the array to color by, found '" << other.name
                  << "' of others. Choose another one; until then "
                  << (planar ? "its gradient's magnitude counts."
                             : "opacities are those of the array to color by."));
  }
  this->ReportedSecondArray = wanted && !fits;
  const char* const name = fits ? other.name.c_str() : nullptr;
  this->Mapper->SetTransfer2DYAxisArray(planar ? name : nullptr);
  this->Mapper->SetOpacityArrayName(planar ? nullptr : name);
  vtkDataArray* array =
    fits ? exabricks::getFirstBlock(amr)->GetAttributes(association)->GetArray(name) : nullptr;
  const bool magnitude = array && other.component >= array->GetNumberOfComponents();
  this->Mapper->SetOpacityComponent(magnitude ? -1 : other.component);
  return fits;
}

void vtkExaBricksRepresentation::SelectTransfer2D()
{
  vtkImageData* image = nullptr;
  if (this->UseTransfer2D && this->TransferFunction2D)
  {
    this->TransferFunction2D->Build(); // if it was changed
    image = this->TransferFunction2D->GetFunction();
  }
  if (this->Property->GetTransferFunction2D() != image)
  {
    this->Property->SetTransferFunction2D(image);
  }
  this->Property->SetTransferFunctionMode(
    this->UseTransfer2D ? vtkVolumeProperty::TF_2D : vtkVolumeProperty::TF_1D);
}

bool vtkExaBricksRepresentation::AddToView(vtkView* view)
{
  vtkPVRenderView* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  renderView->GetRenderer()->AddVolume(this->Volume);
  // The blocks that a rank draws are not those that it was given, which a selection would name.
  if (!this->IsOneOfSeveral())
  {
    renderView->RegisterPropForHardwareSelection(this, this->Volume);
  }
  return this->Superclass::AddToView(view);
}

bool vtkExaBricksRepresentation::RemoveFromView(vtkView* view)
{
  vtkPVRenderView* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  if (!this->IsOneOfSeveral())
  {
    renderView->UnRegisterPropForHardwareSelection(this, this->Volume);
  }
  renderView->GetRenderer()->RemoveVolume(this->Volume);
  return this->Superclass::RemoveFromView(view);
}

void vtkExaBricksRepresentation::SetVisibility(bool visible)
{
  this->Volume->SetVisibility(visible);
  this->Superclass::SetVisibility(visible);
}

void vtkExaBricksRepresentation::SetPosition(double x, double y, double z)
{
  this->Volume->SetPosition(x, y, z);
}

void vtkExaBricksRepresentation::SetScale(double x, double y, double z)
{
  this->Volume->SetScale(x, y, z);
}

void vtkExaBricksRepresentation::SetOrientation(double x, double y, double z)
{
  this->Volume->SetOrientation(x, y, z);
}

void vtkExaBricksRepresentation::SetOrigin(double x, double y, double z)
{
  this->Volume->SetOrigin(x, y, z);
}

void vtkExaBricksRepresentation::SetUserTransform(const double matrix[16])
{
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(matrix);
  this->Volume->SetUserTransform(transform);
}

void vtkExaBricksRepresentation::SetPickable(int pickable) { this->Volume->SetPickable(pickable); }

void vtkExaBricksRepresentation::SetStatistics(vtkExaBricksStatistics* statistics)
{
  this->Statistics = statistics;
}

void vtkExaBricksRepresentation::UpdateStatistics()
{
  if (!this->Statistics)
  {
    return;
  }
  vtkExaBricksData* data = this->Mapper->GetBuilder()->GetOutput();
  if (this->Volume->GetOutlineOnly() || !this->Mapper->GetDrawn() || !data)
  {
    this->Statistics->SetText("nothing drawn");
    return;
  }
  std::ostringstream text;
  if (this->IsOneOfSeveral())
  {
    vtkMultiProcessController* controller = this->Redistribute->GetController();
    text << "rank " << controller->GetLocalProcessId() << " of "
         << controller->GetNumberOfProcesses() << ", which draws "
         << this->Redistribute->GetNumberOfCellsToDraw() << " of all "
         << this->Redistribute->GetNumberOfLeafCells() << " leaf cells:\n";
  }
  text << data->GetNumberOfLevels() << " levels, ";
  if (this->Mapper->GetLevelsLeftOut() > 0)
  {
    text << "finest left out: " << this->Mapper->GetLevelsLeftOut() << ", ";
  }
  text << data->GetNumberOfLeafCells() << " leaf cells\n"
       << data->GetNumberOfBricks() << " bricks, " << data->GetNumberOfRegions() << " regions ("
       << this->Mapper->GetNumberOfActiveRegions() << " active)\n"
       << this->Mapper->GetDeviceName() << "\n"
       << std::fixed << std::setprecision(1) << this->Mapper->GetDeviceMemory() / 1e6 << " MB, "
       << std::setprecision(3) << this->Mapper->GetTimeToDraw() << " s a picture";
  const double distance = this->Mapper->GetUsedImageSampleDistance();
  if (distance > 1.0)
  {
    text << std::setprecision(1) << ", a ray in " << distance << " x " << distance << " pixels";
  }
  this->Statistics->SetText(text.str());
}

void vtkExaBricksRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Bounds: " << this->Bounds[0] << " " << this->Bounds[1] << " " << this->Bounds[2]
     << " " << this->Bounds[3] << " " << this->Bounds[4] << " " << this->Bounds[5] << "\n";
  os << indent << "Volume:\n";
  this->Volume->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Mapper:\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
