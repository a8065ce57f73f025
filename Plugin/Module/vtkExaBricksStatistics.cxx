// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksStatistics.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkExaBricksStatistics);

void vtkExaBricksStatistics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Text: " << this->Text << "\n";
}
