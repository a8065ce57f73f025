// SPDX-License-Identifier: BSD-3-Clause

#include "Scene.h"

#include "Failure.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <initializer_list>

namespace render
{

namespace
{

using Json = nlohmann::json;

[[noreturn]] void refuse(const std::string& path, const std::string& found)
{
  throw Failure(ExitCode::BadArguments,
    "'" + path + "' is not a scene: " + found +
      ". Give a file that --stats or the viewer's key w wrote.");
}

void readInput(const Json& input, Options& o)
{
  if (input.at("file").is_string())
  {
    o.Input = input.at("file");
  }
  if (input.contains("series"))
  {
    o.Inputs = input.at("series").get<std::vector<std::string>>();
  }
  o.Array = input.at("array");
  if (input.at("component").is_number_integer())
  {
    o.Component = input.at("component").get<int>();
  }
  o.Log = input.at("log10");
  o.Linear = !o.Log;
  if (input.at("levels").is_number_integer())
  {
    o.Levels = input.at("levels");
  }
}

void readCamera(const Json& camera, Options& o)
{
  o.Position = camera.at("position").get<Vector3>();
  o.Focal = camera.at("focal").get<Vector3>();
  o.Up = camera.at("up").get<Vector3>();
  o.ViewAngle = camera.at("view_angle");
  o.Parallel = camera.at("parallel");
  o.ParallelScale = camera.at("parallel_scale");
}

// Values are those drawn; options have those of the array.
void readLook(const Json& look, Options& o)
{
  const auto value = [&](double drawn) { return o.Log ? std::pow(10.0, drawn) : drawn; };
  o.ColorMap = look.at("color_map");
  o.Range = { { value(look.at("color_range").at(0)), value(look.at("color_range").at(1)) } };
  if (!((*o.Range)[0] < (*o.Range)[1]))
  {
    o.Range.reset(); // of one value alone
  }
  o.Colors.clear();
  if (!look.at("colors").is_null())
  {
    for (const Json& point : look.at("colors"))
    {
      o.Colors.push_back({ point.at(0), { { point.at(1), point.at(2), point.at(3) } } });
    }
  }
  o.Opacity.clear();
  for (const Json& point : look.at("opacity"))
  {
    o.Opacity.push_back({ value(point.at(0)), point.at(1) });
  }
  o.OpacityUnit = look.at("opacity_unit");
  o.Background = look.at("background").get<Vector3>();
}

void readView(const Json& view, Options& o)
{
  o.BlendMode = view.at("blend_mode");
  o.IsoValues.clear();
  for (const Json& value : o.BlendMode == "isosurface" ? view.at("iso_values") : Json::array())
  {
    o.IsoValues.push_back(o.Log ? std::pow(10.0, value.get<double>()) : value.get<double>());
  }
  o.Slice.reset();
  if (o.BlendMode == "slice")
  {
    const Json& plane = view.at("slice");
    o.Slice = Plane{ plane.at("origin").get<Vector3>(), plane.at("normal").get<Vector3>() };
  }
  o.LevelRange = view.at("levels").get<std::array<int, 2>>();
  o.ClippingPlanes.clear();
  for (const Json& plane : view.at("clipping_planes"))
  {
    o.ClippingPlanes.push_back(
      { plane.at("origin").get<Vector3>(), plane.at("normal").get<Vector3>() });
  }
  if (!view.at("cropping").is_null())
  {
    o.Cropping = view.at("cropping").get<std::array<double, 6>>();
  }
  o.Shaded = view.at("shaded");
  o.Scattering = view.value("scattering", 0.0);
  o.ShadowReach = view.value("shadow_reach", 0.0);
}

// What options are checked for as they are read.
void check(const std::string& path, const Options& o)
{
  const auto isOneOf = [](const std::string& name, std::initializer_list<const char*> names)
  { return std::find(names.begin(), names.end(), name) != names.end(); };
  if (o.Size[0] < 1 || o.Size[1] < 1)
  {
    refuse(path, "its picture has no size");
  }
  if (!isOneOf(o.Reconstruction, { "basis", "nearest", "completed" }))
  {
    refuse(path, "'" + o.Reconstruction + "' is no reconstruction");
  }
  if (!(o.ViewAngle > 0.0 && o.ViewAngle < 180.0) || !(o.OpacityUnit > 0.0) ||
    !(o.StepScale > 0.0) || !(o.ErrorTolerance >= 0.0 && o.ErrorTolerance < 1.0))
  {
    refuse(path,
      "expected a view_angle between 0 and 180, an opacity_unit and a step_scale above 0 and an "
      "error_tolerance in [0, 1), found others");
  }
}

}

void readScene(const std::string& path, Options& options)
{
  std::ifstream file(path);
  if (!file)
  {
    throw Failure(ExitCode::BadArguments, "There is no readable scene '" + path + "'.");
  }
  try
  {
    const Json scene = Json::parse(file);
    readInput(scene.at("input"), options);
    options.Size = scene.at("picture").at("size").get<std::array<int, 2>>();
    readCamera(scene.at("picture").at("camera"), options);
    readLook(scene.at("picture").at("look"), options);
    const Json& method = scene.at("method");
    options.Reconstruction = method.at("reconstruction");
    options.StepScale = method.at("step_scale");
    options.ErrorTolerance = method.at("error_tolerance");
    readView(scene.at("view"), options);
    check(path, options);
  }
  catch (const Json::exception& error)
  {
    refuse(path, error.what());
  }
}

}
