// SPDX-License-Identifier: BSD-3-Clause
// The volume rendering integral along one ray, front to back, to a set error:
//
//   color = integral of c(v) k(v) exp(-integral of k before) ds,  k = -ln(1 - a) / unit,
//
// with v(s) the field along the ray and c and a the transfer function's colour and opacity of the
// unit distance. Fed with pieces on which the field has no kink; split further where it passes a
// control point of the transfer function; each part by Gauss-Legendre quadrature, halved until
// whole and halves agree.
#ifndef ExaBricksReferenceRayIntegral_h
#define ExaBricksReferenceRayIntegral_h

#include "Core/TransferFunction.h"
#include "Reference/Polynomial.h"

namespace exabricks
{
namespace reference
{
class RayIntegral
{
public:
  /// `tolerance`: greatest error of a channel for each unit of length that is added.
  RayIntegral(const TransferFunction& transfer, double unitDistance, double tolerance)
    : Transfer(transfer)
    , UnitDistance(unitDistance)
    , Tolerance(tolerance)
  {
  }

  /// A piece of constant value and of a length in the units of the unit distance.
  void addConstant(double value, double length);
  /// A piece on which the value is numerator / denominator, both from its begin (0) to its end (1).
  /// Values lie in [least, most].
  void add(
    const Cubic& numerator, const Cubic& denominator, double least, double most, double length);

  /// Premultiplied, with opacity.
  const glm::dvec4& color() const { return this->Color; }
  /// Estimate of the greatest error in a channel.
  double error() const { return this->Error; }
  /// Nothing behind this point shows.
  bool opaque() const { return this->Transmittance < 1e-14; }

private:
  struct Part; // of a piece, on which colour and opacity are linear in the value
  struct Sum
  {
    glm::dvec3 color{ 0.0 }; // of the part alone
    double depth = 0.0;      // optical
    double error = 0.0;      // of its quadrature, as far as one sum can tell
  };

  void AddPart(const Part& part, int depth);
  Sum Integrate(const Part& part) const;

  const TransferFunction& Transfer;
  const double UnitDistance;
  const double Tolerance;
  glm::dvec4 Color{ 0.0 };
  double Transmittance = 1.0;
  double Error = 0.0;
};
}
}

#endif
