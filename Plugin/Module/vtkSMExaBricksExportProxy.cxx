// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMExaBricksExportProxy.h"

#include "vtkExaBricksVolume.h"

#include "vtkCollectionRange.h"
#include "vtkCommand.h"
#include "vtkExporter.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

vtkStandardNewMacro(vtkSMExaBricksExportProxy);

namespace
{
bool showsVolume(vtkRenderWindow* window)
{
  for (vtkRenderer* renderer : vtk::Range(window->GetRenderers()))
  {
    for (vtkObject* prop : vtk::Range(renderer->GetViewProps()))
    {
      vtkProp* volume = vtkExaBricksVolume::SafeDownCast(prop);
      if (volume && volume->GetVisibility())
      {
        return true;
      }
    }
  }
  return false;
}
}

vtkSMExaBricksExportProxy::vtkSMExaBricksExportProxy() = default;

vtkSMExaBricksExportProxy::~vtkSMExaBricksExportProxy() = default;

void vtkSMExaBricksExportProxy::CreateVTKObjects()
{
  const bool isNew = !this->ObjectsCreated;
  this->Superclass::CreateVTKObjects();
  vtkSMProxy* parent = this->GetParentProxy();
  if (isNew && parent)
  {
    // The parent makes its object after this one, and has it when it was told what file to write.
    parent->AddObserver(vtkCommand::UpdateEvent, this, &vtkSMExaBricksExportProxy::WatchExporter);
  }
}

void vtkSMExaBricksExportProxy::WatchExporter()
{
  vtkSMProxy* parent = this->GetParentProxy();
  vtkObject* exporter =
    parent && !this->Exporter ? vtkObject::SafeDownCast(parent->GetClientSideObject()) : nullptr;
  if (exporter)
  {
    exporter->AddObserver(
      vtkCommand::ModifiedEvent, this, &vtkSMExaBricksExportProxy::ExporterModified);
    this->Exporter = exporter;
  }
}

void vtkSMExaBricksExportProxy::ExporterModified(vtkObject* caller, unsigned long, void*)
{
  // An exporter has a window just while it writes.
  auto* exporter = vtkExporter::SafeDownCast(caller);
  vtkRenderWindow* window = exporter ? exporter->GetRenderWindow() : nullptr;
  if (!window || window == this->Window)
  {
    this->Window = window;
    return;
  }
  this->Window = window;
  if (showsVolume(window))
  {
    vtkWarningMacro("The exporter "
      << this->GetParentProxy()->GetXMLLabel()
      << " writes surfaces, no volumes: what ExaBricks draws is left out. Save a screenshot for a "
         "picture of it, or export a surface such as a contour.");
  }
}

void vtkSMExaBricksExportProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
