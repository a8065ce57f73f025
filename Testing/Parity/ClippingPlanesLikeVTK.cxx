// SPDX-License-Identifier: BSD-3-Clause
// Clipping planes leave the same of a volume as with VTK's mappers.

#include "Parity.h"

#include "vtkPlane.h"
#include "vtkTransform.h"

int ClippingPlanesLikeVTK(int, char*[])
{
  test::Checks checks;
  test::KeepDisplay display;
  parity::Mappers mappers({ { 24, 24, 24 }, {}, parity::ball });
  mappers.ShowBall();
  const test::Picture whole = mappers.Draw(mappers.mapper);

  const auto addPlane = [&](
                          const std::array<double, 3>& origin, const std::array<double, 3>& normal)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(origin[0], origin[1], origin[2]);
    plane->SetNormal(normal[0], normal[1], normal[2]);
    mappers.ForEach([&](vtkVolumeMapper* mapper) { mapper->AddClippingPlane(plane); });
  };

  mappers.ExpectSame(checks, "no plane");
  addPlane({ 12.3, 0.0, 0.0 }, { 1.0, 0.0, 0.0 });
  mappers.ExpectSame(checks, "one plane");
  addPlane({ 12.0, 12.0, 13.1 }, { 0.5, 0.7, -1.0 });
  mappers.ExpectSame(checks, "two planes");
  checks.Expect(whole.Decibel(mappers.Draw(mappers.mapper)) < 25.0, "they cut something off");

  // They are in world coordinates, so that the volume moves below them.
  vtkNew<vtkTransform> transform;
  transform->Translate(12.0, 12.0, 12.0);
  transform->RotateWXYZ(40.0, 1.0, 2.0, 3.0);
  transform->Translate(-10.0, -14.0, -11.0);
  mappers.volume->SetUserMatrix(transform->GetMatrix());
  mappers.ExpectSame(checks, "a moved volume");
  mappers.volume->SetUserMatrix(nullptr);
  mappers.ForEach([](vtkVolumeMapper* mapper) { mapper->RemoveAllClippingPlanes(); });

  for (int axis = 0; axis < 3; ++axis)
  {
    std::array<double, 3> normal{ 0.3, -0.2, 0.1 };
    normal[axis] = 1.0;
    addPlane({ 6.0, 7.0, 6.5 }, normal);
    addPlane({ 17.0, 16.0, 18.5 }, { -normal[0], -normal[1], -normal[2] });
  }
  mappers.ExpectSame(checks, "six planes");

  // Cells of another shape.
  test::Lattice lattice;
  lattice.spacing = { 1.0, 0.5, 2.0 };
  parity::Mappers stretched({ { 24, 48, 12 }, lattice, parity::ball });
  stretched.ShowBall();
  stretched.ForEach([&](vtkVolumeMapper* mapper)
    { mapper->SetClippingPlanes(mappers.mapper->GetClippingPlanes()); });
  stretched.ExpectSame(checks, "cells of another shape");
  return checks.Status();
}
