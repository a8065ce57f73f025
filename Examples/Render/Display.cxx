// SPDX-License-Identifier: BSD-3-Clause

#include "Display.h"

#include "Messages.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"

#include <cstdlib>
#include <string>

#ifdef EXABRICKS_RENDER_HAS_X11
#include <X11/Xlib.h>
#endif

namespace render
{

namespace
{

bool xServerAnswers()
{
#ifdef EXABRICKS_RENDER_HAS_X11
  // Stays open: an X server whose last client leaves starts anew, and VTK aborts if it comes
  // meanwhile.
  static const Display* const display = XOpenDisplay(nullptr);
  return display != nullptr;
#else
  const char* name = std::getenv("DISPLAY");
  return name && *name;
#endif
}

// Before 9.4 VTK aborts the program after an error of the window, such as an X server without GLX.
void throwError(vtkObject* window, unsigned long, void*, void* message)
{
  const std::string text = textOf(static_cast<const char*>(message));
  const bool onXServer = std::string(window->GetClassName()) == "vtkXOpenGLRenderWindow";
  throw Failure(ExitCode::RenderingFailed,
    onXServer ? "VTK cannot draw with this X server: " + text +
        ". Use one that has GLX, or xvfb-run, as in xvfb-run -a exabricks-render ..."
              : "VTK cannot draw: " + text);
}

}

vtkSmartPointer<vtkRenderWindow> makeWindow()
{
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  // From 9.4 on VTK makes a window of another class by itself where no X server answers.
  if (std::string(window->GetClassName()) == "vtkXOpenGLRenderWindow" && !xServerAnswers())
  {
    const char* name = std::getenv("DISPLAY");
    throw Failure(ExitCode::RenderingFailed,
      "This version of VTK draws with an X server, off screen too, and none answers (DISPLAY is " +
        (name && *name ? "'" + std::string(name) + "'" : std::string("not set")) +
        "): run it under xvfb-run, as in xvfb-run -a exabricks-render ...");
  }
  vtkNew<vtkCallbackCommand> onError;
  onError->SetCallback(throwError);
  window->AddObserver(vtkCommand::ErrorEvent, onError);
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  return window;
}

}
