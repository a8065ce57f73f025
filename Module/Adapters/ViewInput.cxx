// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/ViewInput.h"

#include "Adapters/Matrices.h"

#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>

namespace exabricks
{
namespace
{
// From world to normalised device coordinates, with the eye of a stereo picture and the camera's
// model transform. VTK's geometry has a copy of it (vtkOpenGLCamera::GetKeyMatrices), which is one
// picture late when stereo is switched on.
glm::dmat4 findProjection(vtkRenderer* ren)
{
  vtkCamera* camera = ren->GetActiveCamera();
  // With (-1, 1): explicit projections, as of tiled displays, ignore near and far arguments.
  const glm::dmat4 projection =
    toGLM(camera->GetProjectionTransformMatrix(ren->GetTiledAspectRatio(), -1.0, 1.0));
  return projection * toGLM(camera->GetModelViewTransformMatrix());
}

// The same from between the two eyes of a stereo picture.
glm::dmat4 findCentralProjection(vtkRenderer* ren)
{
  return toGLM(ren->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
    ren->GetTiledAspectRatio(), -1.0, 1.0));
}

// Where the window is tiled, the camera is that of one tile: the middle and the half size of the
// tile, in normalised device coordinates of the renderer's whole picture along one axis.
struct TilePart
{
  double middle = 0.0;
  double half = 1.0;

  TilePart(const double viewport[4], const double tile[4], int axis)
  {
    const double size = viewport[axis + 2] - viewport[axis];
    const double from = std::clamp(viewport[axis], tile[axis], tile[axis + 2]);
    const double to = std::clamp(viewport[axis + 2], tile[axis], tile[axis + 2]);
    if (size > 0.0 && to > from)
    {
      this->middle = (from + to - viewport[axis] - viewport[axis + 2]) / size;
      this->half = (to - from) / size;
    }
  }
};
}

View makeView(vtkRenderer* ren, vtkVolume* vol, const BrickedVolume& bricked, int width, int height)
{
  vtkCamera* camera = ren->GetActiveCamera();
  // Data -> half cells from the lower corner of the bounds.
  const glm::dmat4 dataToHalfCells = glm::translate(
    glm::scale(glm::dmat4(1.0), 2.0 / bricked.spacing), -bricked.world(glm::dvec3(0.0)));
  const glm::dmat4 worldToData = glm::inverse(toGLM(vol->GetMatrix()));

  View view;
  view.target.width = width;
  view.target.height = height;
  view.camera.ndcToHalfCells = dataToHalfCells * worldToData * glm::inverse(findProjection(ren));
  view.camera.halfCellsToData = glm::dmat3(glm::scale(glm::dmat4(1.0), 0.5 * bricked.spacing));

  vtkWindow* window = ren->GetVTKWindow();
  int tiles[2] = { 1, 1 };
  if (window)
  {
    window->GetTileScale(tiles);
  }
  const bool tiled = tiles[0] > 1 || tiles[1] > 1;
  if (tiled || camera->GetStereo())
  {
    Target::Whole whole{ view.camera, width, height };
    glm::dmat4 ndcToWorld = glm::inverse(findCentralProjection(ren));
    if (tiled)
    {
      double viewport[4];
      double tile[4];
      ren->GetViewport(viewport);
      window->GetTileViewport(tile);
      const TilePart x(viewport, tile, 0);
      const TilePart y(viewport, tile, 1);
      glm::dmat4 tileToWhole = glm::translate(glm::dmat4(1.0), glm::dvec3(x.middle, y.middle, 0.0));
      tileToWhole = glm::scale(tileToWhole, glm::dvec3(x.half, y.half, 1.0));
      ndcToWorld = ndcToWorld * glm::inverse(tileToWhole);
      const int* size = window->GetSize(); // of all tiles
      whole.width = static_cast<int>(std::lround((viewport[2] - viewport[0]) * size[0]));
      whole.height = static_cast<int>(std::lround((viewport[3] - viewport[1]) * size[1]));
    }
    whole.camera.ndcToHalfCells = dataToHalfCells * worldToData * ndcToWorld;
    view.target.whole = whole;
  }
  return view;
}

std::optional<PlaceInPicture> findPlace(vtkRenderer* ren, double displayX, double displayY)
{
  PlaceInPicture place;
  int corner[2];
  ren->GetTiledSizeAndOrigin(&place.width, &place.height, &corner[0], &corner[1]);
  if (place.width <= 0 || place.height <= 0)
  {
    return std::nullopt;
  }
  place.ndc = { 2.0 * (displayX + 0.5 - corner[0]) / place.width - 1.0,
    2.0 * (displayY + 0.5 - corner[1]) / place.height - 1.0 };
  vtkRenderWindow* window = ren->GetRenderWindow();
  vtkNew<vtkFloatArray> depth;
  const int x = static_cast<int>(displayX);
  const int y = static_cast<int>(displayY);
  if (!window->GetNeverRendered() && window->GetZbufferData(x, y, x, y, depth) == VTK_OK &&
    depth->GetNumberOfValues() == 1)
  {
    place.depth = std::clamp<double>(depth->GetValue(0), 0.0, 1.0);
  }
  return place;
}
}
