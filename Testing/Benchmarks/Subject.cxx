// SPDX-License-Identifier: BSD-3-Clause
#include "Subject.h"

#include "Adapters/AMRInput.h"
#include "Adapters/TransferFunctionInput.h"
#include "Adapters/ViewInput.h"

#include "Display.h"
#include "Failure.h"
#include "Logarithm.h"
#include "OpenAMR.h"
#include "Picture.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksVolumeMapper.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkVolumeCollection.h"
#include "vtkVolumeProperty.h"

#include <glm/ext/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include <fstream>

namespace exabricks
{
namespace benchmarks
{
Subject::Subject(const Request& request)
  : Asked(request.draw)
{
  render::AMRFile file(this->Asked.Input);
  const render::ArrayInfo* chosen = nullptr;
  for (const render::ArrayInfo& array : file.Arrays())
  {
    const bool fits =
      this->Asked.Array.empty() ? array.Components == 1 : array.Name == this->Asked.Array;
    chosen = !chosen && fits ? &array : chosen;
  }
  if (!chosen)
  {
    throw render::Failure(render::ExitCode::BadArguments,
      "There is no cell array '" + this->Asked.Array + "' in '" + this->Asked.Input + "'.");
  }
  this->AMR = file.Read(chosen->Name, this->Asked.Levels, true);
  this->Array = this->Asked.Log
    ? render::AddLogarithm(this->AMR, chosen->Name, this->Asked.Component)
    : chosen->Name;
  const int components = this->Asked.Log ? 1 : chosen->Components;
  this->Component = components > 1 ? this->Asked.Component.value_or(-1) : -1;

  this->Window = render::MakeWindow();
  this->Picture = std::make_unique<render::Picture>(
    this->Asked, this->Window, this->AMR, this->Array, components);
  this->Picture->Prepare();
  this->Contents = this->Picture->Data()->GetContents();
  this->Volume = vtkVolume::SafeDownCast(this->renderer()->GetVolumes()->GetItemAsObject(0));
  if (!request.scene.empty())
  {
    this->ApplyScene(request.scene);
  }
}

Subject::~Subject() = default;

void Subject::ApplyScene(const std::string& path)
{
  const auto scene = nlohmann::json::parse(std::ifstream(path));
  vtkNew<vtkColorTransferFunction> colors;
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const auto& row : scene.at("tf"))
  {
    colors->AddRGBPoint(row[0], row[1], row[2], row[3]);
    opacity->AddPoint(row[0], row[4]);
  }
  this->property()->SetColor(colors);
  this->property()->SetScalarOpacity(opacity);
  this->property()->SetScalarOpacityUnitDistance(scene.at("unit_distance"));
  vtkCamera* camera = this->renderer()->GetActiveCamera();
  const auto& view = scene.at("camera");
  const auto vector = [&view](const char* name)
  { return view.at(name).get<std::array<double, 3>>(); };
  camera->SetPosition(vector("position").data());
  camera->SetFocalPoint(vector("focal").data());
  camera->SetViewUp(vector("up").data());
  camera->SetViewAngle(view.at("view_angle"));
  double bounds[6];
  this->Picture->Data()->GetBounds(bounds);
  this->renderer()->ResetCameraClippingRange(bounds);
}

double Subject::hostBytes() const
{
  return 1024.0 * static_cast<double>(this->Picture->Data()->GetActualMemorySize());
}

vtkRenderer* Subject::renderer() const { return this->Picture->Renderer(); }

View Subject::makeView(const std::array<int, 2>& size, double stepScale) const
{
  this->Window->SetSize(size[0], size[1]); // it gives the camera its aspect
  View view = exabricks::makeView(this->renderer(), this->Volume, *this->Contents);
  view.width = size[0];
  view.height = size[1];
  view.stepScale = stepScale;
  view.opacityUnitDistance = this->property()->GetScalarOpacityUnitDistance();
  return view;
}

reference::Image Subject::renderOracle(const std::array<int, 2>& size, double& error) const
{
  const AMRInput input = readAMR(this->AMR);
  AMRCellSource source(input, this->Component);
  for (std::size_t b = 0; b < input.grids.size(); ++b)
  {
    source.setArray(
      static_cast<int>(b), input.grids[b]->GetCellData()->GetArray(this->Array.c_str()));
  }
  const LeafBoxes leaves = findLeafBoxes(input.hierarchy);
  const reference::Oracle oracle(input.hierarchy, leaves, source);

  const View mapped = this->makeView(size, 1.0);
  reference::View view;
  // Half cells count from the lower corner of the bounds.
  glm::dmat4 toLogical = glm::translate(glm::dmat4(1.0), glm::dvec3(leaves.bounds.lo));
  toLogical = glm::scale(toLogical, glm::dvec3(0.5));
  view.ndcToLogical = toLogical * mapped.ndcToHalfCells;
  view.ndcToWorld = mapped.ndcToWorld;
  view.width = size[0];
  view.height = size[1];
  reference::Oracle::Settings settings;
  settings.opacityUnitDistance = mapped.opacityUnitDistance;
  return oracle.render(
    view, makeTransferFunction(this->property(), this->Contents->Scalars.range), settings, error);
}

void Subject::measureBuilds(
  int builds, std::vector<double>& structure, std::vector<double>& scalars) const
{
  for (int i = 0; i < builds; ++i)
  {
    vtkNew<vtkExaBricksBuilder> builder;
    builder->SetInputDataObject(this->AMR);
    builder->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, this->Array.c_str());
    builder->SetVectorMode(
      this->Component >= 0 ? vtkExaBricksBuilder::COMPONENT : vtkExaBricksBuilder::MAGNITUDE);
    builder->SetVectorComponent(std::max(this->Component, 0));
    builder->Update();
    structure.push_back(builder->GetOutput()->GetStructureTime());
    scalars.push_back(builder->GetOutput()->GetScalarsTime());
  }
}
}
}
