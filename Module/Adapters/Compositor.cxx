// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/Compositor.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkHardwareSelector.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>

namespace exabricks
{
namespace
{
Target targetOf(const Viewport& viewport)
{
  Target target;
  target.width = viewport.width;
  target.height = viewport.height;
  return target;
}

bool isSparse(const Target& target, const Viewport& viewport)
{
  return target.width != viewport.width || target.height != viewport.height;
}

std::string refuse(const Viewport& viewport)
{
  return "expected OpenGL to take a picture of " + std::to_string(viewport.width) + " x " +
    std::to_string(viewport.height) + " pixels as a float texture, it refused";
}
}

std::optional<std::string> Compositor::draw(vtkAbstractVolumeMapper* mapper, vtkRenderer* ren,
  vtkVolume* vol, const std::function<View(int width, int height)>& makeView,
  const ColorWindow& colors, const Render& render)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  if (!window)
  {
    return "expected a window that draws with OpenGL (vtkOpenGLRenderWindow), found a " +
      std::string(ren->GetRenderWindow()->GetClassName());
  }
  const Viewport viewport = findViewport();
  if (viewport.width <= 0 || viewport.height <= 0)
  {
    return std::string();
  }
  this->Peeling = this->Peel.begin(mapper, vol);
  if (this->Peeling)
  {
    return this->DrawPeel(window, viewport, makeView, colors, render);
  }
  View view = makeView(viewport.width, viewport.height);
  const OpaqueDepth opaque = readDepth(window, viewport, this->Depth);
  if (opaque == OpaqueDepth::Refused)
  {
    return "expected OpenGL to copy the depth of a multisampled framebuffer, it refused. Call "
           "SetMultiSamples(0) of the window";
  }
  const bool hasDepth = opaque == OpaqueDepth::Read;
  const bool sparse = isSparse(view.target, viewport);
  if (sparse && hasDepth)
  {
    this->SparseDepth = pickDepths(this->Depth.data(), targetOf(viewport), view.target);
  }
  view.target.depth = !hasDepth ? nullptr : sparse ? this->SparseDepth.data() : this->Depth.data();
  const std::string fault = render(view, this->Back);
  if (!fault.empty())
  {
    return fault;
  }
  if (this->Back.empty())
  {
    return std::nullopt;
  }
  colors.apply(this->Back);
  const PixelGrid size{ view.target.width, view.target.height };
  const bool drawn = sparse && hasDepth
    ? this->Picture.draw(window, viewport, size, this->Back, this->SparseDepth, this->Depth)
    : this->Picture.draw(window, size, this->Back);
  return drawn ? std::string() : refuse(viewport);
}

std::optional<std::string> Compositor::drawSelection(vtkRenderer* ren,
  const std::function<View(int width, int height)>& makeView, VolumeRenderer& renderer)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  const Viewport viewport = findViewport();
  if (!window || viewport.width <= 0 || viewport.height <= 0)
  {
    return std::string();
  }
  vtkHardwareSelector* const selector = ren->GetSelector();
  const int pass = selector->GetCurrentPass();
  float color[3] = { 0.0f, 0.0f, 0.0f };
  if (pass == vtkHardwareSelector::ACTOR_PASS || pass == vtkHardwareSelector::PROCESS_PASS)
  {
    selector->BeginRenderProp();
    selector->GetPropColorValue(color);
    selector->EndRenderProp();
  }
  if (pass == vtkHardwareSelector::ACTOR_PASS)
  {
    this->Selected.clear();
    // Without a number for the prop, it would lose what is behind it.
    if (color[0] != 0.0f || color[1] != 0.0f || color[2] != 0.0f)
    {
      View view = makeView(viewport.width, viewport.height);
      this->RestrictDepth(window, viewport, selector->GetArea());
      keepWhole(view);
      view.target.depth = this->Depth.data();
      const std::string fault = renderer.render(view, this->Selected);
      if (!fault.empty())
      {
        this->Selected.clear();
        return fault;
      }
    }
  }
  // Other passes of a selection cover the same pixels.
  if (this->Selected.size() != static_cast<std::size_t>(viewport.width) * viewport.height)
  {
    return std::string();
  }
  this->Back.resize(this->Selected.size());
  std::transform(this->Selected.begin(), this->Selected.end(), this->Back.begin(),
    [&](const glm::vec4& pixel)
    {
      return pixel.a > 3.0f / 255.0f ? glm::vec4(color[0], color[1], color[2], 1.0f)
                                     : glm::vec4(0.0f);
    });
  return this->Picture.draw(window, { viewport.width, viewport.height }, this->Back)
    ? std::string()
    : refuse(viewport);
}

// Reads the depth of geometry; outside of the area (in pixels of the window) rays end where they
// begin.
void Compositor::RestrictDepth(
  vtkOpenGLRenderWindow* window, const Viewport& viewport, const unsigned int area[4])
{
  if (readDepth(window, viewport, this->Depth) != OpaqueDepth::Read)
  {
    this->Depth.assign(static_cast<std::size_t>(viewport.width) * viewport.height, 1.0f);
  }
  for (int y = 0; y < viewport.height; ++y)
  {
    for (int x = 0; x < viewport.width; ++x)
    {
      const auto atX = static_cast<unsigned int>(x + viewport.x);
      const auto atY = static_cast<unsigned int>(y + viewport.y);
      if (atX < area[0] || atX > area[2] || atY < area[1] || atY > area[3])
      {
        this->Depth[static_cast<std::size_t>(y) * viewport.width + x] = 0.0f;
      }
    }
  }
}

std::optional<std::string> Compositor::DrawPeel(vtkOpenGLRenderWindow* window,
  const Viewport& viewport, const std::function<View(int width, int height)>& makeView,
  const ColorWindow& colors, const Render& render)
{
  RayPieces back;
  RayPieces front;
  if (!this->Peel.readPieces(window, viewport, back, front))
  {
    return "expected OpenGL to run the shader of VTK's depth peeling, it refused. Call "
           "SetUseDepthPeelingForVolumes(false) of the renderer";
  }
  View view = makeView(viewport.width, viewport.height);
  if (!back.any && !front.any)
  {
    return this->Peel.isFirst() ? std::make_optional<std::string>() : std::nullopt;
  }
  keepWhole(view);
  if (isSparse(view.target, viewport))
  {
    for (std::vector<float>* depths : { &back.begin, &back.end, &front.begin, &front.end })
    {
      if (!depths->empty())
      {
        *depths = pickDepths(depths->data(), targetOf(viewport), view.target);
      }
    }
  }
  const auto renderPieces = [&](const RayPieces& pieces, Pixels& pixels)
  {
    view.target.nearDepth = pieces.begin.data();
    view.target.depth = pieces.end.data();
    return render(view, pixels);
  };
  std::string fault;
  if (back.any)
  {
    fault = renderPieces(back, this->Back);
  }
  else
  {
    this->Back.assign(back.begin.size(), glm::vec4(0.0f));
  }
  const bool gaveUp = fault.empty() && this->Back.empty();
  this->Front.clear();
  if (front.any && fault.empty() && !gaveUp)
  {
    fault = renderPieces(front, this->Front);
  }
  if (!fault.empty())
  {
    return fault;
  }
  if (gaveUp || (front.any && this->Front.empty()))
  {
    return std::nullopt;
  }
  colors.apply(this->Back);
  colors.apply(this->Front);
  return this->Picture.draw(
           window, { view.target.width, view.target.height }, this->Peel, this->Back, this->Front)
    ? std::string()
    : refuse(viewport);
}

void Compositor::release(vtkWindow* window)
{
  this->Picture.release(window);
  this->Peel.release(window);
}
}
