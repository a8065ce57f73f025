// SPDX-License-Identifier: BSD-3-Clause
// What pictures and results are judged and kept by.
#include "PictureErrors.h"
#include "Results.h"

#include "Reference/Similarity.h"

#include <cmath>
#include <filesystem>
#include <fstream>
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

std::string read(const std::string& file)
{
  std::ifstream in(file);
  return { std::istreambuf_iterator<char>(in), {} };
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

TEST(Results, AreWrittenWithTheColumnsThatReportsRead)
{
  const std::string folder = ::testing::TempDir() + "exabricks_results";
  std::filesystem::create_directories(folder);
  Result row;
  row.scene = "scene, one";
  row.method = "basis, k-d tree";
  row.parameter = StepScale;
  row.value = 1.0;
  row.rounds = 3;
  row.note = "a \"note\", with a comma";
  row.wall = 0.25;
  row.hostBytes = 3.0 * 1048576.0;
  Results results;
  results.rows.push_back(row);
  results.machine = { { "VTK", "9" } };
  writeResults(results, folder);
  EXPECT_EQ(read(folder + "/results.csv"),
    "scene,method,role,parameter,rounds,note,value,wall_ms,cpu_ms,march_ms,setup_s,resampling_s,"
    "host_mib,device_mib,rmse,psnr,psnr_drawn,ssim,psnr_rgba,psnr_rgba_drawn,rmse_own,samples\n"
    "\"scene, one\",\"basis, k-d tree\",ours,step scale,3,\"a \"\"note\"\", with a comma\",1,250,"
    ",,,,3,,,,,,,,,\n");
  EXPECT_EQ(read(folder + "/machine.csv"), "name,value\nVTK,9\n");
  EXPECT_FALSE(std::filesystem::exists(folder + "/growth.csv")) << "nothing to write";
}

TEST(Results, OfScenesHaveMemoryInMebibytesAndFramesInMilliseconds)
{
  const std::string folder = ::testing::TempDir() + "exabricks_scenes";
  std::filesystem::create_directories(folder);
  Results results;
  results.growth.emplace_back();
  SceneMeasurements& scene = results.growth.back();
  scene.scene = "Cloud";
  scene.group = "stand-in";
  scene.leafCells = 12345678.0;
  scene.structureTime = 0.5;
  scene.hostBytes = 1048576.0;
  scene.frameKdTree = 0.125;
  writeResults(results, folder);
  EXPECT_EQ(read(folder + "/growth.csv"),
    "scene,group,levels,blocks,leaf_cells,bricks,regions,active_regions,structure_s,gather_s,"
    "ranges_s,scalars_mib,bricks_mib,regions_device_mib,regions_host_mib,kd_tree_mib,"
    "acceleration_mib,surface_mib,total_kd_tree_mib,total_ray_query_mib,host_mib,frame_kd_tree_ms,"
    "frame_ray_query_ms,frame_by_tolerance_ms,frame_of_all_levels_ms,levels_left_out,truth_s,"
    "truth_error,mean_opacity\n"
    "Cloud,stand-in,0,0,12345678,0,0,0,0.5,,,,,,,,,,,,1,125,,,,,,,\n");
}
