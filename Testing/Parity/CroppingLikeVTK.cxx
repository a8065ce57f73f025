// SPDX-License-Identifier: BSD-3-Clause
// Cropping shows the same regions of a volume as with VTK's mappers.

#include "Parity.h"

#include "vtkTransform.h"

int CroppingLikeVTK(int, char*[])
{
  test::Checks checks;
  test::KeepDisplay display;
  parity::Mappers mappers({ { 24, 24, 24 }, {}, parity::ball });
  mappers.ShowBall();

  const auto setFlags = [&](int flags)
  { mappers.ForEach([&](vtkVolumeMapper* mapper) { mapper->SetCroppingRegionFlags(flags); }); };

  mappers.ForEach(
    [](vtkVolumeMapper* mapper)
    {
      mapper->SetCroppingRegionPlanes(7.1, 15.3, 8.2, 17.4, 6.3, 16.6);
      mapper->CroppingOn();
    });
  const std::pair<int, const char*> presets[] = { { VTK_CROP_SUBVOLUME, "subvolume" },
    { VTK_CROP_FENCE, "fence" }, { VTK_CROP_INVERTED_FENCE, "inverted fence" },
    { VTK_CROP_CROSS, "cross" }, { VTK_CROP_INVERTED_CROSS, "inverted cross" },
    { 0x5555555, "every other region" }, { 1 << 22, "region 1, 1, 2" } };
  for (const auto& preset : presets)
  {
    setFlags(preset.first);
    mappers.ExpectSame(checks, preset.second);
  }

  // The planes are in the data's own coordinates, and move with the volume.
  setFlags(VTK_CROP_FENCE);
  const test::Picture still = mappers.Draw(mappers.mapper);
  vtkNew<vtkTransform> transform;
  transform->Translate(12.0, 12.0, 12.0);
  transform->RotateWXYZ(40.0, 1.0, 2.0, 3.0);
  transform->Translate(-10.0, -14.0, -11.0);
  mappers.volume->SetUserMatrix(transform->GetMatrix());
  mappers.ExpectSame(checks, "a moved volume");
  checks.Expect(still.Decibel(mappers.Draw(mappers.mapper)) < 25.0, "it has moved");

  // Cells of another shape.
  test::Lattice lattice;
  lattice.spacing = { 1.0, 0.5, 2.0 };
  parity::Mappers stretched({ { 24, 48, 12 }, lattice, parity::ball });
  stretched.ShowBall();
  stretched.ForEach(
    [](vtkVolumeMapper* mapper)
    {
      mapper->SetCroppingRegionPlanes(7.1, 15.3, 8.2, 17.4, 6.3, 16.6);
      mapper->SetCroppingRegionFlagsToCross();
      mapper->CroppingOn();
    });
  stretched.ExpectSame(checks, "cells of another shape");
  return checks.Status();
}
