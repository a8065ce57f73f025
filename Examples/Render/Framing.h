// SPDX-License-Identifier: BSD-3-Clause
// Where the camera stands.

#ifndef ExaBricksRenderFraming_h
#define ExaBricksRenderFraming_h

#include "Options.h"

class vtkCamera;

namespace render
{

// Sets the camera as the options ask; what they leave open is chosen so that all of the bounds is
// in view. Throws Failure(BadArguments) if the options place it so that it has no direction.
void placeCamera(const Options& options, const double bounds[6], vtkCamera* camera);

}

#endif
