// SPDX-License-Identifier: BSD-3-Clause
// Orders of convergence of the reconstructions when the grid is refined, each with its reason.
#include "Accuracy/PictureAccuracy.h"

#include <cmath>
#include <gtest/gtest.h>
#include <ostream>

using namespace exabricks;
using namespace exabricks::accuracy;

namespace
{
constexpr int Points = 5000; // in each zone

const std::vector<Method> allMethods{ Method::Nearest, Method::Basis, Method::Corrected,
  Method::CompletedBeyond, Method::Completed };
const std::vector<Method> candidates{ Method::Corrected, Method::CompletedBeyond,
  Method::Completed };
const glm::dvec3 slope(0.3, 0.2, 0.35);

// Coarse cells along each axis, so that no grid has more than a million cells.
std::vector<int> sizesFor(int ratio)
{
  return ratio < 4 ? std::vector<int>{ 16, 32, 64 } : std::vector<int>{ 8, 16, 32 };
}

// Steep at a face of the finer level, so that level boundaries count.
Field bell() { return gaussian({ 0.4, 0.45, 0.55 }, 0.3); }

std::vector<ErrorRow> measure(const Field& field, int ratio)
{
  return measureErrors(field, ratio, sizesFor(ratio), allMethods, Points);
}

const ErrorRow& finest(const std::vector<ErrorRow>& rows, Method method, Zone zone)
{
  const ErrorRow* found = nullptr;
  for (const ErrorRow& row : rows)
  {
    if (row.method == method && row.zone == zone &&
      (!found || row.coarseWidth < found->coarseWidth))
    {
      found = &row;
    }
  }
  return *found;
}
}

namespace exabricks
{
namespace accuracy
{
void PrintTo(Method method, std::ostream* out) { *out << nameOf(method); }
}
}

class AcrossRatios : public ::testing::TestWithParam<int>
{
};
INSTANTIATE_TEST_SUITE_P(ReconstructionOrder, AcrossRatios, ::testing::Values(2, 3, 4),
  [](const auto& info) { return "Ratio" + std::to_string(info.param); });

TEST(ReconstructionOrder, ConstantsAreExact)
{
  for (const int ratio : { 1, 2, 3, 4 })
  {
    for (const ErrorRow& row : measureErrors(constant(0.7), ratio, { 8 }, allMethods, Points))
    {
      EXPECT_LT(row.max, 1e-14) << nameOf(row.method) << ", " << nameOf(row.zone);
    }
  }
}

TEST(ReconstructionOrder, LinearFieldsAreExactInsideALevel)
{
  const auto rows = measure(linear(slope), 1);
  for (const Method method :
    { Method::Basis, Method::Corrected, Method::CompletedBeyond, Method::Completed })
  {
    EXPECT_LT(finest(rows, method, Zone::Interior).max, 1e-14) << nameOf(method);
  }
  // Nearest is off by the slope's parts times half a cell in the corners of cells.
  const ErrorRow& nearest = finest(rows, Method::Nearest, Zone::Interior);
  const double corner = (slope.x + slope.y + slope.z) * 0.5 * nearest.coarseWidth;
  EXPECT_LE(nearest.max, corner * (1.0 + 1e-12));
  EXPECT_GT(nearest.max, 0.999 * corner);
}

TEST(ReconstructionOrder, BasisMissesAQuadraticByTheErrorOfLinearInterpolation)
{
  // Between cell centres, a x^2 is missed by a (x - x0) (x1 - x), at most a width^2 / 4, on each
  // axis.
  const glm::dvec3 a(0.3, 0.2, 0.4);
  const auto rows = measure(quadratic(a), 1);
  const ErrorRow& basis = finest(rows, Method::Basis, Zone::Interior);
  const double middle = (a.x + a.y + a.z) * basis.coarseWidth * basis.coarseWidth / 4.0;
  EXPECT_LE(basis.max, middle * (1.0 + 1e-9));
  EXPECT_GT(basis.max, 0.999 * middle);
}

TEST(ReconstructionOrder, InsideALevelNearestIsFirstAndBasisSecond)
{
  for (const Field& field : { quadratic({ 0.3, 0.2, 0.4 }), bell(), movingFront(0.35, 0.15) })
  {
    SCOPED_TRACE(field.name);
    const auto rows = measure(field, 1);
    // nearest: slope times distance from the centre
    EXPECT_NEAR(observedOrder(rows, Method::Nearest, Zone::Interior, Norm::Max), 1.0, 0.2);
    EXPECT_NEAR(observedOrder(rows, Method::Nearest, Zone::Whole, Norm::Rms), 1.0, 0.1);
    // basis: trilinear, curvature times the distance's square
    EXPECT_NEAR(observedOrder(rows, Method::Basis, Zone::Interior, Norm::Max), 2.0, 0.1);
    EXPECT_NEAR(observedOrder(rows, Method::Basis, Zone::Interior, Norm::Rms), 2.0, 0.1);
  }
}

TEST(ReconstructionOrder, AtTheBoundsOfTheDataBasisIsFirst)
{
  // From the outer cells' centres to the bounds the value stays: slope times half a cell. The layer
  // is half a cell thick, which is worth half an order over the whole volume.
  for (const Field& field : { linear(slope), movingFront(0.35, 0.15) })
  {
    SCOPED_TRACE(field.name);
    const auto rows = measure(field, 1);
    // the greatest error is in a corner of the bounds, which the points come near by chance
    EXPECT_NEAR(observedOrder(rows, Method::Basis, Zone::DataBounds, Norm::Max), 1.0, 0.25);
    EXPECT_NEAR(observedOrder(rows, Method::Basis, Zone::DataBounds, Norm::Rms), 1.0, 0.1);
    EXPECT_NEAR(observedOrder(rows, Method::Basis, Zone::Whole, Norm::Rms), 1.5, 0.12);
  }
}

TEST_P(AcrossRatios, AtLevelBoundariesBasisIsFirstInTheMaximumNorm)
{
  const auto rows = measure(bell(), GetParam());
  EXPECT_NEAR(observedOrder(rows, Method::Basis, Zone::Interior, Norm::Max), 2.0, 0.35);
  EXPECT_NEAR(observedOrder(rows, Method::Basis, Zone::Interior, Norm::Rms), 2.0, 0.15);
  // the tents' mean of a linear field is not the field there: see basisAcrossLevels
  EXPECT_NEAR(observedOrder(rows, Method::Basis, Zone::LevelBoundary, Norm::Max), 1.0, 0.2);
  EXPECT_NEAR(observedOrder(rows, Method::Basis, Zone::LevelBoundary, Norm::Rms), 1.0, 0.1);
  // in a layer one coarse cell thick
  EXPECT_NEAR(observedOrder(rows, Method::Basis, Zone::Whole, Norm::Rms), 1.5, 0.12);
  EXPECT_NEAR(observedOrder(rows, Method::Nearest, Zone::LevelBoundary, Norm::Max), 1.0, 0.1);
  EXPECT_NEAR(observedOrder(rows, Method::Nearest, Zone::Whole, Norm::Rms), 1.0, 0.1);
}

TEST_P(AcrossRatios, BasisOfALinearFieldHasAClosedForm)
{
  const int ratio = GetParam();
  const Grid grid = makeBoxGrid(ratio, 8);
  const Field field = linear({ 0.4, 0.3, -0.2 }); // the parts along the face are reproduced
  const Sampler sampler(grid, field);
  double greatest = 0.0; // deviation in slope times finest width
  for (int i = -300; i <= 300; ++i)
  {
    const double x = ratio * i / 300.0; // from the lower x face of the finer level, on both sides
    const glm::dvec3 face(2.0 * ratio, 3.77 * ratio, 4.21 * ratio);
    const glm::dvec3 p = face + glm::dvec3(x, 0.0, 0.0);
    const glm::dvec3 expected = face + glm::dvec3(basisAcrossLevels(ratio, x), 0.0, 0.0);
    const double value = *sampler.sample(p, Method::Basis);
    EXPECT_NEAR(value, field.value(expected * grid.cellShare), 1e-14) << x;
    greatest = std::max(
      greatest, std::abs(value - field.value(p * grid.cellShare)) / (0.4 * grid.cellShare));
  }
  EXPECT_NEAR(greatest, greatestDeviationAcrossLevels(ratio), 0.02);
}

TEST_P(AcrossRatios, EdgesAndCornersOfTheFinerLevelAreNoWorseThanItsFaces)
{
  const int ratio = GetParam();
  const auto rows = measureErrors(linear(slope), ratio, { 16 }, { Method::Basis }, 3 * Points);
  const ErrorRow& row = finest(rows, Method::Basis, Zone::LevelBoundary);
  EXPECT_NEAR(row.max / (slope.z * row.coarseWidth / ratio), greatestDeviationAcrossLevels(ratio),
    0.02 * ratio);
}

TEST_P(AcrossRatios, BasisIsContinuousAndNearestJumps)
{
  const Grid grid = makeBoxGrid(GetParam(), 8);
  const Field field = bell();
  const Sampler sampler(grid, field);
  std::vector<double> distances;
  for (double distance = 0.25; distance > 1e-4; distance *= 0.5)
  {
    distances.push_back(distance);
  }
  for (const Method method :
    { Method::Basis, Method::Corrected, Method::CompletedBeyond, Method::Completed })
  {
    // half as far apart, half as different: slopes are bounded, so the limit is 0
    const auto jumps = measureJumps(sampler, grid, method, distances);
    for (std::size_t i = 2; i < jumps.size(); ++i)
    {
      EXPECT_NEAR(jumps[i] / jumps[i - 1], 0.5, 0.02) << nameOf(method);
    }
    EXPECT_LT(jumps.back(), 1e-3) << nameOf(method);
  }
  const auto jumps = measureJumps(sampler, grid, Method::Nearest, distances);
  EXPECT_EQ(jumps.back(), jumps.front());
  EXPECT_GT(jumps.back(), 0.1);
}

TEST(ReconstructionOrder, AFrontKeepsItsOrdersWhereverItStands)
{
  // The interior's constant grows with the curvature, the boundary's with the slope; the front
  // brings either to any place.
  for (const double time : { 0.3, 0.5, 0.7 })
  {
    SCOPED_TRACE(time);
    const auto rows = measure(movingFront(time, 0.15), 2);
    EXPECT_NEAR(observedOrder(rows, Method::Nearest, Zone::Whole, Norm::Rms), 1.0, 0.1);
    EXPECT_NEAR(observedOrder(rows, Method::Basis, Zone::Interior, Norm::Rms), 2.0, 0.1);
    EXPECT_NEAR(observedOrder(rows, Method::Basis, Zone::LevelBoundary, Norm::Rms), 1.0, 0.15);
    EXPECT_NEAR(observedOrder(rows, Method::Basis, Zone::Whole, Norm::Rms), 1.5, 0.15);
  }
}

TEST_P(AcrossRatios, CandidatesReproduceLinearFieldsAcrossLevels)
{
  const auto rows = measure(linear(slope), GetParam());
  for (const Method method : candidates)
  {
    EXPECT_LT(finest(rows, method, Zone::LevelBoundary).max, 1e-13) << nameOf(method);
  }
}

TEST_P(AcrossRatios, CandidatesAreSecondAtLevelBoundaries)
{
  const auto rows = measure(bell(), GetParam());
  for (const Method method : candidates)
  {
    SCOPED_TRACE(nameOf(method));
    EXPECT_NEAR(observedOrder(rows, method, Zone::LevelBoundary, Norm::Max), 2.0, 0.15);
    EXPECT_NEAR(observedOrder(rows, method, Zone::LevelBoundary, Norm::Rms), 2.0, 0.15);
    // and much nearer than the basis at the boundary
    EXPECT_LT(finest(rows, method, Zone::LevelBoundary).rms,
      0.15 * finest(rows, Method::Basis, Zone::LevelBoundary).rms);
  }
}

TEST(ReconstructionOrder, CandidatesAreSecondAtTheBoundsIfTheOuterCellsSlopesGoOn)
{
  const auto rows = measure(movingFront(0.35, 0.15), 2);
  for (const Method method : { Method::Corrected, Method::CompletedBeyond })
  {
    EXPECT_NEAR(observedOrder(rows, method, Zone::DataBounds, Norm::Rms), 2.0, 0.15);
    EXPECT_NEAR(observedOrder(rows, method, Zone::Whole, Norm::Rms), 2.0, 0.15);
  }
  // else they are what the basis is there
  const ErrorRow& inside = finest(rows, Method::Completed, Zone::DataBounds);
  EXPECT_NEAR(inside.rms, finest(rows, Method::Basis, Zone::DataBounds).rms, 1e-12);
}

TEST(ReconstructionOrder, InsideALevelCandidatesAreTheBasis)
{
  const Grid grid = makeBoxGrid(2, 8);
  const Sampler sampler(grid, bell());
  for (const glm::dvec3& p :
    { glm::dvec3(7.3, 8.1, 6.9), glm::dvec3(1.7, 8.2, 2.4), glm::dvec3(13.9, 14.2, 2.6) })
  {
    for (const Method method : candidates)
    {
      EXPECT_NEAR(*sampler.sample(p, method), *sampler.sample(p, Method::Basis), 1e-14);
    }
  }
}

TEST(PictureAccuracy, ThePictureOfTheAnalyticFieldIsThatOfAConstantInClosedForm)
{
  PictureSettings settings;
  settings.pixels = 3;
  const TransferFunction transfer({ { 0.0, glm::dvec4(1.0, 0.5, 0.0, 0.04) } });
  const reference::Image image = renderField(constant(0.5).value, transfer, settings);
  // The middle ray leaves through the two faces across x.
  const double length = glm::length(glm::dvec3(1.0, 0.7, -0.4));
  EXPECT_NEAR(image.at(1, 1).a, 1.0 - std::pow(0.96, length / settings.unitDistance), 1e-3);
  EXPECT_NEAR(image.at(1, 1).g, 0.5 * image.at(1, 1).a, 1e-12);
}

TEST(PictureAccuracy, CandidatesTakeTheLevelBoundariesOutOfThePicture)
{
  PictureSettings settings;
  settings.pixels = 24;
  settings.step = 1.0 / 256;
  // Measured: 8 dB and more on the first grid.
  const std::vector<Grid> grids{ makeShellGrid({ 2 }, 32), makeShellGrid({ 2 }, 64) };
  for (const TransferFunction& transfer : { rampTransfer(), veilTransfer() })
  {
    const auto rows = measurePictures(shellAndBlobs(), grids, transfer, settings);
    ASSERT_EQ(rows.size(), 2 * allMethods.size()); // by grid, then by method
    for (std::size_t method = 0; method < allMethods.size(); ++method)
    {
      SCOPED_TRACE(nameOf(allMethods[method]));
      if (method >= 2)
      {
        EXPECT_GT(rows[method].psnr, rows[1].psnr + 5.0);
      }
      EXPECT_GT(rows[allMethods.size() + method].psnr, rows[method].psnr + 2.0); // finer grid
    }
  }
}

TEST_P(AcrossRatios, NormalsOfCompletedTurnAboutAsMuchAcrossLevelsAsInside)
{
  const Grid grid = makeBoxGrid(GetParam(), 16);
  const Field field = bell();
  const Sampler sampler(grid, field);
  const auto measureOf = [&](Method method, bool inside)
  {
    const NormalErrors found = measureNormals(sampler, grid, field, method, inside);
    std::cout << "ratio " << GetParam() << ", " << nameOf(method)
              << (inside ? ", inside: " : ", across: ") << found.mean << " degrees off, turn by "
              << found.meanTurn << " in the mean, " << found.greatestTurn << " at most\n";
    return found;
  };
  const NormalErrors inside = measureOf(Method::Completed, true);
  const NormalErrors completed = measureOf(Method::Completed, false);
  const NormalErrors basis = measureOf(Method::Basis, false);
  EXPECT_NEAR(measureOf(Method::Basis, true).meanTurn, inside.meanTurn, 1e-6);
  EXPECT_LT(completed.meanTurn, 1.5 * inside.meanTurn);
  EXPECT_LT(completed.mean, 1.5 * inside.mean);
  // The basis is flat along the last coarse half cells: its normals lie along the boundary there.
  EXPECT_GT(basis.meanTurn, 60.0);
  EXPECT_LT(completed.meanTurn, 0.2 * basis.meanTurn);
}
