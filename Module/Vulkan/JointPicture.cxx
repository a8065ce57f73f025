// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/JointPicture.h"

#include "Core/DepthRange.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace exabricks
{
namespace
{
constexpr float Densest = 17.0f; // depth at which nothing comes through, in floats

// Depths in normalised device coordinates.
struct Depths
{
  double from;
  double to;
};

bool meet(const Depths& a, const Depths& b) { return a.from < b.to && b.from < a.to; }

// Between which the bounds lie; from the near plane on, where some of them are behind the eye.
Depths findDepths(const JointVolume& volume)
{
  const DepthRange range = findDepthRange(volume.view.camera.ndcToHalfCells, volume.size);
  return { range.allBeforeEye ? std::clamp(range.from, -1.0, 1.0) : -1.0,
    std::clamp(range.to, -1.0, 1.0) };
}

// Lengths along the middle of the picture, half cells.
class MiddleRay
{
public:
  explicit MiddleRay(const glm::dmat4& ndcToHalfCells)
    : NdcToHalfCells(ndcToHalfCells)
  {
  }

  double length(const Depths& depths) const
  {
    return glm::distance(this->Place(depths.from), this->Place(depths.to));
  }

  // The ends of layers of the same thickness, ascending.
  std::vector<double> cutEvenly(const Depths& depths, int layers) const
  {
    const double whole = this->length(depths);
    std::vector<double> ends{ depths.from };
    for (int i = 1; i < layers; ++i)
    {
      double before = ends.back();
      double behind = depths.to;
      for (int halving = 0; halving < 50; ++halving)
      {
        const double half = 0.5 * (before + behind);
        (this->length({ depths.from, half }) < whole * i / layers ? before : behind) = half;
      }
      ends.push_back(behind);
    }
    ends.push_back(depths.to);
    return ends;
  }

private:
  glm::dvec3 Place(double depth) const
  {
    const glm::dvec4 at = this->NdcToHalfCells * glm::dvec4(0.0, 0.0, depth, 1.0);
    return glm::dvec3(at) / at.w;
  }

  const glm::dmat4 NdcToHalfCells;
};

float extinctionOf(float opacity)
{
  return opacity < 1.0f ? std::min(-std::log1p(-opacity), Densest) : Densest;
}

// What is in one layer of a pixel, of all volumes so far.
struct Layer
{
  std::vector<glm::vec4> pixels;    // red, green and blue times extinction, and extinction
  std::vector<unsigned char> shown; // how many volumes there are

  void add(const std::vector<glm::vec4>& picture)
  {
    this->pixels.resize(picture.size(), glm::vec4(0.0f));
    this->shown.resize(picture.size(), 0);
    for (std::size_t i = 0; i < picture.size(); ++i)
    {
      const glm::vec4& pixel = picture[i];
      if (pixel.a > 0.0f)
      {
        this->pixels[i] += pixel * (extinctionOf(pixel.a) / pixel.a);
        ++this->shown[i];
      }
    }
  }

  bool isShared(std::size_t pixel) const { return this->shown[pixel] > 1; }
  bool isShared() const
  {
    return std::any_of(
      this->shown.begin(), this->shown.end(), [](unsigned char volumes) { return volumes > 1; });
  }

  // All of it, or what of it is not shared.
  void putBehind(std::vector<glm::vec4>& picture, bool shared = true) const
  {
    for (std::size_t i = 0; i < this->pixels.size(); ++i)
    {
      const glm::vec4& layer = this->pixels[i];
      if (layer.a > 0.0f && (shared || !this->isShared(i)))
      {
        const float opacity = layer.a >= Densest ? 1.0f : -std::expm1(-layer.a);
        picture[i] += (1.0f - picture[i].a) * (opacity / layer.a) * layer;
      }
    }
  }
};

class Drawing
{
public:
  Drawing(const std::vector<JointVolume>& volumes, const Target& target)
    : Volumes(volumes)
    , Whole(target)
    , Pixels(static_cast<std::size_t>(target.width) * target.height)
  {
    for (const JointVolume& volume : volumes)
    {
      this->Extents.push_back(findDepths(volume));
    }
    this->CutAtEnds();
  }

  // Leaves the picture empty, if `progress` gives it up.
  std::string draw(
    std::vector<glm::vec4>& picture, double& marching, const VolumeRenderer::Progress& progress)
  {
    picture.assign(this->Pixels, glm::vec4(0.0f));
    this->Progress = progress;
    std::string fault;
    for (std::size_t i = 0; i < this->Pieces.size() && fault.empty() && !this->GivenUp; ++i)
    {
      fault = this->DrawPiece(this->Pieces[i], picture);
    }
    marching += this->Marching;
    if (this->GivenUp)
    {
      picture.clear();
    }
    return fault;
  }

private:
  // Depths between which no volume begins or ends.
  struct Piece
  {
    Depths depths;
    int layers; // where more than one volume shows
  };

  void CutAtEnds()
  {
    std::vector<double> ends;
    for (const Depths& extent : this->Extents)
    {
      ends.insert(ends.end(), { extent.from, extent.to });
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    const MiddleRay ray(this->Volumes.front().view.camera.ndcToHalfCells);
    double sharedLength = 0.0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    {
      const Depths depths{ ends[i], ends[i + 1] };
      const auto volumes = std::count_if(this->Extents.begin(), this->Extents.end(),
        [&](const Depths& extent) { return meet(extent, depths); });
      if (volumes > 0)
      {
        this->Pieces.push_back({ depths, volumes > 1 ? JointLayers : 0 });
        sharedLength += volumes > 1 ? ray.length(depths) : 0.0;
      }
    }
    for (Piece& piece : this->Pieces)
    {
      if (piece.layers > 0)
      {
        // As thick as they would be if all that is shared were one piece.
        const double part = ray.length(piece.depths) / std::max(sharedLength, 1e-300);
        piece.layers = std::max(1, static_cast<int>(std::ceil(JointLayers * part)));
      }
      this->Passes += 1 + piece.layers;
    }
  }

  // Where one volume alone shows, the depths need no layers.
  std::string DrawPiece(const Piece& piece, std::vector<glm::vec4>& picture)
  {
    Layer whole;
    std::string fault = this->Gather(piece.depths, picture, nullptr, whole);
    if (!fault.empty() || this->GivenUp)
    {
      return fault;
    }
    whole.putBehind(picture, /*shared=*/false);
    if (!whole.isShared())
    {
      return {};
    }
    const std::vector<double> ends = MiddleRay(this->Volumes.front().view.camera.ndcToHalfCells)
                                       .cutEvenly(piece.depths, piece.layers);
    for (std::size_t i = 0; i + 1 < ends.size() && fault.empty() && !this->GivenUp; ++i)
    {
      Layer layer;
      fault = this->Gather({ ends[i], ends[i + 1] }, picture, &whole, layer);
      layer.putBehind(picture);
    }
    return fault;
  }

  // Draws the volumes between two depths; with `only`, in the pixels that it shares.
  std::string Gather(
    const Depths& depths, const std::vector<glm::vec4>& picture, const Layer* only, Layer& layer)
  {
    bool restricted = false;
    for (std::size_t k = 0; k < this->Volumes.size() && !this->GivenUp; ++k)
    {
      if (!meet(depths, this->Extents[k]))
      {
        continue;
      }
      View view = this->Volumes[k].view;
      if (!restricted)
      {
        this->Restrict(depths, picture, only, view.quality.terminationOpacity);
        restricted = true;
      }
      keepWhole(view);
      view.target.width = this->Whole.width;
      view.target.height = this->Whole.height;
      view.target.nearDepth = this->Begin.data();
      view.target.depth = this->End.data();
      VolumeRenderer& renderer = *this->Volumes[k].renderer;
      const auto progress = [&](double done)
      { return !this->Progress || this->Progress((this->Done + done) / this->Passes); };
      const std::string fault = renderer.render(view, this->Part, progress);
      if (!fault.empty())
      {
        return fault;
      }
      this->GivenUp = this->Part.empty();
      this->Marching += renderer.statistics().marchTime;
      layer.add(this->Part);
    }
    ++this->Done;
    return {};
  }

  // Where the depths begin and end in each pixel: nowhere, where nothing behind would be seen.
  void Restrict(const Depths& depths, const std::vector<glm::vec4>& picture, const Layer* only,
    double termination)
  {
    const float from = static_cast<float>(0.5 * depths.from + 0.5);
    const float to = static_cast<float>(0.5 * depths.to + 0.5);
    this->Begin.resize(this->Pixels);
    this->End.resize(this->Pixels);
    for (std::size_t i = 0; i < this->Pixels; ++i)
    {
      const bool seen =
        picture[i].a < static_cast<float>(termination) && (!only || only->isShared(i));
      const float end = this->Whole.depth ? std::min(to, this->Whole.depth[i]) : to;
      this->Begin[i] = this->Whole.nearDepth ? std::max(from, this->Whole.nearDepth[i]) : from;
      this->End[i] = seen ? end : 0.0f;
    }
  }

  const std::vector<JointVolume>& Volumes;
  const Target& Whole;
  const std::size_t Pixels;
  std::vector<Depths> Extents; // [volume]
  std::vector<Piece> Pieces;   // front to back
  std::vector<float> Begin;    // window depths in each pixel
  std::vector<float> End;
  std::vector<glm::vec4> Part;
  VolumeRenderer::Progress Progress;
  double Passes = 0.0; // at most
  double Done = 0.0;
  double Marching = 0.0; // seconds
  bool GivenUp = false;
};
}

std::string renderJointly(const std::vector<JointVolume>& volumes, const Target& target,
  std::vector<glm::vec4>& picture, double& marching, const VolumeRenderer::Progress& progress)
{
  return Drawing(volumes, target).draw(picture, marching, progress);
}
}
