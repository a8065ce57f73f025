// SPDX-License-Identifier: BSD-3-Clause
// Charts are drawn and their data come back from text.
#include "Accuracy/Charts.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace exabricks::accuracy;

namespace
{
Chart convergence()
{
  Chart chart{ "error, over \"step\"", "Error", { "step", true, {} }, { "error", true, {} }, {} };
  chart.series = { { "midpoint", { { 0.25, 0.001 }, { 0.5, 0.004 }, { 1.0, 0.016 } } },
    { "left end", { { 0.25, 0.02 }, { 0.5, 0.04 }, { 1.0, 0.08 } } } };
  return chart;
}

// Pixels of about that colour.
int countPixels(vtkImageData* image, int red, int green, int blue)
{
  const int* size = image->GetDimensions();
  int count = 0;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const auto* pixel = static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0));
      count +=
        std::abs(pixel[0] - red) + std::abs(pixel[1] - green) + std::abs(pixel[2] - blue) < 12;
    }
  }
  return count;
}
}

TEST(Charts, DrawEverySeriesOnWhite)
{
  Chart chart = convergence();
  addOrderGuides(chart);
  const std::string file = ::testing::TempDir() + "exabricks_chart.png";
  ASSERT_TRUE(drawChart(chart, file));
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  ASSERT_GT(image->GetDimensions()[0], 1000);
  EXPECT_GT(countPixels(image, 213, 94, 0), 1000);   // the second series
  EXPECT_GT(countPixels(image, 120, 120, 120), 200); // guides
  EXPECT_GT(countPixels(image, 255, 255, 255), image->GetNumberOfPoints() * 8 / 10);
}

TEST(Charts, GuidesGoBesideWhatWasMeasured)
{
  Chart chart = convergence();
  addOrderGuides(chart);
  ASSERT_EQ(chart.series.size(), 4u);
  const Series& first = chart.series[2];
  EXPECT_EQ(first.name, "order 1");
  EXPECT_NEAR(first.points.back().second, 1.5 * 0.08, 1e-12);
  EXPECT_NEAR(first.points.front().second, 1.5 * 0.02, 1e-12);
  const Series& second = chart.series[3];
  EXPECT_EQ(second.name, "order 2");
  EXPECT_NEAR(second.points.front().second, 0.6 * 0.001, 1e-12);
}

TEST(Charts, ComeBackFromText)
{
  const std::string file = ::testing::TempDir() + "exabricks_chart.csv";
  ASSERT_TRUE(writeCsv({ convergence() }, file));
  const std::vector<Chart> charts = readCsv(file);
  ASSERT_EQ(charts.size(), 1u);
  EXPECT_EQ(charts[0].name, convergence().name);
  ASSERT_EQ(charts[0].series.size(), 2u);
  EXPECT_EQ(charts[0].series[1].name, "left end");
  EXPECT_EQ(charts[0].series[1].points, convergence().series[1].points);
  EXPECT_TRUE(readCsv(::testing::TempDir() + "no such file").empty());
}
