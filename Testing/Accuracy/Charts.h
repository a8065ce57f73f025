// SPDX-License-Identifier: BSD-3-Clause
// Line charts of measurements, drawn with VTK to PNG. Series differ in marker, colour (Okabe and
// Ito 2008) and brightness, so that they can be told apart with any eyes and on grey paper.
#ifndef ExaBricksAccuracyCharts_h
#define ExaBricksAccuracyCharts_h

#include <string>
#include <utility>
#include <vector>

namespace exabricks
{
namespace accuracy
{
struct Axis
{
  std::string title; // with the unit
  bool logarithmic = false;
  /// Positions and labels; empty: chosen by the range.
  std::vector<std::pair<double, std::string>> ticks;
};

struct Series
{
  enum class Style
  {
    Measured, // line and markers
    Curve,    // line, solid or dashed
    Front,    // broad and pale, under all others: the best there is
    Guide     // thin, dashed and grey: what theory says
  };
  std::string name;
  std::vector<std::pair<double, double>> points; // (x, y), in the order they are joined
  Style style = Style::Measured;
};

struct Chart
{
  std::string name; // of its files
  std::string title;
  Axis x;
  Axis y;
  std::vector<Series> series;
};

/// A line y = c x^order over the range of a measured series, `factor` times its value at its
/// greatest x: beside it on logarithmic axes.
Series orderGuide(const Series& beside, double order, double factor);
/// Guides of order 1 above and of order 2 below all that was measured.
void addOrderGuides(Chart& chart);

/// The points of all series that no other one beats in both: the smaller x is better, and the
/// smaller y, or the larger.
Series paretoFront(const std::vector<Series>& series, bool largerIsBetter);

/// Draws it; values that are not positive are left out on logarithmic axes. Whether the file was
/// written.
bool drawChart(const Chart& chart, const std::string& file);

/// Charts as text: columns chart, series, x, y. Guides are left out.
bool writeCsv(const std::vector<Chart>& charts, const std::string& file);
/// The charts of such a file, by their names, as measured series; other columns are passed over.
/// None if it cannot be read or lacks a column.
std::vector<Chart> readCsv(const std::string& file);
}
}

#endif
