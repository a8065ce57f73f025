// SPDX-License-Identifier: BSD-3-Clause
// How near reconstructions are to analytic fields when the grid is refined, apart from everything
// that pictures add: in level interiors, at level boundaries and at the bounds of the data.
#ifndef ExaBricksAccuracyReconstructionOrder_h
#define ExaBricksAccuracyReconstructionOrder_h

#include "Accuracy/AnalyticFields.h"
#include "Accuracy/Candidates.h"
#include "Reference/Oracle.h"

namespace exabricks
{
namespace accuracy
{
enum class Method
{
  Nearest,
  Basis,
  Corrected, // those of Candidates
  CompletedBeyond,
  Completed
};
const char* nameOf(Method method);

/// A field on a grid, reconstructed.
class Sampler
{
public:
  Sampler(const Grid& grid, const Field& field);

  /// At a logical position; none outside the data. Nearest and Basis are the oracle's.
  std::optional<double> sample(const glm::dvec3& logical, Method method) const;

private:
  reference::Oracle Judge;
  Candidates Others;
};

/// Of makeBoxGrid, disjoint.
enum class Zone
{
  Interior,      // all else
  LevelBoundary, // nearer than half a coarse cell to the finer level's faces, on both sides
  DataBounds,    // nearer than half a coarse cell to the bounds
  Whole
};
const char* nameOf(Zone zone);

struct ErrorRow
{
  std::string field;
  int ratio; // 1: one level
  Method method;
  Zone zone;
  double coarseWidth; // in shares of the cube
  double max;
  double rms;
};
/// Errors at `points` points of each zone, spread evenly, for each number of coarse cells; the
/// greatest also at points near them where errors peak. Whole is put together from the zones with
/// their volumes.
std::vector<ErrorRow> measureErrors(const Field& field, int ratio,
  const std::vector<int>& coarseCells, const std::vector<Method>& methods, int points);

enum class Norm
{
  Max,
  Rms
};
/// Slope of the straight line that fits log(error) over log(width) best.
double observedOrder(const std::vector<ErrorRow>& rows, Method method, Zone zone, Norm norm);

/// The greatest |f(p + d n) - f(p - d n)| at points p of the finer level's faces, n normal to them,
/// for each d in `distances` (in finest cells).
std::vector<double> measureJumps(
  const Sampler& sampler, const Grid& grid, Method method, const std::vector<double>& distances);

/// Directions of the gradient, which surfaces are shaded by, along lines across the finer level's
/// faces from a coarse cell before to one behind them; or, `inside`, as long ones in the finer
/// level. Degrees.
struct NormalErrors
{
  double mean;         // from the field's own direction
  double greatestTurn; // within a hundredth of a finest cell, where kinks are
  double meanTurn;     // the same of each line, in the mean
};
NormalErrors measureNormals(
  const Sampler& sampler, const Grid& grid, const Field& field, Method method, bool inside);

/// What the basis makes of the field x across a level change in the plane x = 0, coarse cells on
/// the negative side: the value at x, all in finest cells.
///
/// Tents along the plane add up to 1 on either side, so only the direction across counts. Between
/// the last coarse centre -r/2 and the first fine tent at -1/2 only one cell reaches: its value
/// stays. Up to the first fine centre 1/2 it is mixed with one fine cell; up to r/2, where the
/// coarse tent ends, with two, which by themselves are exact:
///
///   x < -r/2          x
///   -r/2 .. -1/2     -r/2
///   -1/2 .. 1/2       (x - (r - 1) / 4) / (1 + x (r - 1) / r)
///   1/2 .. r/2        x - (r^2 / 4 - x^2) / (3 r / 2 - x)
///   r/2 < x           x
///
/// It is too low throughout, most so at -1/2, by (r - 1) / 2: half the difference of the widths of
/// the cells, so in the maximum norm it is of first order. The layer is one coarse cell thick, so
/// that the root mean square over a volume is of order 3/2.
double basisAcrossLevels(double ratio, double x);
/// (r - 1) / 2
double greatestDeviationAcrossLevels(double ratio);
}
}

#endif
