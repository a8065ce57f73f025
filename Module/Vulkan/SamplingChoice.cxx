// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/SamplingChoice.h"

#include "Core/PredictedRays.h"
#include "Core/Stopwatch.h"

#include <algorithm>
#include <cmath>

namespace exabricks
{
namespace vulkan
{
namespace
{
// About as many pixels tell the error of a picture; at most so many are drawn where few of them
// show anything.
constexpr double FirstPixels = 1024.0;
constexpr double MostPixels = 192000.0;
constexpr double StepScaleOfLittle = 0.25; // where no error can be told

View wholeOf(View view)
{
  if (view.target.whole)
  {
    view.camera = view.target.whole->camera;
    view.target.width = view.target.whole->width;
    view.target.height = view.target.whole->height;
    view.target.depth = nullptr;
  }
  view.target.nearDepth = nullptr;
  return view;
}
}

SamplingChoice::SamplingChoice(std::shared_ptr<Device> device)
  : Pictures(std::move(device))
{
}

Sampling SamplingChoice::find(const View& part, const MarchPass& pass, const MakeFrame& makeFrame)
{
  const View view = wholeOf(part);
  KnownSampling& known = this->Known[part.target.whole ? 1 : 0];
  if (known.isOf(view) || (part.quality.keepsSampling && known.isFor(view.quality)))
  {
    this->Seconds = 0.0;
    return known.sampling;
  }
  const Stopwatch watch;
  const double all = static_cast<double>(view.target.width) * view.target.height;
  std::optional<Sampling> sampling;
  for (double pixels = FirstPixels; !sampling; pixels = std::min(8.0 * pixels, MostPixels))
  {
    sampling = this->FindFrom(view, pixels, pass, makeFrame);
    if (!sampling && pixels >= std::min(all, MostPixels))
    {
      sampling = Sampling{ 0, StepScaleOfLittle };
    }
  }
  known = KnownSampling(view, *sampling);
  this->Seconds = watch.seconds();
  return *sampling;
}

std::optional<Sampling> SamplingChoice::FindFrom(
  const View& view, double pixels, const MarchPass& pass, const MakeFrame& makeFrame)
{
  const double all = static_cast<double>(view.target.width) * view.target.height;
  const double spacing = std::max(1.0, std::sqrt(all / pixels)); // of the pixels drawn
  View sparse = view;
  sparse.target.width = std::max(1, static_cast<int>(view.target.width / spacing));
  sparse.target.height = std::max(1, static_cast<int>(view.target.height / spacing));
  std::vector<float> depth;
  if (view.target.depth)
  {
    depth = pickDepths(view.target.depth, view.target, sparse.target);
    sparse.target.depth = depth.data();
  }
  this->Pictures.begin(sparse.target, pass,
    [&](const Sampling& sampling) -> std::optional<layout::Frame>
    {
      if (sampling.levelsLeftOut > view.quality.levelsLeftOut.value_or(sampling.levelsLeftOut))
      {
        return std::nullopt;
      }
      return makeFrame(sparse, sampling);
    });
  return findSampling(toleranceOfSteps(view), this->Pictures);
}
}
}
