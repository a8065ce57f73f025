// SPDX-License-Identifier: BSD-3-Clause
// The next piece of the region that the ray is in.
void marchOn(Ray ray, inout Cursor cursor, inout Accumulator gathered)
{
#if defined(FAMILY_COMPONENTS)
  marchComponents(ray, cursor, gathered);
#else
#if defined(FAMILY_SURFACE)
  if (isSlice)
  {
    marchSlice(ray, cursor, gathered);
    return;
  }
  if (isIsosurface)
  {
    marchSurfaces(ray, cursor, gathered);
    return;
  }
#endif
  if (isNearest)
  {
    marchCell(ray, cursor, gathered);
  }
  else
  {
    marchInterval(ray, cursor, gathered);
  }
#endif
}
