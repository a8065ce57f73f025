// SPDX-License-Identifier: BSD-3-Clause
// The device's form of a transfer function: exact colours at any value, and integrals over values
// (see Layout.h), so that an interval of a ray sees all that lies between the values at its ends.
#ifndef ExaBricksCoreTransferTable_h
#define ExaBricksCoreTransferTable_h

#include "Core/TransferFunction.h"

namespace exabricks
{
struct TransferTable
{
  /// What is kept of a colour and its opacity.
  enum class Amount
  {
    Extinction, // -ln(1 - opacity), and that times the colour: what adds up along a ray
    Opacity     // and that times the colour
  };

  explicit TransferTable(const TransferFunction& transfer, Amount amount = Amount::Extinction);

  std::vector<layout::TransferBin> bins;
  std::vector<layout::TransferKnot> knots;
  float integralUnit = 1.0f; // what the integrals in bins and knots are counted in
};
}

#endif
