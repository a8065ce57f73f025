// SPDX-License-Identifier: BSD-3-Clause
// Measures how near reconstructions are to analytic fields, and pictures to the integral of their
// own field, and draws it:
//
//   AccuracyCharts <folder> [<file.csv>...]
//
// Writes PNGs, and their data as CSV, to the folder, and the figures to standard output. The files
// named after it are charts of error over step, measured elsewhere: columns chart, series, x, y.
#include "Accuracy/Charts.h"
#include "Accuracy/PictureAccuracy.h"
#include "Accuracy/StepOrder.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>

using namespace exabricks;
using namespace exabricks::accuracy;

namespace
{
constexpr Method methods[] = { Method::Nearest, Method::Basis, Method::Corrected,
  Method::CompletedBeyond, Method::Completed };

std::vector<std::pair<double, std::string>> fractions(int first, int last)
{
  std::vector<std::pair<double, std::string>> ticks;
  for (int n = first; n <= last; n *= 2)
  {
    ticks.emplace_back(1.0 / n, "1/" + std::to_string(n));
  }
  return ticks;
}

std::vector<ErrorRow> measureAllErrors()
{
  const std::vector<Method> all(std::begin(methods), std::end(methods));
  std::vector<ErrorRow> rows;
  std::printf("%-14s %5s  %-23s %-15s %9s %9s\n", "field", "ratio", "method", "zone", "order max",
    "order rms");
  for (const Field& field :
    { quadratic({ 0.3, 0.2, 0.4 }), gaussian({ 0.4, 0.45, 0.55 }, 0.3), movingFront(0.35, 0.15) })
  {
    for (const int ratio : { 1, 2, 3, 4 })
    {
      const std::vector<int> sizes =
        ratio < 4 ? std::vector<int>{ 8, 16, 32, 64 } : std::vector<int>{ 8, 16, 32 };
      const auto measured = measureErrors(field, ratio, sizes, all, 8000);
      for (const Method method : methods)
      {
        for (const Zone zone :
          { Zone::Interior, Zone::LevelBoundary, Zone::DataBounds, Zone::Whole })
        {
          if (ratio > 1 || zone != Zone::LevelBoundary)
          {
            std::printf("%-14s %5d  %-23s %-15s %9.2f %9.2f\n", field.name.c_str(), ratio,
              nameOf(method), nameOf(zone), observedOrder(measured, method, zone, Norm::Max),
              observedOrder(measured, method, zone, Norm::Rms));
          }
        }
      }
      rows.insert(rows.end(), measured.begin(), measured.end());
    }
  }
  return rows;
}

bool writeErrors(const std::vector<ErrorRow>& rows, const std::string& file)
{
  std::ofstream out(file);
  out << "field,ratio,method,zone,coarse_width,max,rms\n";
  for (const ErrorRow& row : rows)
  {
    out << row.field << ',' << row.ratio << ',' << nameOf(row.method) << ',' << nameOf(row.zone)
        << ',' << row.coarseWidth << ',' << row.max << ',' << row.rms << '\n';
  }
  return static_cast<bool>(out);
}

// The greatest error of the Gaussian with ratio 2; `guides`: beside which lines those of order 1
// and 2 go.
Chart errorChart(const std::vector<ErrorRow>& rows, const std::string& name,
  const std::string& title, const std::vector<std::pair<Method, Zone>>& lines,
  const std::array<std::size_t, 2>& guides)
{
  Chart chart{ name, title, { "coarse cell width / side of the domain", true, fractions(8, 64) },
    { "greatest error / range of values", true, {} }, {} };
  for (const auto& line : lines)
  {
    Series series;
    series.name = std::string(nameOf(line.first)) + ", " + nameOf(line.second);
    for (const ErrorRow& row : rows)
    {
      if (row.field == "Gaussian" && row.ratio == 2 && row.method == line.first &&
        row.zone == line.second)
      {
        series.points.emplace_back(row.coarseWidth, row.max);
      }
    }
    std::reverse(series.points.begin(), series.points.end());
    chart.series.push_back(series);
  }
  chart.series.push_back(orderGuide(chart.series[guides[0]], 1.0, 0.6));
  chart.series.push_back(orderGuide(chart.series[guides[1]], 2.0, 0.6));
  return chart;
}

Chart lineChart()
{
  Chart chart{ "linear_field_across_levels", "A linear field across a level change",
    { "distance from the face / fine cell width (coarse cells on the left)", false, {} },
    { "value / (slope x fine cell width)", false, {} }, {} };
  const auto add = [&](const std::string& name, const auto& value)
  {
    Series series;
    series.name = name;
    series.style = Series::Style::Curve;
    for (int i = -99; i <= 99; ++i)
    {
      const double x = i * 0.03 + 0.001; // beside the jumps
      series.points.emplace_back(x, value(x));
    }
    chart.series.push_back(series);
  };
  add("exact", [](double x) { return x; });
  for (const int ratio : { 2, 3, 4 })
  {
    add("basis, ratio " + std::to_string(ratio),
      [&](double x) { return basisAcrossLevels(ratio, x); });
  }
  add("nearest, ratio 2",
    [](double x) { return x < 0.0 ? 2.0 * std::floor(x / 2.0) + 1.0 : std::floor(x) + 0.5; });
  return chart;
}

struct PictureCase
{
  std::string name;
  std::string title;
  Field field;
  std::vector<Grid> grids;
};

// Picture noise against resolution, for both transfer functions.
std::vector<Chart> pictureCharts()
{
  const std::vector<PictureCase> cases{
    { "bell", "Gaussian across a level change of ratio 2", gaussian({ 0.4, 0.45, 0.55 }, 0.2),
      { makeBoxGrid(2, 8), makeBoxGrid(2, 16), makeBoxGrid(2, 32), makeBoxGrid(2, 64) } },
    { "front", "Front through level changes of ratio 2 and the bounds", movingFront(0.35, 0.15),
      { makeBoxGrid(2, 8), makeBoxGrid(2, 16), makeBoxGrid(2, 32), makeBoxGrid(2, 64) } },
    { "shell_levels", "Shell and blobs, 3 levels of ratio 2", shellAndBlobs(),
      { makeShellGrid({ 2, 2 }, 8), makeShellGrid({ 2, 2 }, 16), makeShellGrid({ 2, 2 }, 32) } }
  };
  std::vector<Chart> charts;
  std::printf("\n%-12s %-5s %8s", "picture, dB", "tf", "finest");
  for (const Method method : methods)
  {
    std::printf(" %23s", nameOf(method));
  }
  std::printf("\n");
  for (const PictureCase& c : cases)
  {
    for (const bool veils : { false, true })
    {
      const auto rows = measurePictures(
        c.field, c.grids, veils ? veilTransfer() : rampTransfer(), PictureSettings());
      Chart chart{ "picture_" + c.name + (veils ? "_veils" : "_ramp"),
        c.title + (veils ? ": veils" : ": ramp"),
        { "finest cell width / side of the domain", true, fractions(16, 128) },
        { "PSNR against the analytic field's picture / dB", false, {} }, {} };
      for (const Method method : methods)
      {
        Series series;
        series.name = nameOf(method);
        for (auto row = rows.rbegin(); row != rows.rend(); ++row)
        {
          if (row->method == method)
          {
            series.points.emplace_back(row->finestWidth, row->psnr);
          }
        }
        chart.series.push_back(series);
      }
      charts.push_back(chart);
      for (std::size_t i = 0; i < rows.size(); ++i)
      {
        if (i % std::size(methods) == 0)
        {
          std::printf("%-12s %-5s    1/%-4.0f", c.name.c_str(), veils ? "veils" : "ramp",
            1.0 / rows[i].finestWidth);
        }
        std::printf(" %23.1f%s", rows[i].psnr, (i + 1) % std::size(methods) ? "" : "\n");
      }
    }
  }
  return charts;
}

// Where a chart of few steps has its ticks; of many steps, none.
std::vector<std::pair<double, std::string>> stepsOf(const Chart& chart)
{
  std::map<double, std::string> ticks;
  for (const Series& series : chart.series)
  {
    for (const auto& point : series.points)
    {
      char text[32];
      std::snprintf(text, sizeof(text), "%.3g", point.first);
      ticks[point.first] = text;
    }
  }
  return ticks.size() > 10
    ? std::vector<std::pair<double, std::string>>()
    : std::vector<std::pair<double, std::string>>(ticks.begin(), ticks.end());
}

Chart asStepChart(Chart chart, const std::string& y)
{
  chart.x = { "distance of samples / finest cell width near the ray", true, stepsOf(chart) };
  chart.y = { y, true, {} };
  addOrderGuides(chart);
  return chart;
}

Chart stepChart()
{
  Chart chart{ "integration_error", "Integration of a field on two levels: basis, k-d tree", {}, {},
    {} };
  std::printf("\nintegration, order of opacity, of colour\n");
  for (const StepScene& scene : kinkedScenes())
  {
    Series series;
    series.name = scene.name;
    const std::vector<StepError> rows = measureStepErrors(scene);
    for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    {
      series.points.emplace_back(row->stepScale, row->opacity);
    }
    std::printf("%-34s %5.2f %5.2f\n", scene.name.c_str(), observedOrder(rows, &StepError::opacity),
      observedOrder(rows, &StepError::color));
    chart.series.push_back(series);
  }
  return asStepChart(chart, "opacity, root mean square error");
}

std::string fileName(std::string name)
{
  std::replace_if(
    name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c) && c != '-'; }, '_');
  return name;
}
}

int main(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::fprintf(stderr, "usage: AccuracyCharts <folder> [<file.csv>...]\n");
    return 1;
  }
  const std::string folder = std::string(argv[1]) + "/";
  const std::vector<ErrorRow> rows = measureAllErrors();
  bool written = writeErrors(rows, folder + "reconstruction_errors.csv");

  std::vector<Chart> charts;
  charts.push_back(
    errorChart(rows, "reconstruction_error", "Reconstruction of a Gaussian on two levels, ratio 2",
      { { Method::Nearest, Zone::LevelBoundary }, { Method::Nearest, Zone::Interior },
        { Method::Basis, Zone::LevelBoundary }, { Method::Basis, Zone::Interior } },
      { 2, 3 }));
  charts.push_back(errorChart(rows, "reconstruction_error_at_level_boundaries",
    "At level boundaries: Gaussian on two levels, ratio 2",
    { { Method::Nearest, Zone::LevelBoundary }, { Method::Basis, Zone::LevelBoundary },
      { Method::Corrected, Zone::LevelBoundary }, { Method::Completed, Zone::LevelBoundary } },
    { 1, 2 }));
  charts.push_back(lineChart());
  charts.push_back(stepChart());
  for (const Chart& chart : pictureCharts())
  {
    charts.push_back(chart);
  }
  written = writeCsv(charts, folder + "charts.csv") && written;

  for (int i = 2; i < argc; ++i)
  {
    const std::vector<Chart> read = readCsv(argv[i]);
    if (read.empty())
    {
      std::fprintf(stderr, "%s: expected columns chart, series, x, y\n", argv[i]);
      written = false;
    }
    for (Chart chart : read)
    {
      charts.push_back(asStepChart(chart, "root mean square error over drawn pixels"));
    }
  }
  for (const Chart& chart : charts)
  {
    written = drawChart(chart, folder + fileName(chart.name) + ".png") && written;
  }
  if (!written)
  {
    std::fprintf(stderr, "Not everything could be read or written to %s\n", argv[1]);
  }
  return written ? 0 : 1;
}
