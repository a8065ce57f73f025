// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/SelectionPasses.h"

#include "Adapters/AMRCompatibility.h"

#include "vtkHardwareSelector.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cstdint>

namespace exabricks
{
namespace
{
constexpr float ShownOpacity = 3.0f / 255.0f;

// How vtkHardwareSelector reads numbers of 24 bits.
glm::vec4 colorOf(std::int64_t number)
{
  const auto part = [&](int shift) { return static_cast<float>(number >> shift & 0xff) / 255.0f; };
  return { part(0), part(8), part(16), 1.0f };
}

// That of the prop, or of the process.
glm::vec4 propColor(vtkHardwareSelector* selector)
{
  glm::vec4 color(0.0f, 0.0f, 0.0f, 1.0f);
  selector->BeginRenderProp();
  selector->GetPropColorValue(&color.x);
  selector->EndRenderProp();
  return color;
}

// The part of the selected area, which is told in pixels of the window, that the viewport shows.
Viewport findPart(vtkHardwareSelector* selector, const Viewport& viewport)
{
  const unsigned int* const area = selector->GetArea();
  Viewport part;
  part.x = std::max(viewport.x, static_cast<int>(area[0]));
  part.y = std::max(viewport.y, static_cast<int>(area[1]));
  part.width = std::min(viewport.x + viewport.width, static_cast<int>(area[2]) + 1) - part.x;
  part.height = std::min(viewport.y + viewport.height, static_cast<int>(area[3]) + 1) - part.y;
  return part;
}
}

std::string SelectionPasses::color(vtkRenderer* ren, vtkOpenGLRenderWindow* window,
  const Viewport& viewport, const MakeView& makeView, VolumeRenderer& renderer,
  vtkOverlappingAMR* amr, const BrickedVolume& bricked, Pixels& colors)
{
  vtkHardwareSelector* const selector = ren->GetSelector();
  const int pass = selector->GetCurrentPass();
  colors.clear();
  if (pass == vtkHardwareSelector::ACTOR_PASS)
  {
    this->Selected.clear();
    const Viewport part = findPart(selector, viewport);
    // Without a number for the prop, it would lose what is behind it.
    const bool hasNumber = glm::vec3(propColor(selector)) != glm::vec3(0.0f);
    const bool ofProps = selector->GetActorPassOnly();
    // A number of a point is read of all that is selected, so that nothing is, where points are.
    const bool ofPoints =
      !ofProps && selector->GetFieldAssociation() == vtkDataObject::FIELD_ASSOCIATION_POINTS;
    if (!hasNumber || ofPoints || part.width <= 0 || part.height <= 0)
    {
      return {};
    }
    View view = cropTo(makeView(viewport.width, viewport.height), part.x - viewport.x,
      part.y - viewport.y, part.width, part.height);
    std::vector<float> depth;
    if (readDepth(window, part, depth) == OpaqueDepth::Read)
    {
      view.target.depth = depth.data();
    }
    const std::string fault =
      ofProps ? this->Select(view, renderer) : this->SelectCells(view, renderer, amr, bricked);
    if (!fault.empty())
    {
      this->Selected.clear();
      return fault;
    }
    const auto width = static_cast<std::size_t>(part.width);
    for (SelectedPixel& pixel : this->Selected)
    {
      const std::size_t x = pixel.number % width + static_cast<std::size_t>(part.x - viewport.x);
      const std::size_t y = pixel.number / width + static_cast<std::size_t>(part.y - viewport.y);
      pixel.number = x + static_cast<std::size_t>(viewport.width) * y;
      selector->UpdateMaximumCellId(pixel.cell.id);
    }
  }
  if (this->Selected.empty())
  {
    return {};
  }
  const bool ofProp =
    pass == vtkHardwareSelector::ACTOR_PASS || pass == vtkHardwareSelector::PROCESS_PASS;
  const glm::vec4 prop = ofProp ? propColor(selector) : colorOf(0);
  colors.assign(static_cast<std::size_t>(viewport.width) * viewport.height, glm::vec4(0.0f));
  for (const SelectedPixel& pixel : this->Selected)
  {
    const bool hasCell = pixel.cell.id >= 0;
    glm::vec4& color = colors[pixel.number];
    color = prop;
    if (hasCell && pass == vtkHardwareSelector::COMPOSITE_INDEX_PASS)
    {
      color = colorOf(numberOfBlock(amr, static_cast<unsigned int>(pixel.cell.level),
        static_cast<unsigned int>(pixel.cell.block)));
    }
    else if (hasCell && pass == vtkHardwareSelector::CELL_ID_LOW24)
    {
      color = colorOf(pixel.cell.id);
    }
    else if (hasCell && pass == vtkHardwareSelector::CELL_ID_HIGH24)
    {
      color = colorOf(pixel.cell.id >> 24);
    }
  }
  return {};
}

std::string SelectionPasses::Select(const View& view, VolumeRenderer& renderer)
{
  Pixels picture;
  const std::string fault = renderer.render(view, picture);
  for (std::size_t i = 0; i < picture.size() && fault.empty(); ++i)
  {
    if (picture[i].a > ShownOpacity)
    {
      this->Selected.push_back({ i, {} });
    }
  }
  return fault;
}

std::string SelectionPasses::SelectCells(
  const View& view, VolumeRenderer& renderer, vtkOverlappingAMR* amr, const BrickedVolume& bricked)
{
  const Structure& structure = *bricked.volume.structure;
  std::string fault;
  const std::vector<std::optional<FirstSeen>> seen =
    findFirstSeen(renderer, view, glm::dvec3(structure.tree.size), cellOpacity, fault);
  BlockSearch blocks(amr, bricked);
  for (std::size_t i = 0; i < seen.size(); ++i)
  {
    const std::optional<LeafCell> leaf =
      seen[i] ? findLeafCell(structure, seen[i]->inCell) : std::nullopt;
    const CellOfBlock cell = leaf ? blocks.find(*leaf, seen[i]->inCell) : CellOfBlock();
    if (cell.id >= 0)
    {
      this->Selected.push_back({ i, cell });
    }
  }
  return fault;
}
}
