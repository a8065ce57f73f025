// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksVolumeMapper.h"

#include "Adapters/AMRCompatibility.h"
#include "Adapters/DataContents.h"
#include "Adapters/OpenGLPicture.h"
#include "Adapters/TransferFunctionInput.h"
#include "Adapters/ViewInput.h"
#include "Core/Completion.h"
#include "Vulkan/VolumeRenderer.h"
#include "vtkExaBricksBuilder.h"

#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkGarbageCollector.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <set>

vtkStandardNewMacro(vtkExaBricksVolumeMapper);

static_assert(static_cast<int>(vtkExaBricksVolumeMapper::MAGNITUDE) ==
      static_cast<int>(vtkExaBricksBuilder::MAGNITUDE) &&
    static_cast<int>(vtkExaBricksVolumeMapper::COMPONENT) ==
      static_cast<int>(vtkExaBricksBuilder::COMPONENT),
  "the mapper hands its vector mode to the builder");

static_assert(static_cast<int>(vtkExaBricksVolumeMapper::NEAREST) ==
      static_cast<int>(exabricks::Reconstruction::Nearest) &&
    static_cast<int>(vtkExaBricksVolumeMapper::COMPLETED) ==
      static_cast<int>(exabricks::Reconstruction::Completed),
  "the mapper hands its reconstruction to the renderer");

namespace
{
bool showsTranslucent(vtkRenderer* ren)
{
  vtkPropCollection* props = ren->GetViewProps();
  vtkCollectionSimpleIterator place;
  props->InitTraversal(place);
  while (vtkProp* prop = props->GetNextProp(place))
  {
    if (prop->GetVisibility() && prop->HasTranslucentPolygonalGeometry())
    {
      return true;
    }
  }
  return false;
}
}

struct vtkExaBricksVolumeMapper::vtkInternals
{
  vtkSmartPointer<vtkExaBricksBuilder> Builder = vtkSmartPointer<vtkExaBricksBuilder>::New();
  exabricks::VolumeRenderer Renderer;
  exabricks::OpenGLPicture Picture;
  std::vector<glm::vec4> Pixels;
  std::vector<float> Depth;

  // Of the COMPLETED reconstruction: made of the builder's output when it is asked for.
  struct CompletedLevels
  {
    exabricks::Completion Completion;
    exabricks::ValueRanges Ranges;
  };
  std::unique_ptr<const CompletedLevels> Completed;

  // What the renderer was last given.
  std::shared_ptr<const vtkExaBricksData::Contents> Contents;
  vtkVolumeProperty* Property = nullptr; // compared only, never followed
  vtkMTimeType PropertyTime = 0;

  std::set<std::string> Said;     // warnings, once each
  std::string SaidFault;          // of the last picture, said once as long as it stays
  std::string ConfigurationFault; // empty if the builder has the mapper's input and array

  void WarnOnce(vtkExaBricksVolumeMapper* self, const std::string& what)
  {
    if (this->Said.insert(what).second)
    {
      vtkWarningWithObjectMacro(self, << what);
    }
  }

  // Says what of the scene is not supported. False: nothing can be drawn.
  bool CheckSupport(vtkExaBricksVolumeMapper* self, vtkRenderer* ren, vtkVolumeProperty* property);
  // Returns which values cannot be drawn with.
  std::string CheckValues(vtkExaBricksVolumeMapper* self, vtkVolumeProperty* property);
  // Points the builder to the mapper's input and array; returns why it cannot.
  std::string ConfigureBuilder(vtkExaBricksVolumeMapper* self);
  void CompleteLevels(const vtkExaBricksData::Contents& contents);
  // Hands the renderer what has changed. Throws std::bad_alloc.
  void UpdateRenderer(vtkExaBricksVolumeMapper* self, vtkVolumeProperty* property);
};

bool vtkExaBricksVolumeMapper::vtkInternals::CheckSupport(
  vtkExaBricksVolumeMapper* self, vtkRenderer* ren, vtkVolumeProperty* property)
{
  static const char* const blendModes[] = { "composite", "maximum intensity", "minimum intensity",
    "average intensity", "additive", "iso-surface", "slice" };
  const int mode = self->GetBlendMode();
  if (mode != vtkVolumeMapper::COMPOSITE_BLEND)
  {
    const bool known = mode >= 0 && mode < static_cast<int>(std::size(blendModes));
    vtkErrorWithObjectMacro(self,
      "Expected blend mode composite, found "
        << (known ? blendModes[mode] : std::to_string(mode).c_str())
        << ", which is not supported yet. Call SetBlendModeToComposite().");
    return false;
  }
  if (property->GetShade(0))
  {
    this->WarnOnce(self, "Shading is not supported yet: the volume is drawn unshaded.");
  }
  if (!property->GetDisableGradientOpacity(0) && property->HasGradientOpacity(0))
  {
    this->WarnOnce(self, "Gradient opacity is not supported yet: the volume is drawn without it.");
  }
  if (property->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D)
  {
    this->WarnOnce(self,
      "2-D transfer functions are not supported yet: the volume is drawn with the 1-D functions.");
  }
  if (self->GetCropping())
  {
    this->WarnOnce(self, "Cropping is not supported yet: the volume is drawn whole.");
  }
  if (self->GetNumberOfClippingPlanes() > 0)
  {
    this->WarnOnce(self, "Clipping planes are not supported yet: the volume is drawn whole.");
  }
  if (ren->GetUseDepthPeeling() && ren->GetUseDepthPeelingForVolumes() && showsTranslucent(ren))
  {
    this->WarnOnce(
      self, "Depth peeling cannot include this volume: it is drawn over translucent geometry.");
  }
  return true;
}

std::string vtkExaBricksVolumeMapper::vtkInternals::CheckValues(
  vtkExaBricksVolumeMapper* self, vtkVolumeProperty* property)
{
  const int components = this->Builder->GetOutput()->GetContents()->Components;
  if (components > 1 && !property->GetIndependentComponents())
  {
    return "expected independent components, found " + std::to_string(components) +
      " dependent ones (such as RGBA), which are not supported yet. Call IndependentComponentsOn() "
      "of the volume property, and choose a component or the magnitude";
  }
  const double unit = property->GetScalarOpacityUnitDistance(0);
  if (!(unit > 0.0) || !std::isfinite(unit) || !std::isfinite(self->StepScale) ||
    !std::isfinite(self->ErrorTolerance))
  {
    return "expected a finite, positive ScalarOpacityUnitDistance, a finite StepScale and a finite "
           "ErrorTolerance, found " +
      std::to_string(unit) + ", " + std::to_string(self->StepScale) + " and " +
      std::to_string(self->ErrorTolerance);
  }
  return {};
}

std::string vtkExaBricksVolumeMapper::vtkInternals::ConfigureBuilder(vtkExaBricksVolumeMapper* self)
{
  vtkAlgorithmOutput* input =
    self->GetNumberOfInputConnections(0) > 0 ? self->GetInputConnection(0, 0) : nullptr;
  if (!input)
  {
    // Nothing of the former input is kept.
    this->Builder->RemoveAllInputConnections(0);
    this->Builder->GetOutputDataObject(0)->Initialize();
    this->Renderer.setVolume({});
    this->Contents.reset();
    this->Completed.reset();
    return "Expected a vtkOverlappingAMR as input, found none. Call SetInputConnection()";
  }
  vtkExaBricksBuilder* builder = this->Builder;
  if (builder->GetNumberOfInputConnections(0) == 0 || builder->GetInputConnection(0, 0) != input)
  {
    builder->SetInputConnection(input);
  }
  builder->SetVectorMode(self->VectorMode);
  builder->SetVectorComponent(self->VectorComponent);

  // Asked for an attribute, VTK marks the filter as modified even where nothing changes: it would
  // run again for every picture.
  const auto useActiveScalars = [builder](int wanted)
  {
    vtkInformation* present = builder->GetInputArrayInformation(0);
    if (present->Has(vtkDataObject::FIELD_NAME()) ||
      present->Get(vtkDataObject::FIELD_ASSOCIATION()) != wanted)
    {
      builder->SetInputArrayToProcess(0, 0, 0, wanted, vtkDataSetAttributes::SCALARS);
    }
    return std::string();
  };
  int association = vtkDataObject::FIELD_ASSOCIATION_CELLS;
  switch (self->ScalarMode)
  {
    case VTK_SCALAR_MODE_DEFAULT:
      return useActiveScalars(vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS);
    case VTK_SCALAR_MODE_USE_POINT_DATA:
      return useActiveScalars(vtkDataObject::FIELD_ASSOCIATION_POINTS);
    case VTK_SCALAR_MODE_USE_CELL_DATA:
      return useActiveScalars(association);
    case VTK_SCALAR_MODE_USE_POINT_FIELD_DATA:
      association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
      break;
    case VTK_SCALAR_MODE_USE_CELL_FIELD_DATA:
      break;
    default:
      return std::string("Expected a scalar mode of points or cells, found ") +
        self->GetScalarModeAsString() + ". Call one of SetScalarModeTo...";
  }
  std::string name = self->ArrayName ? self->ArrayName : "";
  if (self->ArrayAccessMode == VTK_GET_ARRAY_BY_ID)
  {
    // Ids mean the arrays of a block, so look at the first.
    self->GetInputAlgorithm(0, 0)->Update();
    vtkOverlappingAMR* amr = vtkOverlappingAMR::SafeDownCast(self->GetDataObjectInput());
    vtkDataSet* block = amr ? exabricks::getFirstBlock(amr) : nullptr;
    vtkDataSetAttributes* data = block ? block->GetAttributes(association) : nullptr;
    const char* found = data && self->ArrayId >= 0 ? data->GetArrayName(self->ArrayId) : nullptr;
    if (!found)
    {
      return "Expected the number of an array from 0 to " +
        std::to_string(data ? data->GetNumberOfArrays() - 1 : -1) + ", found " +
        std::to_string(self->ArrayId) + ". Call SelectScalarArray() with the name of an array";
    }
    name = found;
  }
  builder->SetInputArrayToProcess(0, 0, 0, association, name.c_str());
  return {};
}

void vtkExaBricksVolumeMapper::vtkInternals::CompleteLevels(
  const vtkExaBricksData::Contents& contents)
{
  const exabricks::Structure& structure = *contents.Structure;
  const std::vector<std::int64_t>& cellWidth = structure.hierarchy.cellWidth;
  auto levels = std::make_unique<CompletedLevels>();
  levels->Completion =
    exabricks::complete(structure.tree, structure.bricks, cellWidth, contents.Scalars);
  levels->Ranges = exabricks::findValueRanges(
    structure.tree, levels->Completion.bricks, cellWidth, levels->Completion.scalars);
  this->Completed = std::move(levels);
}

void vtkExaBricksVolumeMapper::vtkInternals::UpdateRenderer(
  vtkExaBricksVolumeMapper* self, vtkVolumeProperty* property)
{
  const auto& contents = this->Builder->GetOutput()->GetContents();
  this->Renderer.selectTraversal(static_cast<exabricks::Traversal>(self->Traversal));
  this->Renderer.selectDevice(self->Device ? self->Device : "");
  const bool newData = contents != this->Contents;
  const bool completed = self->Reconstruction == COMPLETED;
  if (newData || completed != static_cast<bool>(this->Completed))
  {
    const exabricks::Structure& structure = *contents->Structure;
    exabricks::Volume volume{ &structure.tree, &structure.bricks, &structure.hierarchy.cellWidth,
      &contents->Scalars, &contents->Ranges };
    this->Renderer.setVolume({});
    this->Completed.reset();
    if (completed)
    {
      this->CompleteLevels(*contents);
      volume.bricks = &this->Completed->Completion.bricks;
      volume.scalars = &this->Completed->Completion.scalars;
      volume.ranges = &this->Completed->Ranges;
    }
    this->Renderer.setVolume(volume);
    this->Contents = contents;
  }
  if (newData || property != this->Property || property->GetMTime() > this->PropertyTime)
  {
    // Nodes are normalised to the range of the data, so new data want new tables too.
    this->Property = property;
    this->PropertyTime = property->GetMTime();
    this->Renderer.setTransferFunction(
      exabricks::makeTransferFunction(property, contents->Scalars.range));
  }
}

vtkExaBricksVolumeMapper::vtkExaBricksVolumeMapper()
  : Internals(new vtkInternals)
{
}

vtkExaBricksVolumeMapper::~vtkExaBricksVolumeMapper() { this->SetDevice(nullptr); }

void vtkExaBricksVolumeMapper::ReportReferences(vtkGarbageCollector* collector)
{
  this->Superclass::ReportReferences(collector);
  // Mapper and builder hold the same producer: without this the collector would not see the
  // builder's share, and leave the input behind.
  vtkGarbageCollectorReport(collector, this->Internals->Builder, "Builder");
}

int vtkExaBricksVolumeMapper::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkOverlappingAMR");
  return 1;
}

void vtkExaBricksVolumeMapper::SetInputData(vtkOverlappingAMR* amr)
{
  this->SetInputDataInternal(0, amr);
}

const char* vtkExaBricksVolumeMapper::GetReconstructionAsString()
{
  return this->Reconstruction == NEAREST ? "Nearest"
    : this->Reconstruction == COMPLETED  ? "Completed"
                                         : "Basis";
}

const char* vtkExaBricksVolumeMapper::GetTraversalAsString()
{
  return this->Traversal == RAY_QUERY ? "RayQuery"
    : this->Traversal == KD_TREE      ? "KdTree"
                                      : "Automatic";
}

void vtkExaBricksVolumeMapper::GetDevices(vtkStringArray* lines)
{
  if (!lines)
  {
    return;
  }
  lines->Initialize();
  for (const std::string& line : exabricks::VolumeRenderer::listDevices())
  {
    lines->InsertNextValue(line);
  }
}

vtkExaBricksBuilder* vtkExaBricksVolumeMapper::GetBuilder() { return this->Internals->Builder; }

const char* vtkExaBricksVolumeMapper::GetDeviceName()
{
  return this->Internals->Renderer.statistics().device.c_str();
}

const char* vtkExaBricksVolumeMapper::GetTraversalUsed()
{
  switch (this->Internals->Renderer.statistics().traversal)
  {
    case exabricks::Traversal::RayQuery:
      return "RayQuery";
    case exabricks::Traversal::KdTree:
      return "KdTree";
    default:
      return "none";
  }
}

vtkIdType vtkExaBricksVolumeMapper::GetNumberOfActiveRegions()
{
  return static_cast<vtkIdType>(this->Internals->Renderer.statistics().activeRegions);
}

vtkTypeInt64 vtkExaBricksVolumeMapper::GetDeviceMemory()
{
  return static_cast<vtkTypeInt64>(this->Internals->Renderer.statistics().deviceBytes);
}

double vtkExaBricksVolumeMapper::GetUploadTime()
{
  return this->Internals->Renderer.statistics().uploadTime;
}

double vtkExaBricksVolumeMapper::GetColorTime()
{
  return this->Internals->Renderer.statistics().colorTime;
}

double vtkExaBricksVolumeMapper::GetOpacityTime()
{
  return this->Internals->Renderer.statistics().opacityTime;
}

double vtkExaBricksVolumeMapper::GetMarchTime()
{
  return this->Internals->Renderer.statistics().marchTime;
}

int vtkExaBricksVolumeMapper::GetLevelsLeftOut()
{
  return this->Internals->Renderer.statistics().levelsLeftOut;
}

double* vtkExaBricksVolumeMapper::GetBounds()
{
  vtkMath::UninitializeBounds(this->Bounds);
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    this->GetInputAlgorithm(0, 0)->Update();
    vtkOverlappingAMR* amr = vtkOverlappingAMR::SafeDownCast(this->GetDataObjectInput());
    // An AMR that was never initialised has no bounds to ask for in VTK before 9.6.
    if (amr && amr->GetNumberOfLevels() > 0 && exabricks::getFirstBlock(amr))
    {
      amr->GetBounds(this->Bounds);
    }
  }
  return this->Bounds;
}

void vtkExaBricksVolumeMapper::Update(int vtkNotUsed(port))
{
  // vtkVolume updates before each picture, and Render() once more: a fault is said once.
  const std::string fault = this->Internals->ConfigureBuilder(this);
  if (!fault.empty() && fault != this->Internals->ConfigurationFault)
  {
    vtkErrorMacro(<< fault << ".");
  }
  this->Internals->ConfigurationFault = fault;
  if (fault.empty())
  {
    this->Internals->Builder->Update();
  }
}

void vtkExaBricksVolumeMapper::Render(vtkRenderer* ren, vtkVolume* vol)
{
  vtkInternals& internals = *this->Internals;
  vtkVolumeProperty* property = vol->GetProperty();
  if (ren->GetSelector())
  {
    return; // blended colours would be taken for ids
  }
  this->Drawn = false;
  if (!internals.CheckSupport(this, ren, property))
  {
    return;
  }
  this->Update();
  const vtkExaBricksData* data = internals.Builder->GetOutput();
  if (!internals.ConfigurationFault.empty() || !data || !data->GetContents() ||
    ren->GetRenderWindow()->CheckAbortStatus())
  {
    return; // the builder has said why, or was told to stop
  }
  this->InvokeEvent(vtkCommand::VolumeMapperRenderStartEvent, nullptr);
  const double start = vtkTimerLog::GetUniversalTime();
  std::string fault = internals.CheckValues(this, property);
  try
  {
    internals.UpdateRenderer(this, property);
  }
  catch (const std::bad_alloc&)
  {
    internals.Contents.reset();
    fault = "out of memory on the host";
  }

  const auto viewport = exabricks::OpenGLPicture::findViewport(ren);
  if (fault.empty() && viewport.width > 0 && viewport.height > 0)
  {
    exabricks::View view = exabricks::makeView(ren, vol, *internals.Contents);
    view.width = viewport.width;
    view.height = viewport.height;
    const bool hasDepth = exabricks::OpenGLPicture::readDepth(ren, viewport, internals.Depth);
    view.depth = hasDepth ? internals.Depth.data() : nullptr;
    view.reconstruction = static_cast<exabricks::Reconstruction>(this->Reconstruction);
    view.stepScale = this->StepScale;
    view.errorTolerance = this->ErrorTolerance;
    view.opacityUnitDistance = property->GetScalarOpacityUnitDistance(0);
    view.terminationOpacity = this->EarlyTerminationOpacity;
    fault = internals.Renderer.render(view, internals.Pixels);
    if (fault.empty() && !internals.Picture.draw(ren, viewport, internals.Pixels))
    {
      fault = "expected OpenGL to take a picture of " + std::to_string(viewport.width) + " x " +
        std::to_string(viewport.height) + " pixels as a float texture, it refused";
    }
  }
  if (!fault.empty() && fault != internals.SaidFault)
  {
    vtkErrorMacro("The volume is not drawn: " << fault << ".");
  }
  internals.SaidFault = fault;
  this->Drawn = fault.empty();
  this->TimeToDraw = vtkTimerLog::GetUniversalTime() - start;
  this->InvokeEvent(vtkCommand::VolumeMapperRenderEndEvent, nullptr);
}

void vtkExaBricksVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Picture.release(window);
  this->Internals->Renderer.release();
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkExaBricksVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Reconstruction: " << this->GetReconstructionAsString() << "\n";
  os << indent << "StepScale: " << this->StepScale << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "Traversal: " << this->GetTraversalAsString() << "\n";
  os << indent << "EarlyTerminationOpacity: " << this->EarlyTerminationOpacity << "\n";
  os << indent << "VectorMode: " << (this->VectorMode == COMPONENT ? "Component" : "Magnitude")
     << "\n";
  os << indent << "VectorComponent: " << this->VectorComponent << "\n";
  os << indent << "Device: " << (this->Device ? this->Device : "(best)") << "\n";
  os << indent << "Drawn: " << this->Drawn << "\n";
  os << indent << "DeviceName: " << this->GetDeviceName() << "\n";
  os << indent << "TraversalUsed: " << this->GetTraversalUsed() << "\n";
  os << indent << "NumberOfActiveRegions: " << this->GetNumberOfActiveRegions() << "\n";
  os << indent << "LevelsLeftOut: " << this->GetLevelsLeftOut() << "\n";
  os << indent << "DeviceMemory: " << this->GetDeviceMemory() << " bytes\n";
}
