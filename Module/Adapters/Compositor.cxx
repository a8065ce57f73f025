// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/Compositor.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

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
  const std::function<View(int width, int height)>& makeView, VolumeRenderer& renderer,
  vtkOverlappingAMR* amr, const BrickedVolume& bricked)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  const Viewport viewport = findViewport();
  if (!window || viewport.width <= 0 || viewport.height <= 0)
  {
    return std::string();
  }
  const std::string fault =
    this->Selection.color(ren, window, viewport, makeView, renderer, amr, bricked, this->Back);
  if (!fault.empty() || this->Back.empty())
  {
    return fault;
  }
  return this->Picture.draw(window, { viewport.width, viewport.height }, this->Back)
    ? std::string()
    : refuse(viewport);
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
