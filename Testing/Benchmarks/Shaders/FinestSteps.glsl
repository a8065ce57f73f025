// SPDX-License-Identifier: BSD-3-Clause
// In place of enterRegion: as if the finest cells of all, two half cells wide, were in every region.
void enterRegion(Ray ray, uint firstBrick, float step, float growth, float entry, float exit,
  inout Cursor cursor)
{
  enterRegionByItsCells(ray, firstBrick, step < 0.0 ? -2.0 : 2.0, growth, entry, exit, cursor);
}
