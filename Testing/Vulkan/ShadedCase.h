// SPDX-License-Identifier: BSD-3-Clause
// A scene that is lit, as it is drawn and as it ought to be.
#ifndef ExaBricksTestingShadedCase_h
#define ExaBricksTestingShadedCase_h

#include "SceneRenderer.h"
#include "Traversals.h"

#include "Reference/Shaded.h"

namespace exabricks
{
struct ShadedCase
{
  SceneRenderer subject;
  reference::Oracle oracle;
  reference::View view;
  reference::ShadedSettings settings;

  ShadedCase(const reference::Scene& scene, const TransferFunction& transfer, int pixels)
    : subject(scene)
    , oracle(scene.hierarchy, findLeafBoxes(scene.hierarchy), scene.cells)
    , view(subject.look({ -0.6, 0.5, -0.4 }, 30.0, pixels))
  {
    this->subject.opacityUnitDistance = this->settings.opacityUnitDistance = 3.0;
    this->subject.setTransfer(transfer);
  }

  glm::dvec3 worldSize() const
  {
    return glm::dmat3(reference::logicalToWorld(this->subject.scene.hierarchy)) *
      glm::dvec3(this->subject.structure.tree.bounds.size());
  }

  reference::Image truth() const { return this->truthOf(reference::fieldOf(this->oracle)); }
  reference::Image truthOf(const reference::FieldFunction& field) const
  {
    return reference::renderShaded(field, this->subject.structure.tree.bounds, this->view,
      reference::logicalToWorld(this->subject.scene.hierarchy), this->subject.transfer,
      this->settings);
  }

  reference::Image draw()
  {
    this->subject.lighting = this->settings.lighting;
    return this->subject.render(this->view);
  }

  /// dB over drawn pixels, the worst of the traversals.
  double compare(const reference::Image& truth)
  {
    double worst = 1000.0;
    for (const Traversal traversal : traversalsOfDevice())
    {
      this->subject.renderer.selectTraversal(traversal);
      worst = std::min(worst, reference::psnrOfDrawn(this->draw(), truth));
    }
    return worst;
  }
};
}

#endif
