// SPDX-License-Identifier: BSD-3-Clause
// From a pixel to the line that is seen through it, in half cells and in double precision: cameras
// may be far away, and lattices large.

struct Line
{
  dvec3 origin;
  dvec3 direction; // of length 1
  double extent;   // from the one window depth to the other
  float dataPerHalfCell; // length of a step of length 1 in the data's coordinates
};

// Of a window depth in [0, 1], as a depth buffer holds it, in normalised device coordinates.
double ndcDepth(Values depth, uvec2 pixel, uint width)
{
  return 2.0LF * double(depth.items[pixel.y * width + pixel.x]) - 1.0LF;
}

// The line between two depths in normalised device coordinates, from `near` on. False: it has no
// length.
bool findLine(FrameBuffer f, uvec2 pixel, double near, double far, out Line line)
{
  const dvec2 ndc = 2.0LF * (dvec2(pixel) + 0.5LF) / dvec2(f.frame.width, f.frame.height) - 1.0LF;
  const dvec4 a = f.frame.ndcToHalfCells * dvec4(ndc, near, 1.0LF);
  const dvec4 b = f.frame.ndcToHalfCells * dvec4(ndc, far, 1.0LF);
  const dvec4 dataA = f.frame.ndcToData * dvec4(ndc, near, 1.0LF);
  const dvec4 dataB = f.frame.ndcToData * dvec4(ndc, far, 1.0LF);
  line.origin = a.xyz / a.w;
  const dvec3 path = b.xyz / b.w - line.origin;
  line.extent = length(path);
  if (!(line.extent > 0.0LF) || isinf(line.extent))
  {
    return false;
  }
  const dvec3 direction = path / line.extent;
  // No component is 0, so that every distance is finite.
  line.direction =
    mix(direction, mix(dvec3(-1e-12LF), dvec3(1e-12LF), greaterThanEqual(direction, dvec3(0.0LF))),
      lessThan(abs(direction), dvec3(1e-12LF)));
  line.dataPerHalfCell =
    float(length(dataB.xyz / dataB.w - dataA.xyz / dataA.w) / line.extent);
  return true;
}
