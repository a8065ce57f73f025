// SPDX-License-Identifier: BSD-3-Clause
#include "Results.h"

#include "Output.h"

#include <filesystem>

namespace exabricks
{
namespace benchmarks
{
namespace
{
using accuracy::csvNumber;
using accuracy::CsvTable;

// A column: its name, the member, and what one unit of the member is in the file.
template <typename Row>
struct Column
{
  const char* name;
  double Row::*member;
  double scale;
};

constexpr double Milli = 1e3;
constexpr double MiB = 1.0 / 1048576.0;

const Column<Result> resultColumns[] = { { "value", &Result::value, 1 },
  { "wall_ms", &Result::wall, Milli }, { "cpu_ms", &Result::cpu, Milli },
  { "march_ms", &Result::march, Milli }, { "setup_s", &Result::setUp, 1 },
  { "resampling_s", &Result::resampling, 1 }, { "host_mib", &Result::hostBytes, MiB },
  { "device_mib", &Result::deviceBytes, MiB }, { "rmse", &Result::rmse, 1 },
  { "psnr", &Result::psnr, 1 }, { "psnr_drawn", &Result::psnrDrawn, 1 },
  { "ssim", &Result::ssim, 1 }, { "psnr_rgba", &Result::psnrRGBA, 1 },
  { "psnr_rgba_drawn", &Result::psnrRGBADrawn, 1 }, { "rmse_own", &Result::rmseOwn, 1 },
  { "samples", &Result::samples, 1 } };

const Column<SceneMeasurements> sceneColumns[] = { { "levels", &SceneMeasurements::levels, 1 },
  { "blocks", &SceneMeasurements::blocks, 1 }, { "leaf_cells", &SceneMeasurements::leafCells, 1 },
  { "bricks", &SceneMeasurements::bricks, 1 }, { "regions", &SceneMeasurements::regions, 1 },
  { "active_regions", &SceneMeasurements::activeRegions, 1 },
  { "structure_s", &SceneMeasurements::structureTime, 1 },
  { "gather_s", &SceneMeasurements::gatherTime, 1 },
  { "ranges_s", &SceneMeasurements::rangesTime, 1 },
  { "scalars_mib", &SceneMeasurements::scalarBytes, MiB },
  { "bricks_mib", &SceneMeasurements::brickBytes, MiB },
  { "regions_device_mib", &SceneMeasurements::regionBytes, MiB },
  { "regions_host_mib", &SceneMeasurements::regionHostBytes, MiB },
  { "kd_tree_mib", &SceneMeasurements::kdTreeBytes, MiB },
  { "acceleration_mib", &SceneMeasurements::accelerationBytes, MiB },
  { "surface_mib", &SceneMeasurements::surfaceBytes, MiB },
  { "total_kd_tree_mib", &SceneMeasurements::kdTreeTotal, MiB },
  { "total_ray_query_mib", &SceneMeasurements::rayQueryTotal, MiB },
  { "host_mib", &SceneMeasurements::hostBytes, MiB },
  { "frame_kd_tree_ms", &SceneMeasurements::frameKdTree, Milli },
  { "frame_ray_query_ms", &SceneMeasurements::frameRayQuery, Milli },
  { "frame_by_tolerance_ms", &SceneMeasurements::frameByTolerance, Milli },
  { "frame_of_all_levels_ms", &SceneMeasurements::frameOfAllLevels, Milli },
  { "levels_left_out", &SceneMeasurements::levelsLeftOut, 1 },
  { "truth_s", &SceneMeasurements::truthTime, 1 },
  { "truth_error", &SceneMeasurements::truthError, 1 },
  { "mean_opacity", &SceneMeasurements::meanOpacity, 1 } };

template <typename Row, std::size_t Count>
void addNames(std::vector<std::string>& names, const Column<Row> (&columns)[Count])
{
  for (const Column<Row>& column : columns)
  {
    names.emplace_back(column.name);
  }
}

template <typename Row, std::size_t Count>
void addNumbers(
  std::vector<std::string>& fields, const Row& row, const Column<Row> (&columns)[Count])
{
  for (const Column<Row>& column : columns)
  {
    fields.push_back(csvNumber(column.scale * row.*column.member));
  }
}

CsvTable toTable(const std::vector<Result>& rows)
{
  std::vector<std::string> names{ "scene", "method", "role", "parameter", "rounds", "note" };
  addNames(names, resultColumns);
  CsvTable table(names);
  for (const Result& row : rows)
  {
    std::vector<std::string> fields{ row.scene, row.method, nameOf(row.role), row.parameter,
      std::to_string(row.rounds), row.note };
    addNumbers(fields, row, resultColumns);
    table.add(fields);
  }
  return table;
}

CsvTable toTable(const std::vector<SceneMeasurements>& rows)
{
  std::vector<std::string> names{ "scene", "group" };
  addNames(names, sceneColumns);
  CsvTable table(names);
  for (const SceneMeasurements& row : rows)
  {
    std::vector<std::string> fields{ row.scene, row.group };
    addNumbers(fields, row, sceneColumns);
    table.add(fields);
  }
  return table;
}

void write(const CsvTable& table, const std::string& folder, const char* name)
{
  const std::string path = (std::filesystem::path(folder) / name).string();
  if (table.size() > 0)
  {
    render::writeText(path, table.text());
  }
  else
  {
    std::filesystem::remove(path); // of an earlier run
  }
}
}

std::string nameOf(Role role)
{
  return role == Role::Ours ? "ours" : role == Role::Baseline ? "baseline" : "peer";
}

void writeResults(const Results& results, const std::string& folder)
{
  write(toTable(results.rows), folder, "results.csv");
  write(toTable(results.scenes), folder, "scenes.csv");
  write(toTable(results.growth), folder, "growth.csv");
  write(results.changes, folder, "changes.csv");
  CsvTable machine({ "name", "value" });
  for (const auto& line : results.machine)
  {
    machine.add({ line.first, line.second });
  }
  write(machine, folder, "machine.csv");
}
}
}
