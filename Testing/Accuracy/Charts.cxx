// SPDX-License-Identifier: BSD-3-Clause
#include "Accuracy/Charts.h"

#include "vtkAxis.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkContextScene.h"
#include "vtkContextView.h"
#include "vtkDoubleArray.h"
#include "vtkImageChangeInformation.h"
#include "vtkImageConstantPad.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPen.h"
#include "vtkPlotPoints.h"
#include "vtkRenderWindow.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>

namespace exabricks
{
namespace accuracy
{
namespace
{
constexpr int Width = 1500;
constexpr int Height = 900;
constexpr int Frame = 20;
constexpr int FontSize = 24;

struct Look
{
  std::array<unsigned char, 3> color;
  int marker;
};
const Look looks[] = { { { 0, 0, 0 }, vtkPlotPoints::CIRCLE },
  { { 213, 94, 0 }, vtkPlotPoints::SQUARE }, { { 0, 114, 178 }, vtkPlotPoints::DIAMOND },
  { { 230, 159, 0 }, vtkPlotPoints::CROSS }, { { 0, 158, 115 }, vtkPlotPoints::PLUS },
  { { 86, 180, 233 }, vtkPlotPoints::CIRCLE }, { { 204, 121, 167 }, vtkPlotPoints::SQUARE },
  { { 120, 60, 20 }, vtkPlotPoints::DIAMOND }, { { 110, 110, 110 }, vtkPlotPoints::CROSS } };

const int alone[] = { vtkPlotPoints::CIRCLE, vtkPlotPoints::SQUARE, vtkPlotPoints::DIAMOND };

const int dashes[] = { vtkPen::DASH_LINE, vtkPen::DASH_DOT_LINE, vtkPen::DASH_DOT_DOT_LINE,
  vtkPen::SOLID_LINE };

struct Extent
{
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();

  void add(double value)
  {
    this->min = std::min(this->min, value);
    this->max = std::max(this->max, value);
  }
};

// Logarithms are taken here and the axes told their ticks: VTK's own logarithmic axes changed from
// version to version.
double onAxis(const Axis& axis, double value)
{
  return axis.logarithmic ? std::log10(value) : value;
}

bool canBeDrawn(const Chart& chart, const std::pair<double, double>& point)
{
  const double x = onAxis(chart.x, point.first);
  const double y = onAxis(chart.y, point.second);
  return std::isfinite(x) && std::isfinite(y);
}

std::string label(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g", value);
  std::string result = text;
  // 1e5 and 1e-5, where C writes 1e+05 and 1e-05
  const std::size_t e = result.find('e');
  if (e != std::string::npos)
  {
    const bool negative = result[e + 1] == '-';
    const std::size_t digits = result.find_first_not_of("+-0", e + 1);
    result = result.substr(0, e + 1) + (negative ? "-" : "") + result.substr(digits);
  }
  return result;
}

using Ticks = std::vector<std::pair<double, std::string>>;

// 1, 2, 5 in each decade; of long axes 1 alone, of short ones all digits.
Ticks logarithmicTicks(const Extent& extent)
{
  const double decades = extent.max - extent.min;
  const std::vector<int> digits = decades > 2.0 ? std::vector<int>{ 1 }
    : decades > 0.9                             ? std::vector<int>{ 1, 2, 5 }
                                                : std::vector<int>{ 1, 2, 3, 4, 5, 6, 7, 8, 9 };
  Ticks ticks;
  for (int decade = static_cast<int>(std::floor(extent.min)); decade <= extent.max; ++decade)
  {
    for (const int digit : digits)
    {
      const double value = digit * std::pow(10.0, decade);
      if (std::log10(value) >= extent.min - 1e-9 && std::log10(value) <= extent.max + 1e-9)
      {
        ticks.emplace_back(value, label(value));
      }
    }
  }
  return ticks;
}

Ticks linearTicks(const Extent& extent)
{
  const double rough = (extent.max - extent.min) / 8.0;
  const double decade = std::pow(10.0, std::floor(std::log10(rough)));
  const double step = decade * (rough < 2.0 * decade ? 2.0 : rough < 5.0 * decade ? 5.0 : 10.0);
  Ticks ticks;
  for (double n = std::ceil(extent.min / step); n * step <= extent.max + 1e-9 * step; n += 1.0)
  {
    ticks.emplace_back(n * step, label(n * step));
  }
  return ticks;
}

void setAxis(vtkAxis* to, const Axis& axis, Extent extent)
{
  // keeps an upright title off the labels
  const std::string pad = to->GetPosition() == vtkAxis::LEFT ? "  " : "";
  if (!(extent.max > extent.min))
  {
    extent = { extent.min - 0.5, extent.min + 0.5 };
  }
  const double margin = 0.05 * (extent.max - extent.min);
  extent = { extent.min - margin, extent.max + margin };
  const Ticks ticks = !axis.ticks.empty() ? axis.ticks
    : axis.logarithmic                    ? logarithmicTicks(extent)
                                          : linearTicks(extent);
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  for (const auto& tick : ticks)
  {
    positions->InsertNextValue(onAxis(axis, tick.first));
    labels->InsertNextValue(pad + tick.second);
  }
  to->SetBehavior(vtkAxis::FIXED);
  to->SetRange(extent.min, extent.max);
  to->SetCustomTickPositions(positions, labels);
  to->SetTitle(axis.title);
  to->GetTitleProperties()->SetFontSize(FontSize);
  to->GetTitleProperties()->BoldOff();
  to->GetLabelProperties()->SetFontSize(FontSize - 2);
  to->GetGridPen()->SetColor(220, 220, 220, 255);
}

vtkNew<vtkTable> makeTable(const Chart& chart, const Series& series)
{
  vtkNew<vtkTable> table;
  vtkNew<vtkDoubleArray> x;
  vtkNew<vtkDoubleArray> y;
  x->SetName("x");
  // Broad lines stick out of their place in the legend.
  const bool isBroad = series.style == Series::Style::Front;
  y->SetName(((isBroad ? "  " : "") + series.name).c_str());
  for (const auto& point : series.points)
  {
    if (canBeDrawn(chart, point))
    {
      x->InsertNextValue(onAxis(chart.x, point.first));
      y->InsertNextValue(onAxis(chart.y, point.second));
    }
  }
  table->AddColumn(x);
  table->AddColumn(y);
  return table;
}
}

Series orderGuide(const Series& beside, double order, double factor)
{
  Series guide;
  guide.name = "order " + label(order);
  guide.style = Series::Style::Guide;
  const auto& last = beside.points.back();
  for (const double x : { beside.points.front().first, last.first })
  {
    guide.points.emplace_back(x, factor * last.second * std::pow(x / last.first, order));
  }
  return guide;
}

void addOrderGuides(Chart& chart)
{
  const auto below = [](const Series& a, const Series& b)
  { return a.points.back().second < b.points.back().second; };
  const auto ends = std::minmax_element(chart.series.begin(), chart.series.end(), below);
  const Series lowest = *ends.first;
  const Series highest = *ends.second;
  chart.series.push_back(orderGuide(highest, 1.0, 1.5));
  chart.series.push_back(orderGuide(lowest, 2.0, 0.6));
}

Series paretoFront(const std::vector<Series>& series, bool largerIsBetter)
{
  Series front;
  front.name = "Pareto front";
  front.style = Series::Style::Front;
  std::vector<std::pair<double, double>> points;
  for (const Series& one : series)
  {
    points.insert(points.end(), one.points.begin(), one.points.end());
  }
  const auto better = [=](double a, double b) { return largerIsBetter ? a > b : a < b; };
  std::sort(points.begin(), points.end(),
    [&](const auto& a, const auto& b)
    { return a.first != b.first ? a.first < b.first : better(a.second, b.second); });
  for (const auto& point : points)
  {
    if (front.points.empty() || better(point.second, front.points.back().second))
    {
      front.points.push_back(point);
    }
  }
  return front;
}

bool drawChart(const Chart& chart, const std::string& file)
{
  vtkNew<vtkContextView> view;
  view->GetRenderWindow()->SetOffScreenRendering(1);
  view->GetRenderWindow()->SetMultiSamples(8);
  view->GetRenderWindow()->SetSize(Width, Height);
  vtkNew<vtkChartXY> xy;
  view->GetScene()->AddItem(xy);

  Extent x;
  Extent y;
  std::size_t next = 0;
  std::size_t guides = 0;
  for (const Series& series : chart.series)
  {
    vtkNew<vtkTable> table = makeTable(chart, series);
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      x.add(table->GetValue(row, 0).ToDouble());
      y.add(table->GetValue(row, 1).ToDouble());
    }
    if (table->GetNumberOfRows() == 0)
    {
      continue;
    }
    // VTK refuses to draw a line through one point.
    const int kind = table->GetNumberOfRows() > 1 ? vtkChart::LINE : vtkChart::POINTS;
    auto* line = vtkPlotPoints::SafeDownCast(xy->AddPlot(kind));
    line->SetInputData(table, 0, 1);
    if (series.style == Series::Style::Guide)
    {
      line->SetColor(120, 120, 120, 255);
      line->SetWidth(2.0f);
      line->GetPen()->SetLineType(dashes[guides++ % std::size(dashes)]);
      continue;
    }
    if (series.style == Series::Style::Front)
    {
      line->SetColor(255, 224, 130, 255);
      line->SetWidth(16.0f);
      line->SetMarkerStyle(vtkPlotPoints::CIRCLE);
      line->SetMarkerSize(26.0f);
      continue;
    }
    const Look& look = looks[next % std::size(looks)];
    line->SetColor(look.color[0], look.color[1], look.color[2], 255);
    line->SetWidth(3.0f);
    if (series.style == Series::Style::Measured)
    {
      // Alone, a cross is hard to see.
      line->SetMarkerStyle(kind == vtkChart::LINE ? look.marker : alone[next % std::size(alone)]);
      line->SetMarkerSize(14.0f);
      // Colours begin anew: dashed now.
      line->GetPen()->SetLineType(next < std::size(looks) ? vtkPen::SOLID_LINE : vtkPen::DASH_LINE);
    }
    else if (next > 0)
    {
      line->GetPen()->SetLineType(dashes[(next - 1) % std::size(dashes)]);
    }
    ++next;
  }

  setAxis(xy->GetAxis(vtkAxis::BOTTOM), chart.x, x);
  setAxis(xy->GetAxis(vtkAxis::LEFT), chart.y, y);
  xy->SetTitle(chart.title);
  xy->GetTitleProperties()->SetFontSize(FontSize + 4);
  xy->SetShowLegend(true);
  xy->GetLegend()->SetInline(false); // beside the plot
  xy->GetLegend()->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  xy->GetLegend()->SetVerticalAlignment(vtkChartLegend::TOP);
  xy->GetLegend()->SetLabelSize(FontSize - 2);
  xy->GetLegend()->GetPen()->SetOpacity(0);
  view->GetRenderWindow()->Render(); // widths of labels are known from now on
  view->GetRenderWindow()->Render();

  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(view->GetRenderWindow());
  picture->SetInputBufferTypeToRGB();
  picture->ReadFrontBufferOff();
  vtkNew<vtkImageConstantPad> framed;
  framed->SetInputConnection(picture->GetOutputPort());
  framed->SetOutputWholeExtent(-Frame, Width + Frame - 1, -Frame, Height + Frame - 1, 0, 0);
  framed->SetConstant(255);
  vtkNew<vtkImageChangeInformation> placed; // what is written begins at 0
  placed->SetInputConnection(framed->GetOutputPort());
  placed->SetOutputExtentStart(0, 0, 0);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(placed->GetOutputPort());
  writer->SetFileName(file.c_str());
  writer->Write();
  return writer->GetErrorCode() == 0;
}
}
}
