// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/ViewInput.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>

namespace exabricks
{
namespace
{
// VTK keeps rows, GLM columns.
glm::dmat4 toGLM(vtkMatrix4x4* matrix)
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

View makeView(vtkRenderer* ren, vtkVolume* vol, const vtkExaBricksData::Contents& contents)
{
  View view;
  // With (-1, 1): explicit projections, as of tiled displays, ignore near and far arguments.
  const glm::dmat4 worldToNdc = toGLM(ren->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
    ren->GetTiledAspectRatio(), -1.0, 1.0));
  view.ndcToWorld = glm::inverse(worldToNdc);
  // World -> volume -> half cells from the lower corner of the bounds.
  glm::dmat4 volumeToHalfCells = glm::scale(glm::dmat4(1.0), 2.0 / contents.Spacing);
  volumeToHalfCells = glm::translate(volumeToHalfCells, -contents.World(glm::dvec3(0.0)));
  const glm::dmat4 worldToVolume = glm::inverse(toGLM(vol->GetMatrix()));
  view.ndcToHalfCells = volumeToHalfCells * worldToVolume * view.ndcToWorld;
  return view;
}
}
