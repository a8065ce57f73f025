// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/Compositor.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

namespace exabricks
{
namespace
{
std::string refuse(const Viewport& viewport)
{
  return "expected OpenGL to take a picture of " + std::to_string(viewport.width) + " x " +
    std::to_string(viewport.height) + " pixels as a float texture, it refused";
}
}

std::optional<std::string> Compositor::draw(vtkAbstractVolumeMapper* mapper, vtkRenderer* ren,
  vtkVolume* vol, const std::function<View(int width, int height)>& makeView,
  VolumeRenderer& renderer, const VolumeRenderer::Progress& progress)
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
  View view = makeView(viewport.width, viewport.height);
  if (this->Peel.begin(mapper, vol))
  {
    return this->DrawPeel(window, viewport, view, renderer, progress);
  }
  const OpaqueDepth opaque = readDepth(window, viewport, this->Depth);
  if (opaque == OpaqueDepth::Refused)
  {
    return "expected OpenGL to copy the depth of a multisampled framebuffer, it refused. Call "
           "SetMultiSamples(0) of the window";
  }
  view.target.depth = opaque == OpaqueDepth::Read ? this->Depth.data() : nullptr;
  const std::string fault = renderer.render(view, this->Back, progress);
  if (!fault.empty())
  {
    return fault;
  }
  if (this->Back.empty())
  {
    return std::nullopt;
  }
  return this->Picture.draw(window, viewport, this->Back) ? std::string() : refuse(viewport);
}

std::optional<std::string> Compositor::DrawPeel(vtkOpenGLRenderWindow* window,
  const Viewport& viewport, View view, VolumeRenderer& renderer,
  const VolumeRenderer::Progress& progress)
{
  RayPieces back;
  RayPieces front;
  if (!this->Peel.readPieces(window, viewport, back, front))
  {
    return "expected OpenGL to run the shader of VTK's depth peeling, it refused. Call "
           "SetUseDepthPeelingForVolumes(false) of the renderer";
  }
  if (!back.any && !front.any)
  {
    return this->Peel.isFirst() ? std::make_optional<std::string>() : std::nullopt;
  }
  if (!view.target.whole)
  {
    view.target.whole = Target::Whole{ view.camera, view.target.width, view.target.height };
  }
  const auto render = [&](const RayPieces& pieces, Pixels& pixels)
  {
    view.target.nearDepth = pieces.begin.data();
    view.target.depth = pieces.end.data();
    return renderer.render(view, pixels, progress);
  };
  std::string fault;
  if (back.any)
  {
    fault = render(back, this->Back);
  }
  else
  {
    this->Back.assign(back.begin.size(), glm::vec4(0.0f));
  }
  const bool gaveUp = fault.empty() && this->Back.empty();
  this->Front.clear();
  if (front.any && fault.empty() && !gaveUp)
  {
    fault = render(front, this->Front);
  }
  if (!fault.empty())
  {
    return fault;
  }
  if (gaveUp || (front.any && this->Front.empty()))
  {
    return std::nullopt;
  }
  return this->Picture.draw(window, viewport, this->Peel, this->Back, this->Front)
    ? std::string()
    : refuse(viewport);
}

void Compositor::release(vtkWindow* window)
{
  this->Picture.release(window);
  this->Peel.release(window);
}
}
