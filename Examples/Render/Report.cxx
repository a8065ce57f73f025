// SPDX-License-Identifier: BSD-3-Clause

#include "Report.h"

#include "Picture.h"
#include "Video.h"

#include "vtkCamera.h"
#include "vtkExaBricksData.h"
#include "vtkExaBricksVolumeMapper.h"
#include "vtkImageData.h"
#include "vtkRenderer.h"
#include "vtkVersion.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace render
{

namespace
{

using Json = nlohmann::ordered_json;

std::vector<std::string> otherArrays(const Run& run)
{
  std::vector<std::string> names;
  for (const ArrayInfo& array : run.File.Arrays())
  {
    if (array.Name != run.Array.Name)
    {
      names.push_back(array.Name);
    }
  }
  return names;
}

std::string inMebibytes(double bytes)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << bytes / 1048576.0 << " MiB";
  return text.str();
}

std::string inMilliseconds(double seconds)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(seconds < 0.1 ? 2 : 0) << 1000.0 * seconds << " ms";
  return text.str();
}

double hostBytes(vtkExaBricksData* data) { return 1024.0 * data->GetActualMemorySize(); }

// A line of the report: its name, then the text.
std::ostream& startLine(std::ostream& out, const char* name)
{
  return out << std::left << std::setw(10) << name;
}

// The largest difference from the background in the picture, of 255.
int largestContrast(const Run& run)
{
  auto image = run.Result.Pixels();
  const auto* value = static_cast<const unsigned char*>(image->GetScalarPointer());
  const vtkIdType values = 3 * image->GetNumberOfPoints();
  int largest = 0;
  for (vtkIdType i = 0; i < values; ++i)
  {
    const int background = static_cast<int>(std::lround(255.0 * run.Asked.Background[i % 3]));
    largest = std::max(largest, std::abs(value[i] - background));
  }
  return largest;
}

void printNotes(std::ostream& out, const Run& run)
{
  vtkExaBricksData* data = run.Result.Data();
  double range[2];
  data->GetScalarRange(range);
  const vtkIdType absent = data->GetNumberOfAbsentCells();
  if (absent > 0)
  {
    startLine(out, "Absent") << absent << " leaf cells, which hold "
                             << (run.Asked.Log ? "no number above zero" : "no number")
                             << ", or lie in embedded boundaries\n";
  }
  if (!run.Asked.Log && range[0] > 0.0 && range[1] > 1000.0 * range[0])
  {
    startLine(out, "Hint") << "the values span " << std::lround(std::log10(range[1] / range[0]))
                           << " decades: --log may show more\n";
  }
  if (run.LogChosen)
  {
    startLine(out, "Hint")
      << "nine of ten cells have less than a hundredth of the greatest value, so "
         "that logarithms are drawn: --linear draws the values themselves\n";
  }
  if (run.Result.Mapper()->GetNumberOfActiveRegions() == 0)
  {
    startLine(out, "Hint")
      << "nothing is visible: no value in the data has an opacity above zero\n";
  }
  else if (!run.Asked.Annotate && largestContrast(run) < 96)
  {
    startLine(out, "Hint") << "little is visible: try --opacity, a smaller --opacity-unit, another "
                              "--color-map or --background\n";
  }
}

Json cameraJson(const Run& run)
{
  vtkCamera* camera = run.Result.Renderer()->GetActiveCamera();
  auto vector = [](const double* v) { return Json{ v[0], v[1], v[2] }; };
  return { { "position", vector(camera->GetPosition()) },
    { "focal", vector(camera->GetFocalPoint()) }, { "up", vector(camera->GetViewUp()) },
    { "view_angle", camera->GetViewAngle() }, { "parallel", run.Asked.Parallel },
    { "parallel_scale", camera->GetParallelScale() } };
}

Json dataJson(vtkExaBricksData* data)
{
  double range[2], bounds[6], spacing[3];
  data->GetScalarRange(range);
  data->GetBounds(bounds);
  data->GetFinestSpacing(spacing);
  return { { "levels", data->GetNumberOfLevels() }, { "blocks", data->GetNumberOfBlocks() },
    { "leaf_cells", data->GetNumberOfLeafCells() },
    { "absent_cells", data->GetNumberOfAbsentCells() }, { "bricks", data->GetNumberOfBricks() },
    { "regions", data->GetNumberOfRegions() }, { "range", range }, { "bounds", bounds },
    { "finest_spacing", spacing } };
}

Json lookJson(const Run& run)
{
  Json opacity = Json::array();
  for (const OpacityPoint& point : run.Result.Opacity)
  {
    opacity.push_back({ point.Value, point.Opacity });
  }
  Json colors;
  for (const ColorPoint& point : run.Asked.Colors)
  {
    colors.push_back({ point.Value, point.Color[0], point.Color[1], point.Color[2] });
  }
  return { { "color_map", run.Asked.ColorMap }, { "color_range", run.Result.ColorRange },
    { "colors", colors }, { "opacity", opacity },
    { "opacity_from_histogram", run.Asked.Opacity.empty() && !run.Asked.Slice },
    { "opacity_unit", run.Result.OpacityUnit }, { "background", run.Asked.Background } };
}

// In the values drawn, as the look.
Json viewJson(const Run& run)
{
  vtkExaBricksVolumeMapper* mapper = run.Result.Mapper();
  Json values = Json::array();
  for (const double value : run.Asked.IsoValues)
  {
    values.push_back(run.Asked.Log ? std::log10(value) : value);
  }
  Json planes = Json::array();
  for (const Plane& plane : run.Asked.ClippingPlanes)
  {
    planes.push_back({ { "origin", plane.Origin }, { "normal", plane.Normal } });
  }
  Json view = { { "blend_mode", run.Asked.BlendMode }, { "iso_values", values },
    { "levels", { mapper->GetLevelRange()[0], mapper->GetLevelRange()[1] } },
    { "clipping_planes", planes }, { "cropping", nullptr }, { "shaded", run.Asked.Shaded },
    { "scattering", run.Asked.Scattering }, { "shadow_reach", run.Asked.ShadowReach } };
  view["slice"] = nullptr;
  if (run.Asked.Slice)
  {
    view["slice"] = { { "origin", run.Asked.Slice->Origin },
      { "normal", run.Asked.Slice->Normal } };
  }
  if (run.Asked.Cropping)
  {
    view["cropping"] = *run.Asked.Cropping;
  }
  return view;
}

Json timesJson(const Run& run)
{
  vtkExaBricksVolumeMapper* mapper = run.Result.Mapper();
  vtkExaBricksData* data = run.Result.Data();
  Json times = { { "read", run.ReadTime }, { "prepare", run.Result.PrepareTime },
    { "structure", data->GetStructureTime() }, { "scalars", data->GetScalarsTime() },
    { "upload", mapper->GetUploadTime() }, { "opacity", mapper->GetOpacityTime() },
    { "color", mapper->GetColorTime() }, { "march", mapper->GetMarchTime() },
    { "first_frame", run.Result.FirstFrameTime }, { "frames", run.Result.FrameTimes } };
  times["frame_median"] =
    run.Result.FrameTimes.empty() ? Json(nullptr) : Json(run.Result.MedianFrameTime());
  return times;
}

}

std::string arrayText(const Options& options, const ArrayInfo& array)
{
  std::string text = array.Name;
  if (array.Components > 1)
  {
    text += options.Component ? ", component " + std::to_string(*options.Component)
                              : std::string(", magnitude");
  }
  return options.Log ? "log10(" + text + ")" : text;
}

void printArrays(std::ostream& out, const AMRFile& file)
{
  for (const ArrayInfo& array : file.Arrays())
  {
    out << array.Name;
    if (array.Components > 1)
    {
      out << "  (" << array.Components << " components)";
    }
    if (array.Range[0] <= array.Range[1])
    {
      out << "  " << array.Range[0] << " to " << array.Range[1]
          << (array.Components > 1 ? ", magnitude" : "") << " on the coarsest level";
    }
    out << '\n';
  }
}

void printReport(std::ostream& out, const Run& run)
{
  vtkExaBricksData* data = run.Result.Data();
  vtkExaBricksVolumeMapper* mapper = run.Result.Mapper();
  double range[2];
  data->GetScalarRange(range);

  startLine(out, "Input") << run.Asked.Input << ", " << data->GetNumberOfLevels() << " levels, "
                          << data->GetNumberOfBlocks() << " blocks, "
                          << data->GetNumberOfLeafCells() << " leaf cells\n";
  startLine(out, "Array") << arrayText(run.Asked, run.Array) << ", " << range[0] << " to "
                          << range[1];
  std::string others;
  for (const std::string& name : otherArrays(run))
  {
    others += (others.empty() ? "" : ", ") + name;
  }
  out << (run.Asked.Array.empty() && !others.empty() ? "; others: " + others : "") << '\n';
  startLine(out, "Bricks") << data->GetNumberOfBricks() << " in " << data->GetNumberOfRegions()
                           << " regions, " << mapper->GetNumberOfActiveRegions()
                           << " of them active\n";
  if (mapper->GetLevelsLeftOut() > 0)
  {
    startLine(out, "Left out") << "finest levels, as the error tolerance allows: "
                               << mapper->GetLevelsLeftOut() << '\n';
  }
  const vtkIdType pixels = static_cast<vtkIdType>(run.Asked.Size[0]) * run.Asked.Size[1];
  if (mapper->GetErrorTolerance() > 0.0 && mapper->GetNumberOfRays() < pixels)
  {
    startLine(out, "Rays") << mapper->GetNumberOfRays() << " of " << pixels
                           << " pixels, as the error tolerance allows\n";
  }
  const char* device = mapper->GetDeviceName();
  const char* traversal = mapper->GetTraversalUsed();
  startLine(out, "Device") << (device ? device : "unknown") << ", "
                           << (traversal ? traversal : "unknown") << '\n';
  startLine(out, "Set-up") << "read " << inMilliseconds(run.ReadTime) << ", structure "
                           << inMilliseconds(data->GetStructureTime()) << ", scalars "
                           << inMilliseconds(data->GetScalarsTime()) << ", upload "
                           << inMilliseconds(mapper->GetUploadTime()) << '\n';
  startLine(out, "Changes") << "of colours " << inMilliseconds(mapper->GetColorTime())
                            << ", of opacity " << inMilliseconds(mapper->GetOpacityTime())
                            << ", of the camera " << inMilliseconds(mapper->GetMarchTime())
                            << " (marching)\n";
  startLine(out, "Frame") << "first " << inMilliseconds(run.Result.FirstFrameTime);
  if (!run.Result.FrameTimes.empty())
  {
    out << ", median of " << run.Result.FrameTimes.size() << " more "
        << inMilliseconds(run.Result.MedianFrameTime());
  }
  out << '\n';
  startLine(out, "Memory") << inMebibytes(hostBytes(data)) << " host, "
                           << inMebibytes(static_cast<double>(mapper->GetDeviceMemory()))
                           << " device\n";
  printNotes(out, run);
  startLine(out, "Picture") << run.Asked.Output << ", " << run.Asked.Size[0] << " x "
                            << run.Asked.Size[1];
  if (run.Asked.IsSeries())
  {
    out << ", "
        << (run.Asked.Turntable > 0 ? static_cast<std::size_t>(run.Asked.Turntable)
                                    : run.Asked.Inputs.size())
        << (Video::IsOne(run.Asked.Output) ? " of them" : " of them, numbered");
  }
  out << '\n';
}

std::string statisticsJson(const Run& run)
{
  vtkExaBricksVolumeMapper* mapper = run.Result.Mapper();
  const char* device = mapper->GetDeviceName();
  const char* traversal = mapper->GetTraversalUsed();

  Json json;
  json["program"] = { { "name", "exabricks-render" }, { "version", EXABRICKS_VERSION },
    { "vtk", vtkVersion::GetVTKVersion() } };
  json["input"] = { { "file", run.Asked.Input }, { "reader", run.File.ReaderName() },
    { "array", run.Array.Name }, { "components", run.Array.Components }, { "component", nullptr },
    { "log10", run.Asked.Log }, { "levels", nullptr }, { "other_arrays", otherArrays(run) } };
  if (run.Asked.Inputs.size() > 1)
  {
    json["input"]["series"] = run.Asked.Inputs;
  }
  if (run.Asked.Levels > 0)
  {
    json["input"]["levels"] = run.Asked.Levels;
  }
  if (run.Array.Components > 1)
  {
    json["input"]["component"] =
      run.Asked.Component ? Json(*run.Asked.Component) : Json("magnitude");
  }
  json["data"] = dataJson(run.Result.Data());
  json["picture"] = { { "file", run.Asked.Output }, { "size", run.Asked.Size },
    { "camera", cameraJson(run) }, { "look", lookJson(run) } };
  json["method"] = { { "device", device ? device : "" },
    { "traversal", traversal ? traversal : "" }, { "reconstruction", run.Asked.Reconstruction },
    { "step_scale", mapper->GetStepScale() }, { "error_tolerance", mapper->GetErrorTolerance() },
    { "active_regions", mapper->GetNumberOfActiveRegions() },
    { "levels_left_out", mapper->GetLevelsLeftOut() }, { "rays", mapper->GetNumberOfRays() } };
  json["view"] = viewJson(run);
  json["seconds"] = timesJson(run);
  json["bytes"] = { { "host", hostBytes(run.Result.Data()) },
    { "device", mapper->GetDeviceMemory() } };
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}
