// SPDX-License-Identifier: BSD-3-Clause
// Shading and opacity by the gradient (Core/Lighting.h).

// The piece of a ray that is shaded as one.
struct Spot
{
  vec3 gradient;  // by half cells
  vec2 values;    // of what has that gradient, where the piece begins and ends
  float width;    // of a cell there, in finest cells
  vec3 place;     // of its middle, half cells
  vec3 direction; // of the ray
#ifdef FAMILY_SCATTERING
  Ray ray; // and where on it and in which bricks the middle is
  float distance;
  Brick brick;
  uint others;
#endif
};

Spot spotAt(Ray ray, Brick brick, uint others, float distance, vec2 values, vec3 gradient)
{
  Spot spot;
  spot.values = values;
  spot.gradient = gradient;
  spot.width = float(brick.width);
  spot.place = vec3(ray.base) + (ray.fraction + distance * ray.direction);
  spot.direction = ray.direction;
#ifdef FAMILY_SCATTERING
  spot.ray = ray;
  spot.distance = distance;
  spot.brick = brick;
  spot.others = others;
#endif
  return spot;
}

float shareOfLight(Spot spot, uint light)
{
#ifdef FAMILY_SCATTERING
  if (constants.frame.shadowReach > 0.0)
  {
    return shareOfLight(spot.brick, spot.others, spot.ray, spot.distance, light);
  }
#endif
  return 1.0;
}

vec3 toWorld(vec3 halfCells)
{
  return constants.frame.halfCellsToWorldX * halfCells.x +
    constants.frame.halfCellsToWorldY * halfCells.y +
    constants.frame.halfCellsToWorldZ * halfCells.z;
}

float opacityIn(TransferPart part) { return mix(part.lower.a, part.upper.a, part.fraction); }

// Where opacity, by the function that is selected, is greater: where values are greater (1), where they
// are less (-1), or nowhere. In the middle of a piece, or where it is level there, over all of the piece,
// on which there may be a jump.
float sideOfOpacity(vec2 values)
{
  const TransferPart part = findPart(0.5 * (values.x + values.y));
  const float slope = part.upper.a - part.lower.a;
  if (slope != 0.0)
  {
    return sign(slope);
  }
  const float first = opacityIn(findPart(values.x));
  const float last = opacityIn(findPart(values.y));
  const bool isLevel = abs(last - first) < 1e-4 * max(first, last); // but for rounding
  return isLevel ? 0.0 : sign(values.y - values.x) * sign(last - first);
}

// Against the gradient, of values or of opacity, of length 1; or 0, where the field changes by no more
// than rounding.
vec3 normalAt(Spot spot)
{
  const vec3 normal = constants.frame.gradientToWorldX * spot.gradient.x +
    constants.frame.gradientToWorldY * spot.gradient.y +
    constants.frame.gradientToWorldZ * spot.gradient.z;
  const float change = length(spot.gradient) * spot.width;
  const float side = hasNormalsOfOpacity ? sideOfOpacity(spot.values) : 1.0;
  return change > 1e-6 ? -side * normalize(normal) : vec3(0.0);
}

// What reaches a place of a light, and `toLight`, the direction in which it is.
float attenuate(Light light, vec3 place, out vec3 toLight)
{
  toLight = -light.direction;
  if (light.positional == 0u)
  {
    return 1.0;
  }
  const vec3 path = place - light.position;
  const float distance = length(path);
  toLight = -path / distance;
  const float attenuation =
    1.0 / dot(light.attenuation, vec3(1.0, distance, distance * distance));
  if (light.cosineOfCone < 0.0)
  {
    return attenuation;
  }
  const float cosine = -dot(toLight, light.direction);
  return cosine >= light.cosineOfCone ? attenuation * pow(cosine, light.exponent) : 0.0;
}

// How much a light shines into the eye from a normal that it reaches at a cosine.
float shineOf(float cosine, vec3 normal, vec3 toLight, vec3 view, float power)
{
  const float shine = dot(2.0 * cosine * normal - toLight, view);
  return shine > 0.0 ? pow(shine, power) : 0.0;
}

// How much of the light that a medium scatters goes in a direction at a cosine from the light's own; all
// alike: 1 (Henyey and Greenstein, "Diffuse radiation in the galaxy", 1941).
float phaseOf(float cosine)
{
  const float g = constants.frame.scatteringAnisotropy;
  const float d = 1.0 + g * g - 2.0 * g * clamp(cosine, -1.0, 1.0);
  return abs(g) < 0.01 ? 1.0 : (1.0 - g * g) / (d * sqrt(d));
}

// How much of what is seen of a place is scattered by a medium, and not reflected by a surface, which is
// likelier where the field changes and the unit distance's opacity is great: as VTK's GPU mapper has it.
float shareOfScattering(bool changes, float opacity)
{
  const float blending = constants.frame.scatteringBlending;
  const float medium = exp(changes ? -blending * opacity : 0.0);
  return blending < 1.0 ? blending * medium : (2.0 - blending) * medium + blending - 1.0;
}

// The opacity of the unit distance, of that of a piece of so many.
float opacityOfUnit(float opacity, float units)
{
  return !isScattering || opacity >= 1.0 ? 1.0 : 1.0 - pow(1.0 - opacity, 1.0 / units);
}

// Premultiplied colour and opacity, as they are lit, of the material of a component. `opacity`: of the
// unit distance.
vec4 shade(vec4 color, float opacity, Spot spot, uint component)
{
  const Material material = constants.frame.materials[component];
  const vec3 normal = normalAt(spot);
  const vec3 view = -normalize(toWorld(spot.direction));
  const vec3 place = toWorld(spot.place);
  vec3 diffuse = vec3(0.0);
  vec3 specular = vec3(0.0);
  vec3 scattered = vec3(0.0);
  for (uint i = 0u; i < constants.frame.lightCount; ++i)
  {
    const Light light = constants.frame.lights[i];
    vec3 toLight;
    const float reaching = attenuate(light, place, toLight);
    const float cosine = dot(normal, toLight);
    const float lit = constants.frame.twoSided != 0u ? abs(cosine) : max(cosine, 0.0);
    diffuse += light.diffuse * (reaching * lit);
    if (lit > 0.0)
    {
      specular += light.specular * (reaching * shineOf(cosine, normal, toLight, view, material.specularPower));
    }
    if (isScattering)
    {
      scattered +=
        light.diffuse * (reaching * phaseOf(-dot(toLight, view)) * shareOfLight(spot, i));
    }
  }
  const vec3 surface = color.rgb * (material.ambient + material.diffuse * diffuse) +
    color.a * material.specular * specular;
  if (!isScattering)
  {
    return vec4(surface, color.a);
  }
  const vec3 medium = color.rgb * (material.ambient + material.diffuse * scattered);
  return vec4(
    mix(surface, medium, shareOfScattering(normal != vec3(0.0), opacity)), color.a);
}

// A gradient's magnitude, as a part of the greatest one.
float shareOfGradient(vec3 gradient)
{
  return clamp(
    length(gradient * constants.frame.gradientToMagnitude) / GREATEST_GRADIENT, 0.0, 1.0);
}

// By what the extinction is multiplied, by the function of that number. Its table goes evenly from a gradient of nothing to
// GREATEST_GRADIENT.
float opacityOfGradient(Spot spot, uint number)
{
  const float x = shareOfGradient(spot.gradient) * float(GRADIENT_OPACITIES - 1u);
  const float whole = min(floor(x), float(GRADIENT_OPACITIES - 2u));
  const uint i = min(toIndex(whole), GRADIENT_OPACITIES - 2u);
  Values table = Values(constants.frame.gradientOpacity);
  const uint at = number * GRADIENT_OPACITIES + i;
  return mix(table.items[at], table.items[at + 1u], x - whole);
}
