// SPDX-License-Identifier: BSD-3-Clause
// Scenes from files, set up as the program exabricks-render does.
#include "SceneTable.h"

#include "VTKScene.h"

#include "Adapters/AMRCellSource.h"
#include "Adapters/PropertyInput.h"

#include "Display.h"
#include "Failure.h"
#include "OpenAMR.h"
#include "Picture.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkExaBricksData.h"
#include "vtkExaBricksFirstPicture.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace exabricks
{
namespace benchmarks
{
namespace
{
// The source refers to what it was made from.
struct AMRCells : public CellSource
{
  AMRCells(vtkOverlappingAMR* amr, const std::string& array, int component)
    : input(readAMR(amr))
    , source(input, component)
  {
    for (std::size_t b = 0; b < this->input.grids.size(); ++b)
    {
      this->source.setArray(
        static_cast<int>(b), this->input.grids[b]->GetCellData()->GetArray(array.c_str()));
    }
  }
  void read(int block, const Box& cells, double* values) const override
  {
    this->source.read(block, cells, values);
  }
  bool hasDuplicates(int block) const override { return this->source.hasDuplicates(block); }
  void readDuplicates(int block, const Box& cells, unsigned char* duplicate) const override
  {
    this->source.readDuplicates(block, cells, duplicate);
  }

  const AMRInput input;
  AMRCellSource source;
};

// { "camera": { "position": [x, y, z], "focal": [...], "up": [...], "view_angle": degrees },
//   "unit_distance": length, "tf": [[value, red, green, blue, opacity], ...] }
void applyScene(const std::string& path, vtkVolumeProperty* property, vtkCamera* camera)
{
  try
  {
    const auto scene = nlohmann::json::parse(std::ifstream(path));
    vtkNew<vtkColorTransferFunction> colors;
    vtkNew<vtkPiecewiseFunction> opacity;
    for (const auto& row : scene.at("tf"))
    {
      colors->AddRGBPoint(row.at(0), row.at(1), row.at(2), row.at(3));
      opacity->AddPoint(row.at(0), row.at(4));
    }
    property->SetColor(colors);
    property->SetScalarOpacity(opacity);
    property->SetScalarOpacityUnitDistance(scene.at("unit_distance"));
    const auto& view = scene.at("camera");
    const auto vector = [&view](const char* name)
    { return view.at(name).get<std::array<double, 3>>(); };
    camera->SetPosition(vector("position").data());
    camera->SetFocalPoint(vector("focal").data());
    camera->SetViewUp(vector("up").data());
    camera->SetViewAngle(view.at("view_angle"));
  }
  catch (const nlohmann::json::exception& error)
  {
    throw render::Failure(
      render::ExitCode::InputUnreadable, "'" + path + "' is not a scene: " + error.what());
  }
}

reference::Camera toCamera(vtkCamera* from, const glm::dvec3& origin)
{
  const auto vector = [](const double* v) { return glm::dvec3(v[0], v[1], v[2]); };
  reference::Camera camera;
  camera.position = vector(from->GetPosition()) - origin;
  camera.focalPoint = vector(from->GetFocalPoint()) - origin;
  camera.viewUp = vector(from->GetViewUp());
  camera.viewAngle = from->GetParallelProjection() ? 0.0 : from->GetViewAngle();
  camera.parallelScale = from->GetParallelScale();
  camera.nearest = from->GetClippingRange()[0];
  camera.farthest = from->GetClippingRange()[1];
  return camera;
}

struct DataSet
{
  const char* name;
  const char* file; // in one of the folders
  const char* array;
  bool log;
  const char* scene;             // likewise, or null
  bool full;                     // part of --full
  const char* shipped = nullptr; // the same data in another file, where the first is missing
};

const DataSet dataSets[] = {
  { "rt_medium magvort, as shipped", "rt_medium/rt_medium.vthb", "magvort", false, nullptr, false },
  { "rt_small density", "rt_pre/plt00214", "density", false, nullptr, true },
  { "rt_medium magvort", "rt_medium/plt00216", "magvort", false, nullptr, false },
  { "rt_medium magvort, scene", "rt_medium/plt00216", "magvort", false, "scene_rt_medium.json",
    true, "rt_medium/rt_medium.vthb" },
  { "sv_small phi", "sv_small/plt00046", "", false, nullptr, true },
  { "sv_aniso phi", "sv_aniso/plt00018", "", false, nullptr, false },
  { "sv_r24_many phi", "sv_r24_many/plt00070", "", false, nullptr, false },
  { "Enzo log10 Density", "Data/AMR/Enzo/DD0010/moving7_0010.hierarchy", "Density", true, nullptr,
    true },
  { "HierarchicalBoxDataset.v1.1", "Data/AMR/HierarchicalBoxDataset.v1.1.vthb", "", false, nullptr,
    false },
  { "PeleLMeX temp", "test_assets/example_plt_3d", "temp", false, nullptr, false },
  { "embedded boundary density", "plt_eb_3d_headerfixed", "", false, nullptr, false },
};

std::string find(const std::vector<std::string>& folders, const char* file)
{
  for (const std::string& folder : folders)
  {
    const std::filesystem::path path = std::filesystem::path(folder) / file;
    if (std::filesystem::exists(path))
    {
      return path.string();
    }
  }
  return {};
}
}

Model makeDataModel(const std::string& name, const InputScene& from)
{
  render::Options asked = from.draw;
  asked.Quiet = true;
  render::AMRFile file(asked.Input);
  const render::ArrayInfo* chosen = nullptr;
  for (const render::ArrayInfo& array : file.Arrays())
  {
    const bool fits = asked.Array.empty() ? array.Components == 1 : array.Name == asked.Array;
    chosen = !chosen && fits ? &array : chosen;
  }
  if (!chosen)
  {
    throw render::Failure(render::ExitCode::BadArguments,
      "There is no cell array '" + asked.Array + "' in '" + asked.Input +
        "'. exabricks-render --list-arrays says what is in it.");
  }
  auto vtk = std::make_shared<VTKScene>();
  vtk->amr = file.Read(chosen->Name, asked.Levels, true);
  vtk->array = asked.Log
    ? vtkExaBricksFirstPicture::AddLogarithm(vtk->amr, chosen->Name, asked.Component.value_or(-1))
    : chosen->Name;
  const int components = asked.Log ? 1 : chosen->Components;
  vtk->component = components > 1 ? asked.Component.value_or(-1) : -1;

  // What exabricks-render chooses.
  auto window = render::makeWindow();
  render::Picture picture(asked, window, vtk->amr, vtk->array, components);
  picture.Prepare();
  auto* volume = vtkVolume::SafeDownCast(picture.Renderer()->GetVolumes()->GetItemAsObject(0));
  vtk->property = volume->GetProperty();
  vtkCamera* camera = picture.Renderer()->GetActiveCamera();
  if (!from.scene.empty())
  {
    applyScene(from.scene, vtk->property, camera);
    double bounds[6];
    picture.Data()->GetBounds(bounds);
    picture.Renderer()->ResetCameraClippingRange(bounds);
  }

  const auto cells = std::make_shared<AMRCells>(vtk->amr, vtk->array, vtk->component);
  Model model;
  model.name = name;
  model.hierarchy = cells->input.hierarchy;
  model.cells = cells;
  model.transfer = [vtk](const Range& range) { return makeTransferFunction(vtk->property, range); };
  model.opacityUnitDistance = vtk->property->GetScalarOpacityUnitDistance();
  model.camera = toCamera(camera, model.hierarchy.origin);
  model.makeVTK = [vtk](const Scene&) { return vtk; };
  return model;
}

std::vector<SceneKind> listDataScenes(
  const std::vector<std::string>& folders, std::vector<std::string>& missing)
{
  std::vector<SceneKind> scenes;
  for (const DataSet& set : dataSets)
  {
    InputScene input;
    input.draw.Input = find(folders, set.file);
    if (input.draw.Input.empty() && set.shipped)
    {
      input.draw.Input = find(folders, set.shipped);
    }
    input.draw.Array = set.array;
    input.draw.Log = set.log;
    input.draw.Size = { 512, 512 }; // the camera is placed for pictures of this shape
    input.scene = set.scene ? find(folders, set.scene) : "";
    const std::string name = set.name;
    if (input.draw.Input.empty() || (set.scene && input.scene.empty()))
    {
      missing.push_back(
        name + ": there is no " + (input.draw.Input.empty() ? set.file : set.scene));
      continue;
    }
    const bool shipped = name == dataSets[0].name;
    scenes.push_back(
      { name, "data", shipped, set.full, [=](double) { return makeDataModel(name, input); } });
  }
  return scenes;
}
}
}
