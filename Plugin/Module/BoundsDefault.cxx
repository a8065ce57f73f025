// SPDX-License-Identifier: BSD-3-Clause
#include "BoundsDefault.h"

#include "vtkNew.h"
#include "vtkSMBoundsDomain.h"
#include "vtkSMDoubleVectorProperty.h"

#include <cmath>

namespace exabricks
{
namespace
{
// Whether the numbers are equal but for digits that states and panels do not write.
bool isAlike(double found, double expected)
{
  return std::abs(found - expected) <= 1e-6 * std::abs(expected);
}
}

void BoundsDefault::update(vtkSMProperty* property)
{
  auto* values = vtkSMDoubleVectorProperty::SafeDownCast(property);
  auto* domain = property ? property->FindDomain<vtkSMBoundsDomain>() : nullptr;
  if (!values || !domain || values->GetNumberOfElements() != 1)
  {
    return;
  }
  // Domains write their defaults into a property: not into this one, as panels listen to it.
  vtkNew<vtkSMDoubleVectorProperty> scratch;
  scratch->SetNumberOfElements(1);
  if (!domain->SetDefaultValues(scratch, /*use_unchecked_values=*/false))
  {
    return;
  }
  const double present = values->GetElement(0);
  const double expected = scratch->GetElement(0);
  if (!this->Known || present != this->Found)
  {
    // It may have been set back to the default of the data before these.
    this->Kept = isAlike(present, expected) || (this->Known && isAlike(present, this->Default));
  }
  this->Changed = this->Known && expected != this->Default;
  this->Known = true;
  this->Found = present;
  this->Default = expected;
}
}
