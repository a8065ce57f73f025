// SPDX-License-Identifier: BSD-3-Clause
// Transfer functions, steps and unit distances.
#include "MakeAMR.h"

namespace exabricks
{
namespace stability
{
namespace
{
Setting shell() { return shellSetting(twoLevels()); }

Setting withNodes(const std::vector<Node>& nodes)
{
  Setting setting = shell();
  setting.transfer = nodes;
  return setting;
}

// On steep parts of the field a step of a quarter of a cell spans ten of these spikes.
Setting spike()
{
  const glm::dvec3 thin(0.3, 0.5, 0.9);
  const glm::dvec3 dense(1.0, 0.8, 0.3);
  return withNodes({ { 0.0, glm::dvec4(thin, 0.01) }, { 0.399, glm::dvec4(thin, 0.01) },
    { 0.4, glm::dvec4(dense, 0.999) }, { 0.401, glm::dvec4(thin, 0.01) },
    { 1.0, glm::dvec4(thin, 0.01) } });
}

Setting comb()
{
  std::vector<Node> nodes;
  for (int i = 0; i < 400; ++i)
  {
    const double share = i / 400.0;
    nodes.push_back({ share, { share, 1.0 - share, 0.5, i % 2 == 0 ? 0.0 : 0.6 } });
  }
  return withNodes(nodes);
}

Setting steps()
{
  const glm::dvec4 none(0.1, 0.2, 0.9, 0.0);
  const glm::dvec4 low(0.1, 0.2, 0.9, 0.2);
  const glm::dvec4 high(0.9, 0.3, 0.1, 0.05);
  return withNodes({ { 0.0, none }, { 0.3, none }, { 0.3, low }, { 0.55, low }, { 0.55, high },
    { 0.7, high }, { 0.7, none }, { 1.0, none } });
}

// The same medium for all unit distances: opacities of `unit`, of a nominal `extinction` per
// length.
Setting withUnit(double unit, double extinction)
{
  Setting setting = shell();
  for (Node& node : setting.transfer)
  {
    node.color.a = -std::expm1(-extinction * node.color.a * unit);
  }
  setting.unitDistance = unit;
  return setting;
}

Setting withStep(double scale)
{
  Setting setting = shell();
  setting.stepScale = scale;
  return setting;
}

Setting smallStep()
{
  Setting setting = shellSetting(reference::refinedAtShell({ 2 }, 4, 2));
  setting.width = setting.height = 24;
  setting.stepScale = 1e-3;
  setting.unitDistance = 0.25;
  return setting;
}

Setting opaqueColors()
{
  std::vector<Node> nodes = layers();
  for (Node& node : nodes)
  {
    node.color.a = 1.0;
  }
  return withNodes(nodes);
}

// Opaque where the value is high, nothing elsewhere: a surface.
Setting opaqueSurface()
{
  return withNodes({ { 0.0, { 0.2, 0.2, 0.9, 0.0 } }, { 0.5, { 0.2, 0.9, 0.2, 0.0 } },
    { 0.5, { 0.2, 0.9, 0.2, 1.0 } }, { 1.0, { 1.0, 0.2, 0.2, 1.0 } } });
}
}

std::vector<Case> transferCases()
{
  return {
    { "SpikeNarrowerThanAStep", "a step jumps over the spike: holes and rings", spike, 45.0, 100.0,
      "the spike's share of every step has to be found, as good as the field is linear in a step" },
    { "Comb400", "tables of 256 or 1024 entries; steps that jump over teeth", comb, 45.0, 100.0,
      "as one spike; nodes are exact, so that nearest is" },
    { "Jumps", "two nodes at one value are blurred to the table's resolution", steps, 45.0, 100.0,
      "the part of a step on each side of the jump has to be found; nearest is exact" },
    { "OpacityZero", "colours of transparent values leak; a picture that is not empty",
      [] { return withNodes(constantNodes(0.0)); }, 300.0, 300.0, "nothing: exactly 0", true },
    { "OpacityOne", "1 - (1 - 1)^length is 0 / 0 or less than 1",
      [] { return withNodes(constantNodes(1.0)); }, 120.0, 120.0,
      "one colour, opaque wherever a ray touches the data: 8 digits" },
    { "OpacityOneColors", "the first sample lies somewhere in the first step, not where it begins",
      opaqueColors, 100.0, 100.0,
      "the colour is that of the value where the ray enters; nearest is exact" },
    { "OpaqueSurface", "the surface is found up to a step too late: rings", opaqueSurface, 100.0,
      100.0,
      "the colour is that of the value where it becomes opaque, wherever in the step that is" },
    { "StepScale1000", "no interval is left; a region without a sample",
      [] { return withStep(1e3); }, 15.0, 100.0,
      "one interval a region is as good as it gets: the picture has to be there, and finite; "
      "nearest "
      "has no steps" },
    { "StepScaleOneThousandth", "opacities so small that 1 - (1 - a)^s is rounding noise",
      smallStep, 70.0, 100.0,
      "errors of float32 in a thousand small intervals a cell average out" },
    { "UnitDistanceTiny", "log(1 - a) of small opacities has few digits: too dense or empty",
      [] { return withUnit(1e-6, 1.0); }, 60.0, 90.0,
      "the medium of UnitDistanceOne: opacity 1e-6 of 1e-6 is 0.63 of 1" },
    { "UnitDistanceOne", "the two beside it are to look like this one",
      [] { return withUnit(1.0, 1.0); }, 60.0, 100.0, "as in Ratio2" },
    { "UnitDistanceHuge", "opacities next to 1 have few digits: too thin, or opaque",
      [] { return withUnit(24.0, 1.0); }, 60.0, 85.0,
      "the medium of UnitDistanceOne: 1 - a is down to 6e-6, of which float32 keeps 2 digits in an "
      "opacity, and more in its logarithm" },
    { "UnitDistanceMillions", "a picture of 1e-5 is lost, or an overflow",
      [] { return withUnit(1e6, 1e-5); }, 100.0, 110.0,
      "nearly nothing is visible; what is has to be right to some per cent" },
  };
}
}
}
