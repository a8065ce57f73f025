// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksVolume.h"

#include "vtkExaBricksVolumeMapper.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>

vtkStandardNewMacro(vtkExaBricksVolume);

vtkExaBricksVolume::vtkExaBricksVolume() { this->Outline->SetMapper(this->OutlineMapper); }

vtkExaBricksVolume::~vtkExaBricksVolume() = default;

void vtkExaBricksVolume::SetOutlineConnection(vtkAlgorithmOutput* output)
{
  this->OutlineMapper->SetInputConnection(output);
}

double* vtkExaBricksVolume::GetBounds()
{
  if (!this->OutlineOnly)
  {
    return this->Superclass::GetBounds();
  }
  this->Outline->SetUserMatrix(this->GetMatrix());
  const double* const bounds = this->Outline->GetBounds();
  if (!bounds)
  {
    return nullptr;
  }
  std::copy_n(bounds, 6, this->Bounds);
  return this->Bounds;
}

int vtkExaBricksVolume::RenderVolumetricGeometry(vtkViewport* viewport)
{
  vtkRenderer* ren = vtkRenderer::SafeDownCast(viewport);
  if (!ren)
  {
    return 0;
  }
  const int rendered = this->OutlineOnly ? 0 : this->Superclass::RenderVolumetricGeometry(viewport);
  if (!ren->GetSelector()) // whose passes are no pictures
  {
    this->InvokeEvent(vtkCommand::EndEvent);
  }
  return rendered;
}

int vtkExaBricksVolume::RenderOverlay(vtkViewport* viewport)
{
  // The outline is not drawn with the volume, which VTK may render while it peels depth: lines have
  // no place there.
  vtkRenderer* ren = vtkRenderer::SafeDownCast(viewport);
  if (!ren || ren->GetSelector())
  {
    return 0;
  }
  auto* mapper = vtkExaBricksVolumeMapper::SafeDownCast(this->GetMapper());
  const bool drawn = !this->OutlineOnly &&
    (!mapper || mapper->GetDrawn() || ren->GetRenderWindow()->CheckAbortStatus());
  if (drawn)
  {
    return 0;
  }
  this->Outline->SetUserMatrix(this->GetMatrix());
  return this->Outline->RenderOpaqueGeometry(viewport);
}

void vtkExaBricksVolume::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Outline->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkExaBricksVolume::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OutlineOnly: " << this->OutlineOnly << "\n";
}
