// SPDX-License-Identifier: BSD-3-Clause
// What a pipeline is specialised for (MarchVariant.h): the code of one choice alone is compiled.
layout(constant_id = 0) const uint reconstruction = RECONSTRUCTION_BASIS;
// Rays begin at depths of their own; else at the near plane, and nothing is read.
layout(constant_id = 1) const bool beginsAtDepth = false;

const bool isNearest = reconstruction == RECONSTRUCTION_NEAREST;
const bool isCompleted = reconstruction == RECONSTRUCTION_COMPLETED;
