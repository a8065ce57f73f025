// SPDX-License-Identifier: BSD-3-Clause
#include "Results.h"

#include "Failure.h"
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

const Column<SceneFigures> sceneColumns[] = { { "levels", &SceneFigures::levels, 1 },
  { "blocks", &SceneFigures::blocks, 1 }, { "leaf_cells", &SceneFigures::leafCells, 1 },
  { "bricks", &SceneFigures::bricks, 1 }, { "regions", &SceneFigures::regions, 1 },
  { "active_regions", &SceneFigures::activeRegions, 1 },
  { "structure_s", &SceneFigures::structureTime, 1 }, { "gather_s", &SceneFigures::gatherTime, 1 },
  { "ranges_s", &SceneFigures::rangesTime, 1 }, { "scalars_mib", &SceneFigures::scalarBytes, MiB },
  { "bricks_mib", &SceneFigures::brickBytes, MiB },
  { "regions_device_mib", &SceneFigures::regionBytes, MiB },
  { "regions_host_mib", &SceneFigures::regionHostBytes, MiB },
  { "kd_tree_mib", &SceneFigures::kdTreeBytes, MiB },
  { "acceleration_mib", &SceneFigures::accelerationBytes, MiB },
  { "surface_mib", &SceneFigures::surfaceBytes, MiB },
  { "total_kd_tree_mib", &SceneFigures::kdTreeTotal, MiB },
  { "total_ray_query_mib", &SceneFigures::rayQueryTotal, MiB },
  { "host_mib", &SceneFigures::hostBytes, MiB },
  { "frame_kd_tree_ms", &SceneFigures::frameKdTree, Milli },
  { "frame_ray_query_ms", &SceneFigures::frameRayQuery, Milli },
  { "frame_by_tolerance_ms", &SceneFigures::frameByTolerance, Milli },
  { "frame_of_all_levels_ms", &SceneFigures::frameOfAllLevels, Milli },
  { "levels_left_out", &SceneFigures::levelsLeftOut, 1 },
  { "truth_s", &SceneFigures::truthTime, 1 }, { "truth_error", &SceneFigures::truthError, 1 },
  { "mean_opacity", &SceneFigures::meanOpacity, 1 } };

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

template <typename Row, std::size_t Count>
void takeNumbers(
  const CsvTable& table, std::size_t i, Row& row, const Column<Row> (&columns)[Count])
{
  for (const Column<Row>& column : columns)
  {
    row.*column.member = table.number(i, column.name) / column.scale;
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

CsvTable toTable(const std::vector<SceneFigures>& rows)
{
  std::vector<std::string> names{ "scene", "group" };
  addNames(names, sceneColumns);
  CsvTable table(names);
  for (const SceneFigures& row : rows)
  {
    std::vector<std::string> fields{ row.scene, row.group };
    addNumbers(fields, row, sceneColumns);
    table.add(fields);
  }
  return table;
}

std::vector<SceneFigures> toScenes(const CsvTable& table)
{
  std::vector<SceneFigures> rows(table.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    rows[i].scene = table.field(i, "scene");
    rows[i].group = table.field(i, "group");
    takeNumbers(table, i, rows[i], sceneColumns);
  }
  return rows;
}

void write(const CsvTable& table, const std::string& folder, const char* name)
{
  const std::string path = (std::filesystem::path(folder) / name).string();
  if (table.size() > 0)
  {
    render::WriteText(path, table.text());
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

Results readResults(const std::string& folder)
{
  const auto read = [&](const char* name)
  { return CsvTable::read((std::filesystem::path(folder) / name).string()); };
  const CsvTable table = read("results.csv");
  std::vector<std::string> expected{ "scene", "method", "role", "parameter", "rounds", "note" };
  addNames(expected, resultColumns);
  for (const std::string& column : expected)
  {
    if (!table.has(column))
    {
      throw render::Failure(render::ExitCode::InputUnreadable,
        "'" + folder + "' holds no results.csv with a column '" + column +
          "'. Measure first: exabricks-benchmark --quick --output " + folder);
    }
  }
  Results results;
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    Result row;
    row.scene = table.field(i, "scene");
    row.method = table.field(i, "method");
    const std::string role = table.field(i, "role");
    row.role = role == nameOf(Role::Ours) ? Role::Ours
      : role == nameOf(Role::Peer)        ? Role::Peer
                                          : Role::Baseline;
    row.parameter = table.field(i, "parameter");
    row.rounds = static_cast<int>(table.number(i, "rounds"));
    row.note = table.field(i, "note");
    takeNumbers(table, i, row, resultColumns);
    results.rows.push_back(row);
  }
  results.scenes = toScenes(read("scenes.csv"));
  results.growth = toScenes(read("growth.csv"));
  results.changes = read("changes.csv");
  const CsvTable machine = read("machine.csv");
  for (std::size_t i = 0; i < machine.size(); ++i)
  {
    results.machine.emplace_back(machine.field(i, "name"), machine.field(i, "value"));
  }
  return results;
}
}
}
