// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/TransferFunctionInput.h"

#include "vtkColorTransferFunction.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

namespace exabricks
{
namespace
{
// How many straight pieces stand for a curved stretch between two nodes (midpoints, sharpness,
// colour spaces other than RGB, logarithmic scale). They are off by less than half a step of an
// 8-bit colour; VTK itself draws from tables of 256 to 1024 entries for the whole range. Functions
// of many nodes bend less between two of them, and need fewer pieces.
int countPieces(int nodes) { return std::clamp(4096 / std::max(nodes, 1), 16, 256); }

// The values at which a function has nodes, or bends between them.
struct Bends
{
  std::set<double> values;

  void addStretch(
    double from, double to, double midpoint, double sharpness, bool straight, bool log, int pieces)
  {
    this->values.insert(from);
    this->values.insert(to);
    if (straight && !log && midpoint == 0.5 && sharpness == 0.0)
    {
      return;
    }
    const bool byFactor = log && from > 0.0 && to > 0.0;
    for (int i = 1; i < pieces; ++i)
    {
      const double part = static_cast<double>(i) / pieces;
      this->values.insert(byFactor ? from * std::pow(to / from, part) : from + part * (to - from));
    }
    this->values.insert(from + midpoint * (to - from)); // where a sharp stretch jumps
  }

  void add(vtkPiecewiseFunction* function)
  {
    double node[4]; // value, opacity, midpoint, sharpness
    double next[4];
    for (int i = 0; i < function->GetSize(); ++i)
    {
      function->GetNodeValue(i, node);
      this->values.insert(node[0]);
      if (i + 1 < function->GetSize())
      {
        function->GetNodeValue(i + 1, next);
        this->addStretch(node[0], next[0], node[2], node[3], true, function->GetUseLogScale(),
          countPieces(function->GetSize()));
      }
    }
  }

  void add(vtkColorTransferFunction* function)
  {
    const bool straight = function->GetColorSpace() == VTK_CTF_RGB;
    const bool log = function->GetScale() == VTK_CTF_LOG10;
    double node[6]; // value, red, green, blue, midpoint, sharpness
    double next[6];
    for (int i = 0; i < function->GetSize(); ++i)
    {
      function->GetNodeValue(i, node);
      this->values.insert(node[0]);
      if (i + 1 < function->GetSize())
      {
        function->GetNodeValue(i + 1, next);
        this->addStretch(
          node[0], next[0], node[4], node[5], straight, log, countPieces(function->GetSize()));
      }
    }
  }
};

using Colors = std::function<std::array<double, 3>(double)>;

Colors colorsOf(vtkColorTransferFunction* function)
{
  return [=](double value)
  {
    std::array<double, 3> rgb;
    function->GetColor(value, rgb.data());
    return rgb;
  };
}

// The function, if it shows steps of colors, else null.
vtkDiscretizableColorTransferFunction* asDiscretized(vtkColorTransferFunction* function)
{
  auto* discretizable = vtkDiscretizableColorTransferFunction::SafeDownCast(function);
  return discretizable && discretizable->GetDiscretize() ? discretizable : nullptr;
}

// Adds the values at which the steps end. VTK rounds in its own way, so they are searched for
// between the middles of the steps.
void addSteps(Bends& bends, vtkDiscretizableColorTransferFunction* function)
{
  const int steps = static_cast<int>(function->GetNumberOfValues());
  double range[2];
  function->GetRange(range);
  const bool log = function->GetUseLogScale() && (range[0] > 0.0 || range[1] < 0.0);
  const auto middle = [&](int step)
  {
    const double part = (step + 0.5) / steps;
    return log ? range[0] * std::pow(range[1] / range[0], part)
               : range[0] + part * (range[1] - range[0]);
  };
  const Colors colorAt = colorsOf(function);
  bends.values.insert(range[0]);
  bends.values.insert(range[1]);
  for (int step = 1; step < steps; ++step)
  {
    double below = middle(step - 1);
    double above = middle(step);
    const std::array<double, 3> color = colorAt(below);
    if (color == colorAt(above))
    {
      continue;
    }
    for (double half = 0.5 * (below + above); half > below && half < above;
         half = 0.5 * (below + above))
    {
      (colorAt(half) == color ? below : above) = half;
    }
    bends.values.insert(above);
  }
}

// The next float above one of at least 0: devices may take denormal ones for 0.
float nextFloat(float value)
{
  return std::max(std::nextafter(value, 2.0f), std::numeric_limits<float>::min());
}

// Evaluates the function at its bends. Where it jumps at one, points on both sides of it are added,
// one float away: the device compares floats, and a value that sits on a node has to get what VTK
// gives it there.
TransferFunction sampleAtBends(
  const Bends& bends, const Range& range, const std::function<glm::dvec4(double)>& evaluate)
{
  if (range.empty())
  {
    return {};
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<TransferFunction::Point> points;
  const auto colorAt = [&](double value)
  { return glm::clamp(evaluate(value), glm::dvec4(0.0), glm::dvec4(1.0)); };
  const auto add = [&](float normalized, const glm::dvec4& color)
  {
    const double value =
      points.empty() ? normalized : std::max<double>(normalized, points.back().value);
    if (points.empty() || points.back().value != value || points.back().color != color)
    {
      points.push_back({ value, color });
    }
  };
  // Whether the color changes by more than the slope on that side explains: where the range has few
  // floats, a slope alone changes the color from one to the next.
  const auto jumps = [](const glm::dvec4& at, const glm::dvec4& beside, const glm::dvec4& beyond)
  {
    const glm::dvec4 change = glm::abs(beside - at) - 2.0 * glm::abs(beyond - beside);
    return std::max({ change.r, change.g, change.b, change.a }) > 1e-6;
  };
  add(0.0f, colorAt(range.min));
  for (auto bend = bends.values.lower_bound(range.min);
       bend != bends.values.end() && *bend <= range.max; ++bend)
  {
    const double below = std::nextafter(*bend, -infinity);
    const double above = std::nextafter(*bend, infinity);
    const glm::dvec4 before = colorAt(below);
    const glm::dvec4 at = colorAt(*bend);
    const glm::dvec4 after = colorAt(above);
    const float normalized = static_cast<float>(range.normalize(*bend));
    if (*bend > range.min && jumps(at, before, colorAt(std::nextafter(below, -infinity))))
    {
      add(std::nextafter(normalized, -1.0f), before);
    }
    add(normalized, at);
    if (*bend < range.max && jumps(at, after, colorAt(std::nextafter(above, infinity))))
    {
      add(nextFloat(normalized), after);
    }
  }
  add(static_cast<float>(range.normalize(range.max)), colorAt(range.max));
  return TransferFunction(std::move(points));
}
}

TransferFunction makeTransferFunction(vtkColorTransferFunction* colors,
  vtkPiecewiseFunction* opacity, const Range& range, ColorsOf meaning)
{
  Bends bends;
  bends.add(opacity);
  vtkNew<vtkColorTransferFunction> ofValues;
  if (colors->GetIndexedLookup() && meaning == ColorsOf::Values)
  {
    // A function of categories has colors for the listed values alone.
    ofValues->DeepCopy(colors);
    ofValues->IndexedLookupOff();
    colors = ofValues;
  }
  if (colors->GetIndexedLookup())
  {
    for (vtkIdType i = 0; i < colors->GetNumberOfAnnotatedValues(); ++i)
    {
      bends.values.insert(colors->GetAnnotatedValue(i).ToDouble());
    }
  }
  else if (auto* discretized = asDiscretized(colors))
  {
    addSteps(bends, discretized);
  }
  else
  {
    bends.add(colors);
  }
  return sampleAtBends(bends, range,
    [opacity, colorAt = colorsOf(colors)](double value)
    {
      const std::array<double, 3> rgb = colorAt(value);
      return glm::dvec4(rgb[0], rgb[1], rgb[2], opacity->GetValue(value));
    });
}

TransferFunction makeTransferFunction(
  vtkPiecewiseFunction* gray, vtkPiecewiseFunction* opacity, const Range& range)
{
  Bends bends;
  bends.add(opacity);
  bends.add(gray);
  return sampleAtBends(bends, range,
    [=](double value)
    { return glm::dvec4(glm::dvec3(gray->GetValue(value)), opacity->GetValue(value)); });
}

TransferFunction makeTransferFunction(vtkPiecewiseFunction* opacity, const Range& range)
{
  Bends bends;
  if (!opacity)
  {
    return TransferFunction({ { 0.0, glm::dvec4(1.0) } });
  }
  bends.add(opacity);
  return sampleAtBends(bends, range,
    [=](double value) { return glm::dvec4(glm::dvec3(1.0), opacity->GetValue(value)); });
}
}
