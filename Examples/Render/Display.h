// SPDX-License-Identifier: BSD-3-Clause
// The window that is drawn in, off screen.

#ifndef ExaBricksRenderDisplay_h
#define ExaBricksRenderDisplay_h

#include "vtkSmartPointer.h"

class vtkRenderWindow;

namespace render
{

// Throws Failure(RenderingFailed) where VTK would abort the program: it needs an X server and there
// is none.
vtkSmartPointer<vtkRenderWindow> makeWindow();

}

#endif
