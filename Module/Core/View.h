// SPDX-License-Identifier: BSD-3-Clause
// What is asked of a picture: from where, of which size and between which depths, and how well.
#ifndef ExaBricksCoreView_h
#define ExaBricksCoreView_h

#include "Core/Blending.h"
#include "Core/Cutaway.h"
#include "Core/Lighting.h"

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

namespace exabricks
{
enum class Reconstruction
{
  Basis,
  Nearest,
  Completed // with values that have a layer around each brick (Completion)
};

/// Where the picture is seen from: a projective map, z of normalised device coordinates in [-1, 1].
struct Camera
{
  glm::dmat4 ndcToHalfCells{ 1.0 };  // to half cells from the lower corner of the data's bounds
  glm::dmat3 halfCellsToData{ 1.0 }; // linear, to the data's own coordinates
};

/// The picture, row 0 at the bottom.
struct Target
{
  int width = 0;  // pixels
  int height = 0; // pixels
  /// Window depth in [0, 1] at which rays end, and at which they begin, [height][width]; null: at
  /// the far plane, and at the near plane. Where the end is not behind the beginning, nothing is
  /// drawn.
  const float* depth = nullptr;
  const float* nearDepth = nullptr;

  /// The whole picture of which this one is a part: a tile, the picture of one eye, or what lies
  /// between two depths. With an error tolerance, levels and steps are chosen for the whole,
  /// without regard to depth, so that all its parts have the same.
  struct Whole
  {
    Camera camera;
    int width = 0;  // pixels
    int height = 0; // pixels
  };
  std::optional<Whole> whole; // none: it is whole
};

/// How well the picture is drawn.
struct Quality
{
  Reconstruction reconstruction = Reconstruction::Basis;
  double stepScale = 1.0; // step in cells of the region's finest brick
  /// Distance of two samples, a length in the data's coordinates, in place of stepScale; 0: that
  /// counts.
  double sampleDistance = 0.0;
  bool jittered = false; // each pixel's samples lie elsewhere between the ends of regions
  /// Root mean square error of the drawn pixels' channels, in (0, 1), that steps are chosen for,
  /// early termination with them, and how many of the finest levels are left out; 0: stepScale and
  /// terminationOpacity alone count, and all levels are drawn but for levelsLeftOut.
  double errorTolerance = 0.0;
  /// So many of the finest levels are left out, and with an errorTolerance that steps are chosen
  /// for at most so many; none: as many as it allows.
  std::optional<int> levelsLeftOut;
  double terminationOpacity = 0.999; // a ray ends at this opacity
  /// While something moves: by it steps are multiplied, however they were chosen; and whether what
  /// was chosen last for the errorTolerance holds for this view too.
  double stepGrowth = 1.0;
  bool keepsSampling = false;
  /// While something moves: shadows may be those of the lights of the last view without this.
  bool lagsShadows = false;
};

struct View
{
  Camera camera;
  Target target;
  Quality quality;
  Cutaway cutaway;
  double opacityUnitDistance = 1.0; // length in the data's coordinates
  Blending blending = Blending::Composite;
  AverageRanges averageRanges = wholeAverageRanges(); // for Blending::Average
  std::vector<double> isoValues; // normalised, ascending, for Blending::Isosurface
  /// For Blending::Slice: as the planes of the cutaway.
  glm::dvec4 slicePlane{ 0.0, 0.0, 1.0, 0.0 };
  /// For Blending::Composite and Slice of one component: how cells look whose value is undefined,
  /// red, green, blue and the opacity of the unit distance, in [0, 1]; none: they are absent.
  std::optional<glm::dvec4> undefinedColor;
  std::optional<Lighting> lighting; // none: colours are those of the transfer function
};

/// Of depths, [target's height][target's width], those of the pixels that the rays of a sparser
/// picture go through.
inline std::vector<float> pickDepths(
  const float* depths, const Target& target, const Target& sparse)
{
  std::vector<float> picked;
  picked.reserve(static_cast<std::size_t>(sparse.width) * sparse.height);
  for (std::int64_t y = 0; y < sparse.height; ++y)
  {
    const std::int64_t row = (2 * y + 1) * target.height / (2 * sparse.height);
    for (std::int64_t x = 0; x < sparse.width; ++x)
    {
      picked.push_back(
        depths[(2 * x + 1) * target.width / (2 * sparse.width) + target.width * row]);
    }
  }
  return picked;
}

/// Makes the picture the whole, unless it is part of one already: what is drawn into the view from
/// now on is part of it.
inline void keepWhole(View& view)
{
  if (!view.target.whole)
  {
    view.target.whole = Target::Whole{ view.camera, view.target.width, view.target.height };
  }
}

/// A part of the view's picture, from the pixel (x, y) on, without its depths.
inline View cropTo(View view, int x, int y, int width, int height)
{
  keepWhole(view);
  const glm::dvec2 whole(view.target.width, view.target.height);
  const glm::dvec2 part(width, height);
  const glm::dvec2 scale = part / whole;
  const glm::dvec2 shift = (2.0 * glm::dvec2(x, y) + part) / whole - 1.0;
  view.camera.ndcToHalfCells = view.camera.ndcToHalfCells *
    glm::dmat4(glm::dvec4(scale.x, 0.0, 0.0, 0.0), glm::dvec4(0.0, scale.y, 0.0, 0.0),
      glm::dvec4(0.0, 0.0, 1.0, 0.0), glm::dvec4(shift, 0.0, 1.0));
  view.target.width = width;
  view.target.height = height;
  view.target.depth = nullptr;
  view.target.nearDepth = nullptr;
  return view;
}

/// Whether both show the same in the same size, but for depths.
inline bool samePicture(const View& a, const View& b)
{
  return a.camera.ndcToHalfCells == b.camera.ndcToHalfCells &&
    a.camera.halfCellsToData == b.camera.halfCellsToData && a.target.width == b.target.width &&
    a.target.height == b.target.height && a.quality.reconstruction == b.quality.reconstruction &&
    a.quality.stepScale == b.quality.stepScale &&
    a.quality.sampleDistance == b.quality.sampleDistance &&
    a.quality.jittered == b.quality.jittered &&
    a.quality.errorTolerance == b.quality.errorTolerance &&
    a.quality.levelsLeftOut == b.quality.levelsLeftOut &&
    a.quality.terminationOpacity == b.quality.terminationOpacity &&
    a.quality.stepGrowth == b.quality.stepGrowth &&
    a.quality.keepsSampling == b.quality.keepsSampling &&
    a.quality.lagsShadows == b.quality.lagsShadows && a.cutaway == b.cutaway &&
    a.opacityUnitDistance == b.opacityUnitDistance && a.blending == b.blending &&
    a.averageRanges == b.averageRanges && a.isoValues == b.isoValues &&
    a.slicePlane == b.slicePlane && a.undefinedColor == b.undefinedColor &&
    a.lighting == b.lighting;
}
}

#endif
