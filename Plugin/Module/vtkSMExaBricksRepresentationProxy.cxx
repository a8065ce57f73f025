// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMExaBricksRepresentationProxy.h"

#include "vtkCommand.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMExaBricksRepresentationProxy);

vtkSMExaBricksRepresentationProxy::vtkSMExaBricksRepresentationProxy() = default;

vtkSMExaBricksRepresentationProxy::~vtkSMExaBricksRepresentationProxy() = default;

void vtkSMExaBricksRepresentationProxy::ViewUpdated(vtkSMProxy* view)
{
  if (view && view != this->View)
  {
    // A view renders after its update, and then fires this. The observer goes with this object.
    view->AddObserver(
      vtkCommand::EndEvent, this, &vtkSMExaBricksRepresentationProxy::UpdateStatistics);
    this->View = view;
  }
  this->Superclass::ViewUpdated(view);
}

void vtkSMExaBricksRepresentationProxy::UpdateStatistics()
{
  if (vtkSMProxy* statistics = this->GetSubProxy("Statistics"))
  {
    statistics->UpdatePropertyInformation();
  }
}

void vtkSMExaBricksRepresentationProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
