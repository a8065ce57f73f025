// SPDX-License-Identifier: BSD-3-Clause
// How a volume is lit: Phong's model, on normals against the gradient of the field, and light that
// its medium scatters and keeps from what is behind.
#ifndef ExaBricksCoreLighting_h
#define ExaBricksCoreLighting_h

#include "Layout.h"

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace exabricks
{
/// In world coordinates, counted from the place of the lower corner of the data's bounds.
struct Light
{
  glm::dvec3 direction{ 0.0, 0.0, -1.0 }; // in which it shines, of length 1
  glm::dvec3 diffuse{ 1.0 };              // colour times intensity
  glm::dvec3 specular{ 1.0 };
  // What follows counts where it has a position.
  bool positional = false;
  glm::dvec3 position{ 0.0 };
  glm::dvec3 attenuation{ 1.0, 0.0, 0.0 }; // 1 / (x + y d + z d^2) at distance d
  double coneAngle = 90.0;                 // degrees from the axis; above 90: in all directions
  double exponent = 1.0;                   // of the cosine from the axis, in a cone
};

inline bool operator==(const Light& a, const Light& b)
{
  return a.direction == b.direction && a.diffuse == b.diffuse && a.specular == b.specular &&
    a.positional == b.positional && a.position == b.position && a.attenuation == b.attenuation &&
    a.coneAngle == b.coneAngle && a.exponent == b.exponent;
}

struct Material
{
  double ambient = 0.1; // times the colour
  double diffuse = 0.7; // times the colour
  double specular = 0.2;
  double specularPower = 10.0;
};

inline bool operator==(const Material& a, const Material& b)
{
  return a.ambient == b.ambient && a.diffuse == b.diffuse && a.specular == b.specular &&
    a.specularPower == b.specularPower;
}

/// Of light that comes through the medium and is scattered once.
struct Scattering
{
  /// In [0, 2]: up to 1 the part of it grows that is seen in place of what Phong's model reflects,
  /// where the field changes little or is thin, above 1 elsewhere too; of 2 it is all.
  double blending = 1.0;
  double anisotropy = 0.0; // Henyey and Greenstein's, in (-1, 1); above 0: onwards
  double reach = 0.0; // in [0, 1], how far shadows fall: 0 none do, 1 through all of the bounds
};

inline bool operator==(const Scattering& a, const Scattering& b)
{
  return a.blending == b.blending && a.anisotropy == b.anisotropy && a.reach == b.reach;
}

struct Lighting
{
  /// Of each independent component; of one, and of dependent ones, the first.
  std::array<Material, layout::MOST_COMPONENTS> materials;
  bool twoSided = true; // light from behind counts as much
  /// Normals are against the gradient of opacity, not of values: where it falls as values rise they
  /// are turned, and where it does not change there are none. Of one variable, which has opacity.
  bool normalsOfOpacity = false;
  std::vector<Light> lights;
  glm::dmat3 dataToWorld{ 1.0 };        // linear
  std::optional<Scattering> scattering; // for Blending::Composite
};

inline bool operator==(const Lighting& a, const Lighting& b)
{
  return a.materials == b.materials && a.twoSided == b.twoSided && a.lights == b.lights &&
    a.normalsOfOpacity == b.normalsOfOpacity && a.dataToWorld == b.dataToWorld &&
    a.scattering == b.scattering;
}
}

#endif
