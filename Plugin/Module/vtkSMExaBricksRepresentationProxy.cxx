// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMExaBricksRepresentationProxy.h"

#include "BoundsDefault.h"
#include "UnusedProperties.h"

#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkPVSession.h"
#include "vtkProcessModule.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSession.h"

#include <string>

vtkStandardNewMacro(vtkSMExaBricksRepresentationProxy);

struct vtkSMExaBricksRepresentationProxy::vtkInternals
{
  exabricks::BoundsDefault UnitDistance;
  exabricks::BoundsDefault VolumeUnitDistance; // of ParaView's own volume rendering
  double Time = 0.0; // of the view, when the unit distance was updated last

  // The last warnings, each of which is given once as long as it stays the same.
  std::string UnusedSettings;
  std::string Ranks;
};

vtkSMExaBricksRepresentationProxy::vtkSMExaBricksRepresentationProxy()
  : Internals(new vtkInternals)
{
}

vtkSMExaBricksRepresentationProxy::~vtkSMExaBricksRepresentationProxy() = default;

void vtkSMExaBricksRepresentationProxy::CreateVTKObjects()
{
  const bool isNew = !this->ObjectsCreated;
  this->Superclass::CreateVTKObjects();
  vtkSMProxy* parent = this->GetParentProxy();
  if (isNew && parent)
  {
    exabricks::hideUnusedProperties(parent, this);
  }
}

void vtkSMExaBricksRepresentationProxy::ViewUpdated(vtkSMProxy* view)
{
  if (view && view != this->View)
  {
    // A view renders after its update, and then fires this event. The observer goes away with this
    // object.
    view->AddObserver(
      vtkCommand::EndEvent, this, &vtkSMExaBricksRepresentationProxy::UpdateStatistics);
    this->View = view;
  }
  this->Superclass::ViewUpdated(view);
  this->UpdateUnitDistance(view);

  vtkSMProxy* parent = this->GetParentProxy();
  const bool shown = parent && vtkSMPropertyHelper(parent, "Visibility", true).GetAsInt() != 0 &&
    vtkSMPropertyHelper(parent, "Representation", true).GetAsString() == std::string("ExaBricks");
  // In a batch each process may be a client of its own.
  if (shown && vtkProcessModule::GetProcessModule()->GetPartitionId() == 0)
  {
    this->WarnOfUnusedSettings();
    this->WarnOfRanks();
  }
}

void vtkSMExaBricksRepresentationProxy::UpdateUnitDistance(vtkSMProxy* view)
{
  vtkInternals& internals = *this->Internals;
  if (vtkSMProxy* parent = this->GetParentProxy())
  {
    internals.VolumeUnitDistance.update(parent->GetProperty("ScalarOpacityUnitDistance"));
  }
  vtkSMProperty* property = this->GetProperty("OpacityUnitDistance");
  internals.UnitDistance.update(property);
  const double time = view ? vtkSMPropertyHelper(view, "ViewTime", true).GetAsDouble() : 0.0;
  // Over time the number of cells changes too. There the distance stays, lest an animation
  // brightens and darkens.
  const bool sameTime = time == internals.Time;
  internals.Time = time;
  if (sameTime && internals.UnitDistance.isKept() && internals.UnitDistance.hasChanged())
  {
    vtkSMPropertyHelper(property).Set(internals.UnitDistance.value());
    this->UpdateVTKObjects();
    internals.UnitDistance.update(property);
  }
}

void vtkSMExaBricksRepresentationProxy::WarnOfUnusedSettings()
{
  vtkSMProxy* parent = this->GetParentProxy();
  std::string settings = exabricks::describeUnusedSettings(parent);
  const double distance = vtkSMPropertyHelper(this, "OpacityUnitDistance").GetAsDouble();
  // Where there were no data yet, as in a script for Catalyst, ParaView has left the XML file's.
  vtkSMProperty* ofVolume = parent->GetProperty("ScalarOpacityUnitDistance");
  if (ofVolume && !ofVolume->IsValueDefault() && !this->Internals->VolumeUnitDistance.isKept() &&
    vtkSMPropertyHelper(ofVolume).GetAsDouble() != distance)
  {
    settings += (settings.empty() ? "" : "; ") +
      std::string("ScalarOpacityUnitDistance (set OpacityUnitDistance, which is ") +
      std::to_string(distance) + ")";
  }
  if (!settings.empty() && settings != this->Internals->UnusedSettings)
  {
    vtkWarningMacro("The representation ExaBricks does not use what was set of: "
      << settings << ". Reset it, or choose another representation.");
  }
  this->Internals->UnusedSettings = settings;
}

void vtkSMExaBricksRepresentationProxy::WarnOfRanks()
{
  const int ranks = this->GetSession()->GetNumberOfProcesses(vtkPVSession::RENDER_SERVER);
  if (ranks <= 1)
  {
    return;
  }
  std::string warning;
  if (vtkSMPropertyHelper(this, "ErrorTolerance").GetAsDouble() > 0.0)
  {
    // Every rank would choose levels and steps of its own.
    warning += " ErrorTolerance is not used on several ranks; StepScale is.";
  }
  if (!warning.empty() && warning != this->Internals->Ranks)
  {
    vtkWarningMacro("ExaBricks draws on " << ranks << " ranks:" << warning);
  }
  this->Internals->Ranks = warning;
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
