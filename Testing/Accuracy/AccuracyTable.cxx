// SPDX-License-Identifier: BSD-3-Clause
// Measures how near reconstructions are to analytic fields, and pictures to the integral of their
// own field:
//
//   AccuracyTable <folder>
//
// Writes to the folder
//   reconstruction_errors.csv  greatest and RMS error by field, ratio of levels, zone and cell
//   width level_change.csv           what the basis makes of a linear field across a level change
//   integration_errors.csv     RMS error of pictures against the distance of samples
//   picture_errors.csv         PSNR against the picture of the analytic field, by cell width
// of which Utilities/report draws the tables and charts of Documentation/Accuracy.md.
#include "Accuracy/CsvTable.h"
#include "Accuracy/PictureAccuracy.h"
#include "Accuracy/StepOrder.h"

#include <cmath>
#include <cstdio>

using namespace exabricks;
using namespace exabricks::accuracy;

namespace
{
const std::vector<Method> methods{ Method::Nearest, Method::Basis, Method::Corrected,
  Method::CompletedBeyond, Method::Completed };

CsvTable measureReconstruction()
{
  CsvTable table({ "field", "ratio", "method", "zone", "coarse_width", "max", "rms" });
  for (const Field& field :
    { quadratic({ 0.3, 0.2, 0.4 }), gaussian({ 0.4, 0.45, 0.55 }, 0.3), movingFront(0.35, 0.15) })
  {
    for (const int ratio : { 1, 2, 3, 4 })
    {
      const std::vector<int> sizes =
        ratio < 4 ? std::vector<int>{ 8, 16, 32, 64 } : std::vector<int>{ 8, 16, 32 };
      for (const ErrorRow& row : measureErrors(field, ratio, sizes, methods, 8000))
      {
        table.add({ row.field, std::to_string(row.ratio), nameOf(row.method), nameOf(row.zone),
          csvNumber(row.coarseWidth), csvNumber(row.max), csvNumber(row.rms) });
      }
    }
  }
  return table;
}

// The field x across a level change in the plane x = 0, in fine cells; coarse cells on the left.
CsvTable traceLevelChange()
{
  CsvTable table({ "method", "ratio", "x", "value" });
  for (int i = -99; i <= 99; ++i)
  {
    const double x = i * 0.03 + 0.001; // beside the jumps of nearest
    for (const int ratio : { 2, 3, 4 })
    {
      table.add(
        { "basis", std::to_string(ratio), csvNumber(x), csvNumber(basisAcrossLevels(ratio, x)) });
    }
    const double nearest = x < 0.0 ? 2.0 * std::floor(x / 2.0) + 1.0 : std::floor(x) + 0.5;
    table.add({ "nearest", "2", csvNumber(x), csvNumber(nearest) });
  }
  return table;
}

CsvTable measureIntegration()
{
  CsvTable table({ "transfer_function", "step_scale", "opacity_rms", "colour_rms" });
  for (const StepScene& scene : kinkedScenes())
  {
    for (const StepError& row : measureStepErrors(scene))
    {
      table.add(
        { scene.name, csvNumber(row.stepScale), csvNumber(row.opacity), csvNumber(row.color) });
    }
  }
  return table;
}

struct PictureCase
{
  std::string field;
  Field analytic;
  std::vector<Grid> grids;
};

CsvTable measurePictureCases()
{
  const std::vector<PictureCase> cases{
    { "Gaussian across a level change of ratio 2", gaussian({ 0.4, 0.45, 0.55 }, 0.2),
      { makeBoxGrid(2, 8), makeBoxGrid(2, 16), makeBoxGrid(2, 32), makeBoxGrid(2, 64) } },
    { "Front through level changes of ratio 2 and the bounds", movingFront(0.35, 0.15),
      { makeBoxGrid(2, 8), makeBoxGrid(2, 16), makeBoxGrid(2, 32), makeBoxGrid(2, 64) } },
    { "Shell and blobs, 3 levels of ratio 2", shellAndBlobs(),
      { makeShellGrid({ 2, 2 }, 8), makeShellGrid({ 2, 2 }, 16), makeShellGrid({ 2, 2 }, 32) } }
  };
  CsvTable table({ "field", "transfer_function", "method", "finest_width", "psnr" });
  for (const PictureCase& c : cases)
  {
    for (const bool veils : { false, true })
    {
      const TransferFunction transfer = veils ? veilTransfer() : rampTransfer();
      for (const PictureRow& row :
        measurePictures(c.analytic, c.grids, transfer, PictureSettings()))
      {
        table.add({ c.field, veils ? "veils" : "ramp", nameOf(row.method),
          csvNumber(row.finestWidth), csvNumber(row.psnr) });
      }
    }
  }
  return table;
}
}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::fprintf(stderr, "usage: AccuracyTable <folder>\n");
    return 1;
  }
  const std::pair<const char*, CsvTable (*)()> tables[] = { { "reconstruction_errors.csv",
                                                              measureReconstruction },
    { "level_change.csv", traceLevelChange }, { "integration_errors.csv", measureIntegration },
    { "picture_errors.csv", measurePictureCases } };
  for (const auto& table : tables)
  {
    const std::string file = std::string(argv[1]) + "/" + table.first;
    std::printf("%s\n", table.first);
    std::fflush(stdout);
    if (!table.second().write(file))
    {
      std::fprintf(stderr, "AccuracyTable: '%s' cannot be written.\n", file.c_str());
      return 1;
    }
  }
  return 0;
}
