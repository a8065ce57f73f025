// SPDX-License-Identifier: BSD-3-Clause
// What pictures and results are judged and kept by.
#include "PictureErrors.h"
#include "Report.h"
#include "Results.h"
#include "TargetTables.h"

#include "Accuracy/Charts.h"
#include "Reference/Similarity.h"

#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>

using namespace exabricks;
using namespace exabricks::benchmarks;
using reference::Image;

namespace
{
Image makeImage(int size, const std::function<double(int, int)>& gray)
{
  Image image{ size, size, {} };
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      image.pixels.emplace_back(glm::dvec3(gray(x, y)), 1.0);
    }
  }
  return image;
}

double chequered(int x, int y) { return 0.5 + ((x + y) % 2 == 0 ? 0.3 : -0.3); }

Result makeResult(const char* method, Role role, double value, double wall, double psnr)
{
  Result row;
  row.scene = "scene, one";
  row.method = method;
  row.role = role;
  row.parameter = StepScale;
  row.value = value;
  row.rounds = 3;
  row.wall = wall;
  row.psnr = psnr;
  row.rmse = std::pow(10.0, -psnr / 20.0);
  return row;
}
}

TEST(StructuralSimilarity, IsOneForEqualPictures)
{
  const Image image = makeImage(32, chequered);
  EXPECT_NEAR(reference::structuralSimilarity(image, image), 1.0, 1e-12);
}

TEST(StructuralSimilarity, OfFlatPicturesIsTheirLuminances)
{
  const Image a = makeImage(20, [](int, int) { return 0.4; });
  const Image b = makeImage(20, [](int, int) { return 0.6; });
  const double c1 = 1e-4;
  EXPECT_NEAR(reference::structuralSimilarity(a, b),
    (2.0 * 0.4 * 0.6 + c1) / (0.4 * 0.4 + 0.6 * 0.6 + c1), 1e-9);
}

TEST(StructuralSimilarity, IsNegativeWhereStructureIsInverted)
{
  const Image a = makeImage(32, chequered);
  const Image b = makeImage(32, [](int x, int y) { return 1.0 - chequered(x, y); });
  // Equal means; variances v of 0.09, covariance -v: (-2 v + C2) / (2 v + C2).
  const double v = 0.09;
  EXPECT_NEAR(reference::structuralSimilarity(a, b), (-2.0 * v + 9e-4) / (2.0 * v + 9e-4), 1e-3);
}

TEST(StructuralSimilarity, TakesPicturesOfOneSize)
{
  const Image a = makeImage(32, chequered);
  EXPECT_TRUE(std::isnan(reference::structuralSimilarity(a, makeImage(16, chequered))));
  EXPECT_TRUE(
    std::isnan(reference::structuralSimilarity(makeImage(8, chequered), makeImage(8, chequered))));
}

TEST(PictureErrors, OfDrawnPixelsLeaveTheBackgroundOut)
{
  const Image a = makeImage(10, [](int x, int) { return x < 5 ? 0.5 : 0.0; });
  const Image b = makeImage(10, [](int x, int) { return x < 5 ? 0.6 : 0.0; });
  EXPECT_NEAR(rootMeanSquareOfDrawn(a, b), 0.1, 1e-12);
  EXPECT_NEAR(rootMeanSquare(a, b), 0.1 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(toDecibels(0.1), 20.0, 1e-12);
}

TEST(ParetoFront, HoldsWhatNothingBeatsInBoth)
{
  using accuracy::Series;
  const std::vector<Series> series{ { "a", { { 1.0, 9.0 }, { 3.0, 4.0 }, { 5.0, 4.5 } } },
    { "b", { { 2.0, 10.0 }, { 4.0, 2.0 } } } };
  using Points = std::vector<std::pair<double, double>>;
  EXPECT_EQ(accuracy::paretoFront(series, false).points,
    (Points{ { 1.0, 9.0 }, { 3.0, 4.0 }, { 4.0, 2.0 } }));
  EXPECT_EQ(accuracy::paretoFront(series, true).points, (Points{ { 1.0, 9.0 }, { 2.0, 10.0 } }));
}

TEST(Results, ComeBackFromTheirFiles)
{
  const std::string folder = ::testing::TempDir() + "exabricks_results";
  std::filesystem::create_directories(folder);
  Results results;
  results.rows.push_back(makeResult("basis, k-d tree", Role::Ours, 1.0, 0.25, 50.0));
  results.rows.back().note = "a \"note\", with a comma";
  results.scenes.emplace_back();
  results.scenes.back().scene = "scene, one";
  results.scenes.back().leafCells = 12345678.0;
  results.machine = { { "VTK", "9" } };
  writeResults(results, folder);
  const Results back = readResults(folder);
  ASSERT_EQ(back.rows.size(), 1u);
  EXPECT_EQ(back.rows[0].scene, "scene, one");
  EXPECT_EQ(back.rows[0].note, results.rows[0].note);
  EXPECT_NEAR(back.rows[0].wall, 0.25, 1e-12);
  EXPECT_TRUE(std::isnan(back.rows[0].ssim));
  ASSERT_EQ(back.scenes.size(), 1u);
  EXPECT_EQ(back.scenes[0].leafCells, 12345678.0);
  EXPECT_EQ(back.machine, results.machine);
  EXPECT_THROW(readResults(folder + "/none"), std::exception);
}

TEST(Tables, CompareWithPeersAtNoLessAccuracy)
{
  Results results;
  results.rows = { makeResult("basis, k-d tree", Role::Ours, 4.0, 0.1, 40.0),
    makeResult("basis, k-d tree", Role::Ours, 1.0, 0.2, 55.0),
    makeResult("some mapper", Role::Peer, NotMeasured, 1.0, 45.0) };
  const std::string table = makeTables(results).at("peers.md");
  // 1 s against 0.2 s, and 10 dB short
  EXPECT_NE(table.find("| step scale 1 | 200 | 55.0 | 5.0 | 10.0 |"), std::string::npos) << table;
}

TEST(Tables, HoldTheSourcesNumbersBesideOurs)
{
  Results results;
  results.rows = { makeResult("cell location, k-d tree", Role::Baseline, 1.0, 0.4, 50.0),
    makeResult("basis, k-d tree", Role::Ours, 1.0, 0.1, 50.0) };
  for (Result& row : results.rows)
  {
    row.scene = "Wind";
  }
  const std::string table = makeTables(results).at("source_times.md");
  EXPECT_NE(
    table.find("| Wind | 151 | 75.8 | 2.0 | 400 | 100 | 4.0 | 3.0 | kept |"), std::string::npos)
    << table;
}

TEST(Tables, SayWhetherTargetsAreKept)
{
  Results results;
  results.rows = { makeResult("basis, k-d tree", Role::Ours, 2.0, 0.1, 45.0),
    makeResult("basis, k-d tree", Role::Ours, 1.2, 0.2, 52.0),
    makeResult("basis, k-d tree", Role::Ours, 1.0, 0.3, 55.0),
    makeResult(NativeMarch, Role::Baseline, 1.0, 0.15, 55.0),
    makeResult("resampled, vtkFixedPointVolumeRayCastMapper", Role::Peer, 128.0, 0.4, 40.0) };
  for (Result& row : results.rows)
  {
    row.scene = TargetScene;
    row.cpu = row.wall;
  }
  results.rows[2].cpu = 0.45;
  const auto tables = makeTables(results);
  // The fastest that is accurate enough, 0.2 s of 0.4 s.
  const std::string& frame = tables.at("target_frame.md");
  EXPECT_NE(frame.find("| step scale 1.2 | 52.0 | 200 | 400 | 40.0 | 0.50 | 0.8 | kept |"),
    std::string::npos)
    << frame;
  const std::string& native = tables.at("target_native.md");
  EXPECT_NE(native.find("| 450 | 150 | 3.00 | 2 | missed |"), std::string::npos) << native;
}

TEST(Tables, ShowWhatLevelsLeftOutSave)
{
  Results results;
  results.rows = { makeResult(ByTolerance, Role::Ours, 0.01, 0.2, 40.0),
    makeResult(ByToleranceOfAllLevels, Role::Ours, 0.01, 0.5, 41.0),
    makeResult(ByTolerance, Role::Ours, 0.001, 0.6, 60.0), // none are
    makeResult(ByToleranceOfAllLevels, Role::Ours, 0.001, 0.6, 60.0) };
  const double samples[] = { 10.0, 30.0, 50.0, 50.0 };
  for (std::size_t i = 0; i < results.rows.size(); ++i)
  {
    results.rows[i].cpu = results.rows[i].wall;
    results.rows[i].psnrRGBADrawn = results.rows[i].psnr;
    results.rows[i].samples = samples[i];
  }
  const std::string table = makeTables(results).at("levels.md");
  EXPECT_NE(
    table.find("| 0.01 | 500 | 200 | 0.40 | 30.0 | 10.0 | 41.0 | 40.0 |"), std::string::npos)
    << table;
  EXPECT_EQ(table.find("| 0.001 |"), std::string::npos) << table;
}
