// SPDX-License-Identifier: BSD-3-Clause
// The way from the centre of a cell to a light, as far as anything on it casts shadows.

// The cell of a number, of those of shadowed bricks, layers of completed ones included: where it is in
// its brick, and as the place of its value.
uint findShadowedCell(FrameBuffer f, uint number, out Brick brick, out ivec3 cell)
{
  ShadowedBricks all = ShadowedBricks(f.frame.shadowedBricks);
  uint first = 0u;
  for (uint count = f.frame.shadowedBrickCount; count > 1u;)
  {
    const uint middle = count / 2u;
    const bool behind = all.items[first + middle].firstCell <= number;
    first += behind ? middle : 0u;
    count = behind ? count - middle : middle;
  }
  const ShadowedBrick found = all.items[first];
  brick = readBrick(found.brick);
  const uint layer = isCompleted ? 1u : 0u;
  const uvec3 size = cellsOf(brick) + 2u * layer;
  const uint at = number - found.firstCell;
  cell = ivec3(at % size.x, at / size.x % size.y, at / (size.x * size.y)) - int(layer);
  return at;
}

// `place`: numbers of the cell and of the light. `begin`: of no use. False: nothing is on the way.
bool findWay(FrameBuffer f, uvec2 place, out Line line, out Pair begin, out Pair end)
{
  Brick brick;
  ivec3 cell;
  findShadowedCell(f, place.x, brick, cell);
  // Layers of completed bricks may lie outside.
  const ivec3 centre = clamp(brick.lo + brick.width * (2 * cell + 1), ivec3(0), f.frame.size);
  const Light light = f.frame.lights[place.y];
  const vec3 path = light.positional != 0u ? light.inHalfCells - vec3(centre) : light.inHalfCells;
  // Of any length that floats hold.
  const vec3 size = abs(path);
  const float largest = max(size.x, max(size.y, size.z));
  const float far = largest * length(path / largest);
  line.origin = Pair3(vec3(centre), vec3(centre - ivec3(vec3(centre))));
  line.direction = withoutZeros(Pair3(normalize(path / largest), vec3(0.0)));
  line.unitsPerHalfCell = unitsAlong(f, line.direction.high);
  begin = makePair(0.0);
  const float reach = f.frame.shadowReach / length(line.direction.high / vec3(f.frame.size));
  end = makePair(light.positional != 0u ? min(reach, far) : reach);
  line.extent = end;
  line.firstW = makePair(1.0);
  line.secondW = makePair(1.0);
  return far > 0.0;
}
