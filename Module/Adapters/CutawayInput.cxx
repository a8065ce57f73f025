// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/CutawayInput.h"

#include "Adapters/Matrices.h"

#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <sstream>

namespace exabricks
{
namespace
{
bool isFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// What is left lies along the normal.
struct WorldPlane
{
  glm::dvec3 origin;
  glm::dvec3 normal;

  explicit WorldPlane(vtkPlane* plane)
  {
    plane->GetOrigin(&this->origin.x);
    plane->EvaluateGradient(&this->origin.x, &this->normal.x);
    // From VTK 9.5 on a plane may be moved along its normal, or turned to an axis.
    const double height = plane->EvaluateFunction(&this->origin.x);
    if (height != 0.0 && this->isPlane())
    {
      this->origin -= this->normal * (height / glm::dot(this->normal, this->normal));
    }
  }
  bool isPlane() const
  {
    return isFinite(this->origin) && isFinite(this->normal) && this->normal != glm::dvec3(0.0);
  }
};

std::vector<WorldPlane> getClippingPlanes(vtkVolumeMapper* mapper)
{
  std::vector<WorldPlane> planes;
  vtkPlaneCollection* collection = mapper->GetClippingPlanes();
  vtkCollectionSimpleIterator place;
  if (collection)
  {
    collection->InitTraversal(place);
    while (vtkPlane* plane = collection->GetNextPlane(place))
    {
      planes.emplace_back(plane);
    }
  }
  return planes;
}

bool isNaN(double number) { return std::isnan(number); }

std::string toText(const glm::dvec3& v)
{
  std::ostringstream text;
  text << "(" << v.x << ", " << v.y << ", " << v.z << ")";
  return text.str();
}

double greatestOf(const glm::dvec3& v)
{
  return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}

// The plane in half cells from the lower corner of the bounds. Scaled on the way, so that its
// squares are in the range of doubles.
glm::dvec4 toHalfCells(
  const WorldPlane& plane, const glm::dmat4& dataToWorld, const BrickedVolume& bricked)
{
  const glm::dvec3 normal = plane.normal / greatestOf(plane.normal);
  const glm::dvec3 corner(dataToWorld * glm::dvec4(bricked.world(glm::dvec3(0.0)), 1.0));
  const glm::dvec3 inHalfCells = 0.5 * bricked.spacing * (normal * glm::dmat3(dataToWorld));
  return glm::dvec4(inHalfCells, glm::dot(normal, corner - plane.origin)) / greatestOf(inHalfCells);
}
}

std::string checkCutaway(vtkVolumeMapper* mapper)
{
  const std::vector<WorldPlane> planes = getClippingPlanes(mapper);
  if (planes.size() > Cutaway::MostClippingPlanes)
  {
    return "expected at most " + std::to_string(Cutaway::MostClippingPlanes) +
      " clipping planes, found " + std::to_string(planes.size()) +
      ". Remove those that cut nothing more off";
  }
  for (const WorldPlane& plane : planes)
  {
    if (!plane.isPlane())
    {
      return "expected clipping planes with finite origins and normals that are not 0, found one "
             "of "
             "origin " +
        toText(plane.origin) + " and normal " + toText(plane.normal) + ". Call its SetNormal()";
    }
  }
  const double* const cropping = mapper->GetCroppingRegionPlanes();
  if (mapper->GetCropping() && std::any_of(cropping, cropping + 6, isNaN))
  {
    return "expected numbers as CroppingRegionPlanes, found " +
      toText({ cropping[0], cropping[2], cropping[4] }) + " to " +
      toText({ cropping[1], cropping[3], cropping[5] }) +
      " with NaN among them. Call SetCroppingRegionPlanes()";
  }
  return {};
}

Cutaway makeCutaway(vtkVolumeMapper* mapper, vtkVolume* volume, const BrickedVolume& bricked)
{
  Cutaway cutaway;
  const glm::dmat4 dataToWorld = toGLM(volume->GetMatrix());
  for (const WorldPlane& plane : getClippingPlanes(mapper))
  {
    cutaway.clippingPlanes.push_back(toHalfCells(plane, dataToWorld, bricked));
  }
  const auto flags = static_cast<std::uint32_t>(mapper->GetCroppingRegionFlags());
  if (mapper->GetCropping() && flags != Cropping::AllRegions)
  {
    const double* const planes = mapper->GetCroppingRegionPlanes();
    const auto inHalfCells = [&](const glm::dvec3& place)
    { return 2.0 * (place - bricked.world(glm::dvec3(0.0))) / bricked.spacing; };
    cutaway.cropping = Cropping{ inHalfCells({ planes[0], planes[2], planes[4] }),
      inHalfCells({ planes[1], planes[3], planes[5] }), flags };
  }
  return cutaway;
}

std::string checkSlice(vtkVolume* volume)
{
  vtkImplicitFunction* function = volume->GetProperty()->GetSliceFunction();
  vtkPlane* plane = vtkPlane::SafeDownCast(function);
  if (!plane)
  {
    return "expected a vtkPlane as slice function for blend mode slice, found " +
      (function ? "a " + std::string(function->GetClassName()) : "none") +
      ". Call SetSliceFunction() of the volume property";
  }
  const WorldPlane found(plane);
  return found.isPlane() ? std::string()
                         : "expected a slice function with a finite origin and a normal that is "
                           "not 0, found origin " +
      toText(found.origin) + " and normal " + toText(found.normal) + ". Call its SetNormal()";
}

glm::dvec4 findSlicePlane(vtkVolume* volume, const BrickedVolume& bricked)
{
  vtkPlane* plane = vtkPlane::SafeDownCast(volume->GetProperty()->GetSliceFunction());
  return plane ? toHalfCells(WorldPlane(plane), toGLM(volume->GetMatrix()), bricked)
               : glm::dvec4(0.0, 0.0, 1.0, 0.0);
}
}
