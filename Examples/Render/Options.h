// SPDX-License-Identifier: BSD-3-Clause
// The command line: what may be asked for, checked as far as it can be without the data.

#ifndef ExaBricksRenderOptions_h
#define ExaBricksRenderOptions_h

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace render
{

using Vector3 = std::array<double, 3>;

struct OpacityPoint
{
  double Value;
  double Opacity; // of the unit distance
};

struct ColorPoint
{
  double Value;
  Vector3 Color;
};

struct Plane
{
  Vector3 Origin;
  Vector3 Normal;
};

struct Options
{
  std::string Scene;               // from which all was taken that was not asked for; empty: none
  std::vector<std::string> Inputs; // of a time series, in its order
  std::string Input;               // the last one, by which all is chosen that is not asked for
  std::string Output;              // a picture; of several, numbers come before its ending; a video
  std::string Statistics;          // JSON; empty: none
  bool ListArrays = false;
  int Turntable = 0;           // pictures of one turn; 0: one picture
  double FramesPerSecond = 25; // of a video
  bool Annotate = false;
  bool Quiet = false;

  std::string Array; // empty: density, temperature, or the first scalar one that varies
  std::vector<std::string> Arrays; // of several, each drawn into files of its own; empty: it is one
  std::optional<int> Component;    // none: the magnitude of a vector
  bool Log = false;
  bool Linear = false; // not even where logarithms would show more
  int Levels = 0;      // 0: all

  std::array<int, 2> Size{ { 800, 600 } };
  std::string View = "iso";
  std::optional<Vector3> Position, Focal, Up;
  double ViewAngle = 30.0; // degrees, of the picture's height
  bool Parallel = false;
  double ParallelScale = 0.0; // 0: so that all that shows is in view
  double Zoom = 1.0;

  std::string ColorMap = "viridis";
  std::vector<ColorPoint> Colors;             // in place of a map, in the values drawn
  std::optional<std::array<double, 2>> Range; // in units of the array, also with Log
  std::vector<OpacityPoint> Opacity;          // likewise; empty: by the histogram and blend mode
  double OpacityUnit = 0.0;                   // 0: from the data
  Vector3 Background{ { 0.0, 0.0, 0.0 } };
  std::string BackgroundName = "black";

  std::string BlendMode = "composite";
  std::vector<double> IsoValues;                // in units of the array
  std::optional<Plane> Slice;                   // of blend mode slice
  std::optional<std::array<int, 2>> LevelRange; // that are drawn
  std::vector<Plane> ClippingPlanes;
  std::optional<std::array<double, 6>> Cropping; // lower and upper planes of x, y, z
  bool Shaded = false;
  double Scattering = 0.0;  // of scenes: the mapper's VolumetricScatteringBlending
  double ShadowReach = 0.0; // and its GlobalIlluminationReach

  std::string Reconstruction = "basis";
  std::string Traversal = "automatic";
  std::string Device;
  double StepScale = 0.0; // 0: the mapper's own
  double ErrorTolerance = 0.0;
  int Frames = 0; // timed after the first

  // Whether several pictures are drawn.
  bool IsSeries() const { return this->Turntable > 0 || this->Inputs.size() > 1; }
};

// Reads the command line. False: there is nothing left to do (--help or --version was answered).
// Throws Failure(BadArguments).
bool parseOptions(int argc, char** argv, Options& options);

}

#endif
