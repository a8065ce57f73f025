// SPDX-License-Identifier: BSD-3-Clause
// The renderers whose last picture has a mapper's volume in it. VTK does not call the mapper for
// pictures without its volume, so each renderer's own events tell that there is a new one.
#ifndef ExaBricksAdaptersDrawnRenderers_h
#define ExaBricksAdaptersDrawnRenderers_h

#include <map>

#include "vtkNew.h"

class vtkCallbackCommand;
class vtkObject;
class vtkRenderer;

namespace exabricks
{
class DrawnRenderers
{
public:
  DrawnRenderers();
  ~DrawnRenderers();
  DrawnRenderers(const DrawnRenderers&) = delete;
  void operator=(const DrawnRenderers&) = delete;

  /// Whether the volume is in the picture that `ren` is drawing.
  void set(vtkRenderer* ren, bool drawn);
  /// Whether it is in the last picture of `ren`, as far as that was drawn.
  bool is(vtkRenderer* ren) const;
  /// Whether any of the renderers shows the volume.
  bool any() const;

private:
  static void OnEvent(vtkObject* caller, unsigned long event, void* self, void*);

  vtkNew<vtkCallbackCommand> Command;
  std::map<vtkRenderer*, bool> Drawn; // [renderer that is observed]
};
}

#endif
