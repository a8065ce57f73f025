// SPDX-License-Identifier: BSD-3-Clause
// What tells how large data are and which values have which color: axes around the bounds, and a
// scalar bar.

#ifndef ExaBricksRenderAnnotation_h
#define ExaBricksRenderAnnotation_h

#include <string>

class vtkRenderer;
class vtkScalarsToColors;

namespace render
{

// title: of the scalar bar.
void annotate(vtkRenderer* renderer, const double bounds[6], vtkScalarsToColors* colors,
  const std::string& title);

}

#endif
