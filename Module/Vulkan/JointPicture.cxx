// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/JointPicture.h"

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

// Between which the bounds lie; from the near plane on, where some of them are behind the eye.
Depths findDepths(const JointVolume& volume)
{
  const glm::dmat4 toNdc = glm::inverse(volume.view.camera.ndcToHalfCells);
  const double before = volume.view.camera.ndcToHalfCells[3].w;
  Depths depths{ 1.0, -1.0 };
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 place(corner & 1 ? volume.size.x : 0.0, corner & 2 ? volume.size.y : 0.0,
      corner & 4 ? volume.size.z : 0.0);
    const glm::dvec4 seen = toNdc * glm::dvec4(place, 1.0);
    if (!(before * seen.w > 0.0))
    {
      return { -1.0, 1.0 };
    }
    depths.from = std::min(depths.from, seen.z / seen.w);
    depths.to = std::max(depths.to, seen.z / seen.w);
  }
  return { std::clamp(depths.from, -1.0, 1.0), std::clamp(depths.to, -1.0, 1.0) };
}

// Those that at least two volumes have in common; nothing of them: from behind to.
Depths findShared(const std::vector<Depths>& all)
{
  Depths shared{ 1.0, -1.0 };
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    for (std::size_t k = i + 1; k < all.size(); ++k)
    {
      const Depths both{ std::max(all[i].from, all[k].from), std::min(all[i].to, all[k].to) };
      if (both.from < both.to)
      {
        shared = { std::min(shared.from, both.from), std::max(shared.to, both.to) };
      }
    }
  }
  return shared;
}

// The ends of layers of the same thickness along the middle of the picture, ascending.
std::vector<double> cutEvenly(const Depths& depths, const glm::dmat4& ndcToHalfCells)
{
  const auto place = [&](double depth)
  {
    const glm::dvec4 at = ndcToHalfCells * glm::dvec4(0.0, 0.0, depth, 1.0);
    return glm::dvec3(at) / at.w;
  };
  const glm::dvec3 first = place(depths.from);
  const double length = glm::distance(first, place(depths.to));
  std::vector<double> ends{ depths.from };
  for (int i = 1; i < JointLayers; ++i)
  {
    double before = ends.back();
    double behind = depths.to;
    for (int halving = 0; halving < 50; ++halving)
    {
      const double half = 0.5 * (before + behind);
      (glm::distance(first, place(half)) < length * i / JointLayers ? before : behind) = half;
    }
    ends.push_back(behind);
  }
  ends.push_back(depths.to);
  return ends;
}

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
  }

  // Leaves the picture empty, if `progress` gives it up.
  std::string draw(
    std::vector<glm::vec4>& picture, double& marching, const VolumeRenderer::Progress& progress)
  {
    picture.assign(this->Pixels, glm::vec4(0.0f));
    this->Progress = progress;
    const Depths shared = findShared(this->Extents);
    std::string fault;
    if (!(shared.from < shared.to))
    {
      this->Passes = 1;
      fault = this->DrawLayer({ -1.0, 1.0 }, picture);
    }
    else
    {
      this->Passes = JointLayers + 3;
      fault = this->DrawLayer({ -1.0, shared.from }, picture);
      fault = fault.empty() ? this->DrawShared(shared, picture) : fault;
      fault = fault.empty() ? this->DrawLayer({ shared.to, 1.0 }, picture) : fault;
    }
    marching += this->Marching;
    if (this->GivenUp)
    {
      picture.clear();
    }
    return fault;
  }

private:
  // Where one volume alone shows, the depths need no layers.
  std::string DrawShared(const Depths& shared, std::vector<glm::vec4>& picture)
  {
    Layer whole;
    std::string fault = this->Gather(shared, picture, nullptr, whole);
    if (!fault.empty() || this->GivenUp)
    {
      return fault;
    }
    whole.putBehind(picture, /*shared=*/false);
    if (!whole.isShared())
    {
      return {};
    }
    const std::vector<double> ends =
      cutEvenly(shared, this->Volumes.front().view.camera.ndcToHalfCells);
    for (std::size_t i = 0; i + 1 < ends.size() && fault.empty(); ++i)
    {
      Layer layer;
      fault = this->Gather({ ends[i], ends[i + 1] }, picture, &whole, layer);
      layer.putBehind(picture);
    }
    return fault;
  }

  std::string DrawLayer(const Depths& depths, std::vector<glm::vec4>& picture)
  {
    Layer layer;
    const std::string fault = this->Gather(depths, picture, nullptr, layer);
    layer.putBehind(picture);
    return fault;
  }

  // Draws the volumes between two depths; with `only`, in the pixels that it shares.
  std::string Gather(
    const Depths& depths, const std::vector<glm::vec4>& picture, const Layer* only, Layer& layer)
  {
    bool restricted = false;
    for (std::size_t k = 0; k < this->Volumes.size() && !this->GivenUp; ++k)
    {
      if (!(depths.from < this->Extents[k].to) || !(this->Extents[k].from < depths.to))
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
  std::vector<float> Begin;    // window depths in each pixel
  std::vector<float> End;
  std::vector<glm::vec4> Part;
  VolumeRenderer::Progress Progress;
  double Passes = 1.0; // at most
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
