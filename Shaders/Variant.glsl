// SPDX-License-Identifier: BSD-3-Clause
// What a pipeline is specialised for (MarchVariant.h): the code of one choice alone is compiled.
layout(constant_id = 0) const uint reconstruction = RECONSTRUCTION_BASIS;
// Rays begin at depths of their own; else at the near plane, and nothing is read.
layout(constant_id = 1) const bool beginsAtDepth = false;
// Pixels are taken by a counter, in place of being dealt out with the groups: for drivers that deal
// each thread one run of groups, as those of CPUs do, of which one may cost much more than another.
layout(constant_id = 2) const bool takesPixels = false;
// Clipping planes shorten the rays.
layout(constant_id = 3) const bool clipped = false;
// Cropping leaves several pieces of a ray.
layout(constant_id = 4) const bool cropped = false;
// How what lies along the ray becomes a colour (Blend.glsl).
layout(constant_id = 5) const uint blending = BLENDING_COMPOSITE;
// The rest of what is seen is lit, and less opaque where the field changes little.
layout(constant_id = 8) const bool isShaded = false;
layout(constant_id = 9) const bool hasGradientOpacity = false;

const bool isNearest = reconstruction == RECONSTRUCTION_NEAREST;
const bool isCompleted = reconstruction == RECONSTRUCTION_COMPLETED;
const bool isComposite = blending == BLENDING_COMPOSITE;
const bool isExtremum = blending == BLENDING_MAXIMUM || blending == BLENDING_MINIMUM;
const bool isIsosurface = blending == BLENDING_ISOSURFACE;
// At each sample; surfaces have theirs.
const bool needsGradient = (isShaded || hasGradientOpacity) && !isIsosurface;
