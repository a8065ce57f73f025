// SPDX-License-Identifier: BSD-3-Clause
// A volume of several components, drawn by the renderer and by brute force in double precision.
#ifndef ExaBricksTestingComponents_h
#define ExaBricksTestingComponents_h

#include "SceneRenderer.h"
#include "Traversals.h"

#include "Layout.h"
#include "Reference/Mixture.h"

#include <gtest/gtest.h>
#include <iostream>

namespace exabricks
{
namespace components
{
constexpr int Pixels = 28;
constexpr double UnitDistance = 12.0;

// A component: the scene's cells and holes, with other values.
inline reference::Scene makeComponent(reference::Scene scene, int component)
{
  for (std::vector<double>& block : scene.cells.values)
  {
    for (double& value : block)
    {
      // a wave of its own for each, over the range of the scene's values
      value = component == 0
        ? value
        : 3.0 * component + 2.0 * std::sin((2.0 + component) * value + 0.7 * component);
    }
  }
  return scene;
}

// Red, green, blue and grey, each of some values of its own, of which none is opaque.
inline TransferFunction makeFunction(int component)
{
  const glm::dvec3 colors[4] = { { 0.9, 0.1, 0.1 }, { 0.1, 0.9, 0.2 }, { 0.2, 0.3, 1.0 },
    { 0.8, 0.8, 0.8 } };
  const glm::dvec4 hidden(colors[component], 0.0);
  const glm::dvec4 shown(colors[component], 0.7);
  const double first = 0.15 * component;
  return TransferFunction({ { first, hidden }, { first + 0.2, shown }, { first + 0.35, hidden },
    { 0.8, hidden }, { 1.0, shown } });
}

inline Medium makeMedium(Mixing mixing, int components)
{
  Medium medium;
  medium.mixing = mixing;
  if (mixing == Mixing::Independent)
  {
    for (int k = 0; k < components; ++k)
    {
      medium.functions.push_back(makeFunction(k));
    }
    medium.weights = { 1.0, 0.4, 2.0, 0.0 };
    return medium;
  }
  if (mixing == Mixing::Planar)
  {
    // Waves across a plane of values, of which some parts are transparent.
    constexpr int Size = 16;
    medium.planar = { Size, Size, {} };
    for (int y = 0; y < Size; ++y)
    {
      for (int x = 0; x < Size; ++x)
      {
        medium.planar.pixels.emplace_back(0.5 + 0.5 * std::sin(0.7 * x), 0.06 * y, 1.0 - 0.06 * x,
          std::max(0.6 * std::sin(0.4 * x + 0.3 * y), 0.0));
      }
    }
    return medium;
  }
  if (mixing == Mixing::ColorAndOpacity)
  {
    medium.functions.push_back(TransferFunction({ { 0.0, { 1.0, 0.2, 0.0, 1.0 } },
      { 0.5, { 0.1, 1.0, 0.3, 1.0 } }, { 1.0, { 0.0, 0.1, 1.0, 1.0 } } }));
  }
  std::vector<TransferFunction::Point> opacities = makeFunction(2).points();
  for (TransferFunction::Point& point : opacities)
  {
    point.color = glm::dvec4(1.0, 1.0, 1.0, point.color.a);
  }
  medium.functions.push_back(TransferFunction(opacities));
  medium.colorScale = { 0.6, 0.9, 1.0, 1.0 };
  medium.colorOffset = { 0.3, 0.05, 0.0, 0.0 };
  return medium;
}

struct Case
{
  const char* name;
  Mixing mixing;
  int components;
};

inline void PrintTo(const Case& given, std::ostream* out) { *out << given.name; }

// What is asked beside the components.
struct Request
{
  const char* name = "composite";
  Blending blending = Blending::Composite;
  bool shaded = false;
  bool gradientOpacity = false;
  double leastDecibel = 60.0;
  double leastCoverage = 0.05;
  bool planarByGradient = false;
};

// Red, green, blue, white light from the side, with another material for each component.
inline Lighting makeLighting()
{
  Lighting lighting;
  lighting.lights.emplace_back();
  lighting.lights.back().direction = glm::normalize(glm::dvec3(-0.3, 0.8, -0.4));
  lighting.lights.back().diffuse = { 1.0, 0.9, 0.7 };
  for (std::size_t k = 0; k < lighting.materials.size(); ++k)
  {
    const double part = static_cast<double>(k) / 4.0;
    lighting.materials[k] = { 0.3 - 0.2 * part, 0.5 + 0.4 * part, 0.3 * part, 5.0 + 20.0 * part };
  }
  return lighting;
}

// Of each function another one: opaque where the field is steep, or where it is not.
inline double gradientOpacity(std::size_t function, double gradient)
{
  const double part = std::min(gradient / layout::GREATEST_GRADIENT, 1.0);
  return function % 2 == 0 ? part : 1.0 - part;
}

class WithComponents : public testing::TestWithParam<Case>
{
protected:
  // The truth is that of the renderer's scenes, each with one component.
  void Expect(
    const reference::Scene& scene, Reconstruction reconstruction, const Request& request = {}) const
  {
    const Case& given = this->GetParam();
    std::vector<reference::Scene> parts;
    for (int k = 0; k < given.components; ++k)
    {
      parts.push_back(makeComponent(scene, k));
    }
    SceneRenderer subject(parts[0]);
    Volume volume = subject.plain;
    std::vector<std::unique_ptr<reference::Oracle>> oracles;
    const bool nearest = reconstruction == Reconstruction::Nearest;
    std::vector<reference::FieldFunction> truths;
    for (int k = 0; k < given.components; ++k)
    {
      if (k > 0)
      {
        volume.furtherValues.push_back(makeValues(subject.structure, parts[k].cells));
      }
      oracles.push_back(std::make_unique<reference::Oracle>(
        parts[k].hierarchy, findLeafBoxes(parts[k].hierarchy), parts[k].cells));
      truths.push_back(reference::fieldOf(*oracles.back(),
        nearest ? reference::Reconstruction::Nearest : reference::Reconstruction::Basis));
    }
    const Medium medium = makeMedium(given.mixing, given.components);
    subject.renderer.setVolume(volume);
    subject.renderer.setMedium(medium);
    subject.opacityUnitDistance = UnitDistance;
    subject.reconstruction = reconstruction;
    const bool byGradient = request.shaded || request.gradientOpacity || request.planarByGradient;
    const reference::View view = byGradient
      ? subject.lookInside(Pixels / 2)
      : subject.look(
          { -0.6, 0.5, -0.4 }, 30.0, request.blending == Blending::Composite ? Pixels : Pixels / 2);
    reference::MixtureSettings settings;
    settings.step = nearest ? 1.0 / 128 : byGradient ? 1.0 / 16 : 1.0 / 32;
    settings.opacityUnitDistance = UnitDistance;
    settings.blending = subject.blending = request.blending;
    settings.logicalToWorld = reference::logicalToWorld(scene.hierarchy);
    subject.averageRanges =
      settings.averageRanges = { { { 0.2, 0.7 }, { 0.0, 0.5 }, { 0.4, 1.0 }, { 0.1, 0.9 } } };
    subject.stepScale = byGradient ? 0.03 : 0.25; // gradients jump between cells
    if (request.shaded)
    {
      settings.lighting = subject.lighting = makeLighting();
    }
    if (request.gradientOpacity)
    {
      std::vector<float> tables;
      const std::size_t functions =
        given.mixing == Mixing::Independent ? medium.functions.size() : 1;
      for (std::size_t i = 0; i < functions; ++i)
      {
        settings.gradientOpacity.emplace_back(
          [=](double gradient) { return gradientOpacity(i, gradient); });
        const std::vector<float> table = tabulateGradients(settings.gradientOpacity.back());
        tables.insert(tables.end(), table.begin(), table.end());
      }
      subject.renderer.setGradientOpacity(tables);
    }
    const reference::Image truth =
      reference::drawMixture(truths, subject.structure.tree.bounds, view, medium, settings);
    std::vector<Traversal> traversals = traversalsOfDevice();
    if (request.shaded || request.gradientOpacity || request.blending != Blending::Composite)
    {
      traversals.resize(1); // a pipeline for each takes longer than its pictures
    }
    for (const Traversal traversal : traversals)
    {
      subject.renderer.selectTraversal(traversal);
      const double quality = reference::psnrOfDrawn(subject.render(view), truth);
      std::cout << given.name << ", " << scene.name
                << (reconstruction == Reconstruction::Nearest ? ", nearest: " : ", basis: ")
                << request.name << ", " << quality << " dB, coverage " << coverage(truth) << "\n";
      EXPECT_GE(quality, request.leastDecibel);
      EXPECT_GT(coverage(truth), request.leastCoverage);
    }
  }
};
}
}

#endif
