// SPDX-License-Identifier: BSD-3-Clause
#include "Measure.h"

#include "MakeAMR.h"

#include "Adapters/AMRCellSource.h"
#include "Adapters/PropertyInput.h"
#include "Adapters/ViewInput.h"
#include "Vulkan/Device.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <stdexcept>

namespace exabricks
{
namespace stability
{
namespace
{
Hierarchy inWorld(const Setting& setting)
{
  Hierarchy world = setting.hierarchy;
  world.origin *= setting.scale;
  world.spacing *= setting.scale;
  return world;
}
}

VolumeRenderer& Renderers::get(Reconstruction reconstruction, Traversal traversal)
{
  VolumeRenderer& renderer =
    this->All[reconstruction == Reconstruction::Nearest][traversal == Traversal::KdTree];
  renderer.selectTraversal(traversal);
  return renderer;
}

void setCamera(const Setting& setting, vtkCamera* camera)
{
  const glm::dvec3 origin = setting.scale * setting.hierarchy.origin;
  const glm::dvec3 position = origin + setting.camera.position;
  const glm::dvec3 focalPoint = origin + setting.camera.focalPoint;
  camera->SetPosition(position.x, position.y, position.z);
  camera->SetFocalPoint(focalPoint.x, focalPoint.y, focalPoint.z);
  camera->SetViewUp(setting.camera.viewUp.x, setting.camera.viewUp.y, setting.camera.viewUp.z);
  camera->SetParallelProjection(setting.camera.viewAngle > 0.0 ? 0 : 1);
  camera->SetParallelScale(setting.camera.parallelScale);
  camera->SetViewAngle(setting.camera.viewAngle > 0.0 ? setting.camera.viewAngle : 30.0);
  camera->SetClippingRange(setting.camera.nearest, setting.camera.farthest);
}

void setProperty(const Setting& setting, vtkVolumeProperty* property)
{
  vtkNew<vtkColorTransferFunction> colors;
  vtkNew<vtkPiecewiseFunction> opacity;
  colors->AllowDuplicateScalarsOn();
  opacity->AllowDuplicateScalarsOn();
  for (const Node& node : setting.transfer)
  {
    colors->AddRGBPoint(node.value, node.color.r, node.color.g, node.color.b);
    opacity->AddPoint(node.value, node.color.a);
  }
  property->SetColor(colors);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(setting.unitDistance / setting.scale);
  property->SetInterpolationTypeToLinear();
  property->ShadeOff();
}

void setMatrix(const Setting& setting, vtkVolume* volume)
{
  vtkNew<vtkMatrix4x4> matrix;
  for (int axis = 0; axis < 3; ++axis)
  {
    matrix->SetElement(axis, axis, setting.scale);
  }
  volume->SetUserMatrix(matrix);
  volume->ComputeMatrix();
}

Subject::Subject(Setting setting)
  : Given(std::move(setting))
{
  if (this->Given.amr)
  {
    vtkNew<vtkExaBricksBuilder> builder;
    builder->SetInputDataObject(this->Given.amr);
    builder->Update();
    this->Bricked = builder->GetOutput()->GetBrickedVolume();
  }
  else
  {
    this->Build();
  }
  if (!this->Bricked)
  {
    throw std::runtime_error("the builder refuses the data");
  }
}

Subject::~Subject() = default;

void Subject::Build()
{
  const Hierarchy& hierarchy = this->Given.hierarchy;
  auto bricked = std::make_shared<BrickedVolume>();
  bricked->volume.structure = std::make_shared<const Structure>(buildStructure(hierarchy));
  bricked->origin = hierarchy.origin;
  bricked->spacing = hierarchy.spacing;
  bricked->volume.values = makeValues(*bricked->volume.structure, *this->Given.cells);
  this->Bricked = std::move(bricked);
}

std::vector<reference::View> Subject::Views(Reconstruction reconstruction) const
{
  const reference::View view = reference::makeView(
    inWorld(this->Given), this->Given.camera, this->Given.width, this->Given.height);
  if (this->Given.beside == 0.0)
  {
    return { view };
  }
  std::vector<reference::View> views;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 side(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    views.push_back(view);
    views.back().ndcToLogical =
      glm::translate(glm::dmat4(1.0), this->Given.beside * side) * view.ndcToLogical;
    if (reconstruction == Reconstruction::Basis)
    {
      break; // continuous: all sides are alike
    }
  }
  return views;
}

reference::Oracle Subject::MakeOracle() const
{
  if (this->Given.field)
  {
    const Hierarchy& hierarchy = this->Given.hierarchy;
    return { hierarchy, findLeafBoxes(hierarchy), FieldSource(hierarchy, this->Given.field) };
  }
  const AMRInput input = readAMR(this->Given.amr);
  AMRCellSource source(input, -1);
  for (std::size_t b = 0; b < input.grids.size(); ++b)
  {
    source.setArray(static_cast<int>(b), input.grids[b]->GetCellData()->GetArray("value"));
  }
  return { input.hierarchy, findLeafBoxes(input.hierarchy), source };
}

std::vector<reference::Image> Subject::truths(Reconstruction reconstruction) const
{
  const reference::Reconstruction field = reconstruction == Reconstruction::Nearest
    ? reference::Reconstruction::Nearest
    : reference::Reconstruction::Basis;
  std::vector<reference::Image> images;
  if (this->Given.truth)
  {
    for (const reference::View& view : this->Views(reconstruction))
    {
      images.push_back(this->Given.truth(view, field));
    }
    return images;
  }
  const reference::Oracle oracle = this->MakeOracle();
  reference::Oracle::Settings settings;
  settings.reconstruction = field;
  settings.opacityUnitDistance = this->Given.unitDistance;
  const TransferFunction transfer = normalize(this->Given.transfer, oracle.range());
  for (const reference::View& view : this->Views(reconstruction))
  {
    images.push_back(oracle.render(view, transfer, settings));
  }
  return images;
}

reference::Image Subject::draw(
  Renderers& renderers, Reconstruction reconstruction, Traversal traversal) const
{
  vtkNew<vtkRenderer> scene;
  vtkCamera* camera = scene->GetActiveCamera();
  setCamera(this->Given, camera);
  // Without a window the renderer does not know its shape.
  camera->UseExplicitAspectRatioOn();
  camera->SetExplicitAspectRatio(static_cast<double>(this->Given.width) / this->Given.height);
  vtkNew<vtkVolume> volume;
  setMatrix(this->Given, volume);
  vtkNew<vtkVolumeProperty> property;
  setProperty(this->Given, property);

  View view = makeView(scene, volume, *this->Bricked, this->Given.width, this->Given.height);
  view.quality.reconstruction = reconstruction;
  view.quality.stepScale = this->Given.stepScale;
  view.opacityUnitDistance = this->Given.unitDistance / this->Given.scale;
  view.quality.terminationOpacity = 1.0; // never
  VolumeRenderer& renderer = renderers.get(reconstruction, traversal);
  const std::shared_ptr<vulkan::Device> device = vulkan::Device::acquire("");
  const std::uint64_t largest = device->maximumValueBuffer();
  device->limitValueBuffers(std::min(largest, this->Given.largestValueBuffer));
  const Volume& subject = this->Bricked->volume;
  renderer.setVolume(subject);
  renderer.setTransferFunction(makeTransferFunction(property, subject.values->range));
  std::vector<glm::vec4> pixels;
  const std::string fault = renderer.render(view, pixels);
  renderer.setVolume({}); // gives back what it takes
  device->limitValueBuffers(largest);
  if (!fault.empty())
  {
    throw std::runtime_error(fault);
  }
  pixels.resize(static_cast<std::size_t>(view.target.width) * view.target.height);
  return { view.target.width, view.target.height, { pixels.begin(), pixels.end() } };
}

Errors compare(
  const reference::Image& picture, const std::vector<reference::Image>& truths, int channels)
{
  Errors errors;
  const std::size_t count = picture.pixels.size();
  double sum = 0.0;
  std::size_t drawn = 0;
  std::size_t covered = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    double least = std::numeric_limits<double>::infinity();
    double greatest = least;
    bool shown = picture.pixels[i].a > 0.0 && channels == 4;
    bool there = false;
    for (const reference::Image& truth : truths)
    {
      there = there || truth.pixels[i].a > 0.0;
      double squares = 0.0;
      double most = 0.0;
      for (int c = 0; c < channels; ++c)
      {
        const double difference = std::abs(picture.pixels[i][c] - truth.pixels[i][c]);
        squares += difference * difference;
        most = std::max(most, difference);
        shown = shown || picture.pixels[i][c] > 0.0;
      }
      if (squares < least) // false for NaN
      {
        least = squares;
        greatest = most;
      }
    }
    sum += least;
    errors.greatest = std::max(errors.greatest, greatest);
    drawn += shown || there;
    covered += there;
  }
  const auto decibel = [&](std::size_t pixels)
  {
    return -10.0 *
      std::log10(sum / (channels * static_cast<double>(std::max<std::size_t>(pixels, 1))));
  };
  errors.all = decibel(count);
  errors.drawn = decibel(drawn);
  errors.coverage = static_cast<double>(covered) / static_cast<double>(count);
  return errors;
}
}
}
