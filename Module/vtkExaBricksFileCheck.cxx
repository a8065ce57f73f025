// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksFileCheck.h"

#include "Files/EnzoHierarchy.h"
#include "Files/Plotfile.h"
#include "Files/UniformGridAMR.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkExaBricksFileCheck);

namespace
{
namespace fs = std::filesystem;

using FindFaultFunction = std::string (*)(const fs::path&);

// Of the kind that a path leads to; null, if nothing is known of it.
FindFaultFunction findCheck(const fs::path& path)
{
  std::error_code error;
  if (fs::is_directory(path, error))
  {
    return fs::is_regular_file(path / "Header", error) ? exabricks::findPlotfileFault : nullptr;
  }
  if (!fs::is_regular_file(path, error))
  {
    return nullptr;
  }
  const fs::path ending = path.extension();
  return ending == ".hierarchy"             ? exabricks::findEnzoFault
    : ending == ".vthb" || ending == ".vth" ? exabricks::findUniformGridAMRFault
                                            : FindFaultFunction(nullptr);
}
}

bool vtkExaBricksFileCheck::CanCheck(const std::string& path) { return findCheck(path) != nullptr; }

std::string vtkExaBricksFileCheck::FindFault(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::exists(path, error))
  {
    return "there is no file or folder '" + path + "'";
  }
  const FindFaultFunction check = findCheck(path);
  return check ? check(path) : std::string();
}

void vtkExaBricksFileCheck::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
