// SPDX-License-Identifier: BSD-3-Clause
// Makes a mapper and says so: the package's headers, targets and library are complete.

#include "vtkExaBricksVolumeMapper.h"
#include "vtkNew.h"

#include <iostream>

int main()
{
  vtkNew<vtkExaBricksVolumeMapper> mapper;
  std::cout << "made a " << mapper->GetClassName() << std::endl;
  return 0;
}
