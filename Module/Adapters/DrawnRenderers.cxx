// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/DrawnRenderers.h"

#include "vtkCallbackCommand.h"
#include "vtkRenderer.h"
#include "vtkRendererDelegate.h"

#include <algorithm>

namespace exabricks
{
DrawnRenderers::DrawnRenderers()
{
  this->Command->SetClientData(this);
  this->Command->SetCallback(DrawnRenderers::OnEvent);
}

DrawnRenderers::~DrawnRenderers()
{
  for (const auto& [ren, drawn] : this->Drawn)
  {
    ren->RemoveObserver(this->Command);
  }
}

void DrawnRenderers::set(vtkRenderer* ren, bool drawn)
{
  const auto [at, isNew] = this->Drawn.try_emplace(ren, drawn);
  at->second = drawn;
  if (isNew)
  {
    ren->AddObserver(vtkCommand::StartEvent, this->Command);
    ren->AddObserver(vtkCommand::DeleteEvent, this->Command);
  }
}

bool DrawnRenderers::is(vtkRenderer* ren) const
{
  const auto found = this->Drawn.find(ren);
  return found != this->Drawn.end() && found->second;
}

bool DrawnRenderers::any() const
{
  // A renderer that does not draw, or has another one draw in its place, has no events.
  return std::any_of(this->Drawn.begin(), this->Drawn.end(),
    [](const auto& entry)
    {
      vtkRenderer* ren = entry.first;
      const bool delegates = ren->GetDelegate() && ren->GetDelegate()->GetUsed();
      return entry.second && ren->GetDraw() && !delegates;
    });
}

void DrawnRenderers::OnEvent(vtkObject* caller, unsigned long event, void* self, void*)
{
  auto& drawn = static_cast<DrawnRenderers*>(self)->Drawn;
  auto* ren = static_cast<vtkRenderer*>(caller);
  if (event == vtkCommand::DeleteEvent)
  {
    drawn.erase(ren);
  }
  else if (!ren->GetSelector()) // a selector's pictures are not shown
  {
    drawn[ren] = false;
  }
}
}
