// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksVolume.h"

#include "vtkExaBricksVolumeMapper.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkExaBricksVolume);

vtkExaBricksVolume::vtkExaBricksVolume() { this->Outline->SetMapper(this->OutlineMapper); }

vtkExaBricksVolume::~vtkExaBricksVolume() = default;

void vtkExaBricksVolume::SetOutlineConnection(vtkAlgorithmOutput* output)
{
  this->OutlineMapper->SetInputConnection(output);
}

int vtkExaBricksVolume::RenderVolumetricGeometry(vtkViewport* viewport)
{
  vtkRenderer* ren = vtkRenderer::SafeDownCast(viewport);
  if (!ren || ren->GetSelector())
  {
    return 0; // a volume of blended colours has no ids
  }
  int rendered = 0;
  bool drawn = false;
  if (!this->OutlineOnly)
  {
    rendered = this->Superclass::RenderVolumetricGeometry(viewport);
    auto* mapper = vtkExaBricksVolumeMapper::SafeDownCast(this->GetMapper());
    drawn = !mapper || mapper->GetDrawn() || ren->GetRenderWindow()->CheckAbortStatus();
  }
  if (!drawn)
  {
    this->Outline->SetUserMatrix(this->GetMatrix());
    rendered = this->Outline->RenderOpaqueGeometry(viewport);
  }
  this->InvokeEvent(vtkCommand::EndEvent);
  return rendered;
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
