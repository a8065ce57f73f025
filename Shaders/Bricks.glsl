// SPDX-License-Identifier: BSD-3-Clause
// Lists of bricks, and where the values of a brick's cells are.

Brick readBrick(uint index)
{
  const uint at = BRICK_WORDS * index;
  const uvec2 first = unpackWord(bricks.words[at]);
  const uvec2 second = unpackWord(bricks.words[at + 1u]);
  Brick brick;
  brick.lo = ivec3(first, second.x);
  brick.width = int(second.y);
  const uvec2 third = unpackWord(bricks.words[at + 2u]);
  brick.dimensions = third.x;
  brick.number = third.y;
  brick.values = bricks.words[at + 3u];
  return brick;
}

// The brick at a place in the lists. The place comes back as that of the next one of the list, or as 0
// after the last one, which no list goes on from.
Brick nextBrick(inout uint place)
{
  const uint entry = brickLists.items[place];
  place = (entry & LAST_BRICK) == 0u ? place + 1u : 0u;
  return readBrick(entry & ~LAST_BRICK);
}

uvec3 cellsOf(Brick brick)
{
  return uvec3(brick.dimensions, brick.dimensions >> 8, brick.dimensions >> 16) & 0xffu;
}

// The ray's point at `distance`, in cells from the brick's lower corner.
vec3 toCells(Brick brick, Ray ray, float distance)
{
  return (vec3(ray.base - brick.lo) + (ray.fraction + distance * ray.direction)) *
    (0.5 / float(brick.width));
}

// Where the value of a cell is. Completed bricks have a layer of one more around them, from -1 on.
uint placeOf(uvec3 n, ivec3 cell)
{
  const uint layer = isCompleted ? 1u : 0u;
  const uvec3 at = uvec3(cell + int(layer));
  const uvec3 size = n + 2u * layer;
  return at.x + size.x * (at.y + size.y * at.z);
}

// A component of the cell at a place.
float readValue(Values values, uint at, uint component)
{
  return values.items[componentCount == 1u ? at : componentCount * at + component];
}

float valueAt(Brick brick, uvec3 n, uvec3 cell, uint component)
{
  return readValue(Values(brick.values), placeOf(n, ivec3(cell)), component);
}
