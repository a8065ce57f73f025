// SPDX-License-Identifier: BSD-3-Clause
#include "UnusedProperties.h"

#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxy.h"
#include "vtkSmartPointer.h"

namespace exabricks
{
namespace
{
// Properties that change what is drawn of surfaces, or by ParaView's own volume rendering, and what
// helps in place of each. Not all versions of ParaView have all of them.
const struct
{
  const char* name;
  const char* instead;
} expectedToMatter[] = {
  { "Opacity", "lower the opacity function, or lengthen OpacityUnitDistance" },
  { "Shade", "switch Shading on" },
  { "MapScalars", "values are always mapped to colors" },
  { "MultiComponentsMapping",
    "choose a component or the magnitude in the color map, or set Components to Dependent" },
  { "BlockSelectors", "all blocks are drawn" },
  { "BlockColors", "all blocks have the colors of the color map" },
  { "BlockOpacities", "all blocks have the opacities of the opacity function" },
};

void hide(vtkSMProperty* property)
{
  vtkNew<vtkPVXMLElement> decorator;
  decorator->SetName("PropertyWidgetDecorator");
  decorator->AddAttribute("type", "GenericDecorator");
  decorator->AddAttribute("mode", "visibility");
  decorator->AddAttribute("property", "Representation");
  decorator->AddAttribute("value", "ExaBricks");
  decorator->AddAttribute("inverse", "1");

  // The hints are those of the definition, which all representations of AMR share: ours are added
  // to a copy.
  vtkNew<vtkPVXMLElement> hints;
  hints->SetName("Hints");
  if (vtkPVXMLElement* present = property->GetHints())
  {
    for (unsigned int i = 0; i < present->GetNumberOfNestedElements(); ++i)
    {
      hints->AddNestedElement(present->GetNestedElement(i), /*setParent=*/0);
    }
  }
  hints->AddNestedElement(decorator);
  property->SetHints(hints);
}
}

void hideUnusedProperties(vtkSMProxy* representation, vtkSMProxy* drawing)
{
  vtkSmartPointer<vtkSMPropertyIterator> place;
  place.TakeReference(representation->NewPropertyIterator());
  for (place->Begin(); !place->IsAtEnd(); place->Next())
  {
    vtkSMProperty* property = place->GetProperty();
    vtkSMProxy* owner = property ? property->GetParent() : nullptr;
    // Representation.xml shares properties of these two. Those of others belong to the data's axes,
    // to selections, or to types whose groups ParaView hides by itself.
    const std::string name = owner ? owner->GetXMLName() : "";
    const bool shares = name == "SurfaceRepresentation" || name == "AMRVolumeRepresentation";
    if (shares && !drawing->GetProperty(property->GetXMLName()))
    {
      hide(property);
    }
  }
}

std::string describeUnusedSettings(vtkSMProxy* representation)
{
  std::string text;
  for (const auto& candidate : expectedToMatter)
  {
    vtkSMProperty* property = representation->GetProperty(candidate.name);
    if (property && !property->IsValueDefault())
    {
      text +=
        (text.empty() ? "" : "; ") + std::string(candidate.name) + " (" + candidate.instead + ")";
    }
  }
  return text;
}
}
