// SPDX-License-Identifier: BSD-3-Clause
// Several components of one volume, shaded, with gradient opacity and projected, beside brute force
// in double precision. Of mixings that differ but in what MixesComponents holds one stands for all:
// drivers take some seconds to compile each pipeline.
#include "Components.h"

using namespace exabricks;
using namespace exabricks::components;

namespace
{
const Case TwoIndependent{ "two independent", Mixing::Independent, 2 };
const Case ColorAndOpacity{ "colour and opacity", Mixing::ColorAndOpacity, 2 };
const Case ValueAndGradient{ "value and gradient", Mixing::Planar, 1 };
const Case TwoValues{ "two values", Mixing::Planar, 2 };

class ShowsComponentsShaded : public WithComponents
{
};
TEST_P(ShowsComponentsShaded, EachByItsGradient)
{
  for (const reference::Scene& scene : { reference::twoLevels(), reference::anisotropic() })
  {
    this->Expect(
      scene, Reconstruction::Basis, { "shaded", Blending::Composite, true, false, 55.0 });
  }
}
INSTANTIATE_TEST_SUITE_P(
  All, ShowsComponentsShaded, testing::Values(TwoIndependent, ColorAndOpacity, ValueAndGradient));

class ShowsComponentsLessOpaque : public WithComponents
{
};
TEST_P(ShowsComponentsLessOpaque, ByTheirGradients)
{
  for (const reference::Scene& scene : { reference::twoLevels(), reference::anisotropic() })
  {
    this->Expect(scene, Reconstruction::Basis,
      { "opacity by gradients", Blending::Composite, false, true, 55.0 });
  }
}
INSTANTIATE_TEST_SUITE_P(
  All, ShowsComponentsLessOpaque, testing::Values(TwoIndependent, ColorAndOpacity));

class ShowsComponentsProjected : public WithComponents
{
};
TEST_P(ShowsComponentsProjected, EachByItself)
{
  const bool independent = this->GetParam().mixing == Mixing::Independent;
  for (const reference::Scene& scene : { reference::twoLevels(), reference::holes() })
  {
    for (const Request& request :
      { Request{ "maximum", Blending::Maximum }, Request{ "average", Blending::Average },
        Request{ "minimum", Blending::Minimum }, Request{ "additive", Blending::Additive } })
    {
      const bool isExtremum =
        request.blending == Blending::Maximum || request.blending == Blending::Minimum;
      if (!independent &&
        (request.blending == Blending::Minimum || request.blending == Blending::Additive))
      {
        continue;
      }
      // Of dependent components the colour is that of the place with the greatest opacity, which
      // may be another one for the least difference of two maxima; and brute force misses cells of
      // which a ray passes but a corner.
      Request bounded = request;
      bounded.leastDecibel = isExtremum ? 36.0 : 55.0;
      bounded.leastCoverage = 0.0001;
      this->Expect(scene, Reconstruction::Basis, bounded);
      if (independent && request.blending == Blending::Maximum)
      {
        this->Expect(scene, Reconstruction::Nearest, bounded);
      }
    }
  }
}
// The gradient as the second variable. Greatest values lie at edges of cells, where it jumps, so
// that there is no truth to compare them with.
class ShowsGradientsProjected : public WithComponents
{
};
TEST_P(ShowsGradientsProjected, WithTheirValues)
{
  for (const reference::Scene& scene : { reference::twoLevels(), reference::anisotropic() })
  {
    this->Expect(scene, Reconstruction::Basis,
      { "average", Blending::Average, false, false, 55.0, 0.05, true });
  }
}
INSTANTIATE_TEST_SUITE_P(All, ShowsGradientsProjected, testing::Values(ValueAndGradient));

INSTANTIATE_TEST_SUITE_P(
  All, ShowsComponentsProjected, testing::Values(TwoIndependent, ColorAndOpacity, TwoValues));
}
