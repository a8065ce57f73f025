// SPDX-License-Identifier: BSD-3-Clause
// A way to draw a scene. To add one: a class derived from Method, and a line in MethodTable.cxx.
#ifndef ExaBricksBenchmarksMethod_h
#define ExaBricksBenchmarksMethod_h

#include "Scene.h"

#include <limits>
#include <optional>

namespace exabricks
{
namespace benchmarks
{
constexpr double NotMeasured = std::numeric_limits<double>::quiet_NaN();

struct SetUp
{
  double seconds = NotMeasured;   // from the scene in memory until the first frame can be drawn
  double resampling = 0.0;        // part of it: to a grid, before anything is drawn
  double hostBytes = NotMeasured; // what it keeps of the scene
  double deviceBytes = NotMeasured;
  std::string note; // for the results: why there is no picture, or what is special
  bool possible = true;
};

class Method
{
public:
  virtual ~Method() = default;

  /// Makes everything ready to draw with that value of the parameter. Called once for each, before
  /// anything is drawn.
  virtual SetUp setUp(double value) = 0;
  /// One frame. What it takes is what is measured.
  virtual void draw(const Size& size, double value) = 0;
  /// What draw() drew last.
  virtual reference::Image picture() = 0;
  /// Whether the picture has opacity; windows are opaque.
  virtual bool hasOpacity() const { return false; }

  /// Of the last frame, where it is known.
  virtual double marchSeconds() const { return NotMeasured; }
  /// Of the field that such a frame takes, for each pixel on average; where they can be counted.
  virtual double samples(const Size&, double /*value*/) { return NotMeasured; }
};

enum class Role
{
  Ours,
  Baseline, // in our framework, but not what the mapper does
  Peer      // what a user would pick in VTK
};

struct MethodKind
{
  std::string name;
  Role role = Role::Ours;
  std::string parameter;   // what it is drawn with several values of; empty: nothing
  std::vector<double> all; // in --full
  std::vector<double> few; // in --quick
  /// Whose exact integral it comes to with ever smaller steps, if the oracle has it.
  std::optional<reference::Reconstruction> field;
  std::function<std::unique_ptr<Method>(const Scene&)> make;
  bool everywhere = false; // in --full, on scenes too where not all methods are drawn
};

/// The parameter of all that march by cells.
extern const char* const StepScale;
/// The parameter of ours that chooses steps by itself.
extern const char* const ErrorTolerance;
/// The value that a user gets who sets nothing.
constexpr double DefaultStepScale = 1.0;

std::vector<MethodKind> listMethods();

// The groups.
std::vector<MethodKind> listDirectMethods();  // our renderer, without a window: float pictures
std::vector<MethodKind> listVariantMethods(); // other marches in it, and ours with less
std::vector<MethodKind> listNativeMethods();  // ours, by the processor without Vulkan
std::vector<MethodKind> listWindowMethods();  // mappers, 8 bits a channel

/// The longest that may be spent on setting up one peer, seconds.
constexpr double LongestSetUp = 20.0;
}
}

#endif
