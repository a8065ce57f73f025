// SPDX-License-Identifier: BSD-3-Clause
// VTK's matrices as those of GLM.
#ifndef ExaBricksAdaptersMatrices_h
#define ExaBricksAdaptersMatrices_h

#include "vtkMatrix4x4.h"

#include <glm/mat4x4.hpp>

namespace exabricks
{
/// VTK keeps rows, GLM columns.
inline glm::dmat4 toGLM(vtkMatrix4x4* matrix)
{
  glm::dmat4 result;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      result[column][row] = matrix->GetElement(row, column);
    }
  }
  return result;
}

}

#endif
