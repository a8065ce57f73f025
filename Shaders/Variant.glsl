// SPDX-License-Identifier: BSD-3-Clause
// What a pipeline is specialised for (MarchVariant.h): the code of one choice alone is compiled.
// Drivers take long to drop what is not chosen, so that there is a module for each of five families:
// FAMILY_PROJECTION, FAMILY_SURFACE, FAMILY_COMPOSITE, FAMILY_COMPONENTS, and in the most frequent
// one, which has no name, what is emitted and absorbed alone.
layout(constant_id = 0) const uint reconstruction = RECONSTRUCTION_BASIS;
// Rays begin at depths of their own; else at the near plane, and nothing is read.
layout(constant_id = 1) const bool beginsAtDepth = false;
// Pixels are taken by a counter, in place of being dealt out with the groups: for drivers that deal
// each thread one run of groups, as those of CPUs do, of which one may cost much more than another.
layout(constant_id = 2) const bool takesPixels = false;
#if defined(FAMILY_PROJECTION) || defined(FAMILY_SURFACE) || defined(FAMILY_COMPOSITE) ||           \
  defined(FAMILY_COMPONENTS)
// Clipping planes shorten the rays.
layout(constant_id = 3) const bool clipped = false;
// Cropping leaves several pieces of a ray.
layout(constant_id = 4) const bool cropped = false;
// Each pixel's samples lie elsewhere in a region, so that what steps leave out is noise and no bands.
layout(constant_id = 10) const bool jittered = false;
// A box of the bounds alone is drawn: the part of one of several processes.
layout(constant_id = 12) const bool isPart = false;
#else
const bool clipped = false;
const bool cropped = false;
const bool jittered = false;
const bool isPart = false;
#endif
// How what lies along the ray becomes a colour (Blend.glsl).
#if defined(FAMILY_PROJECTION)
layout(constant_id = 5) const uint blending = BLENDING_MAXIMUM;
const bool isComposite = false;
const bool isIsosurface = false;
#elif defined(FAMILY_COMPONENTS)
layout(constant_id = 5) const uint blending = BLENDING_COMPOSITE;
const bool isComposite = blending == BLENDING_COMPOSITE;
const bool isIsosurface = false;
#elif defined(FAMILY_SURFACE)
layout(constant_id = 5) const uint blending = BLENDING_ISOSURFACE;
const bool isComposite = false;
const bool isIsosurface = blending == BLENDING_ISOSURFACE;
#else
const uint blending = BLENDING_COMPOSITE;
const bool isComposite = true;
const bool isIsosurface = false;
#endif
const bool isExtremum = blending == BLENDING_MAXIMUM || blending == BLENDING_MINIMUM;
const bool isSlice = blending == BLENDING_SLICE;
// The rest of what is seen is lit, and less opaque where the field changes little.
#if defined(FAMILY_SURFACE) || defined(FAMILY_COMPOSITE) || defined(FAMILY_COMPONENTS)
layout(constant_id = 8) const bool isShaded = false;
#else
const bool isShaded = false;
#endif
#if defined(FAMILY_SURFACE) || defined(FAMILY_COMPOSITE) || defined(FAMILY_COMPONENTS)
layout(constant_id = 9) const bool hasGradientOpacity = false;
#else
const bool hasGradientOpacity = false;
#endif
// Normals are those of opacity; of functions of two variables, and of surfaces of a component that
// has none, still those of values.
#if defined(FAMILY_SURFACE) || defined(FAMILY_COMPOSITE) || defined(FAMILY_COMPONENTS)
layout(constant_id = 14) const bool asksForNormalsOfOpacity = false;
#else
const bool asksForNormalsOfOpacity = false;
#endif
// What is lit scatters light beside, as a medium does.
#if defined(FAMILY_COMPOSITE) || defined(FAMILY_COMPONENTS)
#define FAMILY_SCATTERING
layout(constant_id = 13) const bool isScattering = false;
#else
const bool isScattering = false;
#endif
// Cells whose value is undefined have a colour; else they are absent.
#if defined(FAMILY_COMPOSITE) || defined(FAMILY_SURFACE)
layout(constant_id = 11) const bool showsUndefined = false;
#else
const bool showsUndefined = false;
#endif

// Of each cell's values, and how they make one medium.
#if defined(FAMILY_COMPONENTS) || defined(FAMILY_SURFACE)
layout(constant_id = 6) const uint componentCount = 2u;
layout(constant_id = 7) const uint mixing = MIXING_INDEPENDENT;
#else
const uint componentCount = 1u;
const uint mixing = MIXING_INDEPENDENT;
#endif

const bool hasNormalsOfOpacity =
  asksForNormalsOfOpacity && mixing != MIXING_PLANAR && (!isIsosurface || mixing == MIXING_INDEPENDENT);
const bool isNearest = reconstruction == RECONSTRUCTION_NEAREST;
const bool isCompleted = reconstruction == RECONSTRUCTION_COMPLETED;
// A function of two variables, of which the second one is the gradient's magnitude.
const bool mapsGradient = mixing == MIXING_PLANAR && componentCount == 1u;
// At each sample; surfaces have theirs.
const bool needsGradient = (isShaded || hasGradientOpacity || mapsGradient) && !isIsosurface;
