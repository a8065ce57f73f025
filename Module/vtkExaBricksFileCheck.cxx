// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksFileCheck.h"

#include "Files/Plotfile.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkExaBricksFileCheck);

bool vtkExaBricksFileCheck::CanCheck(const std::string& path)
{
  std::error_code error;
  return std::filesystem::is_regular_file(std::filesystem::path(path) / "Header", error);
}

std::string vtkExaBricksFileCheck::FindFault(const std::string& path)
{
  return CanCheck(path) ? exabricks::findPlotfileFault(path) : std::string();
}

void vtkExaBricksFileCheck::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
