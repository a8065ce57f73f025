// SPDX-License-Identifier: BSD-3-Clause
// One of the passes in which VTK's dual depth peeling renders volumes: once outside the translucent
// geometry, and once between each two layers of it. The pass holds, in textures, between which
// depths each ray of a volume is to be drawn, and tells by code for a volume mapper's shader, in
// which it calls castRay(begin, end) for them. That code runs here, in a shader whose castRay
// returns its arguments. So this class need not know by which rules a version of VTK finds them.
#ifndef ExaBricksAdaptersDepthPeel_h
#define ExaBricksAdaptersDepthPeel_h

#include "Adapters/OpenGLFramebuffer.h"

#include <map>
#include <memory>
#include <string>

#include "vtkOpenGLRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

class vtkAbstractVolumeMapper;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderPass;
class vtkShaderProgram;
class vtkTextureObject;
class vtkVolume;
class vtkWindow;

namespace exabricks
{
/// Between which window depths the rays of a picture are drawn, [height][width]; nothing where the
/// end is not behind the beginning.
struct RayPieces
{
  std::vector<float> begin;
  std::vector<float> end;
  bool any = false; // whether there is something to draw in any pixel
};

class DepthPeel
{
public:
  DepthPeel();
  ~DepthPeel();

  /// Whether a peel renders `volume` at this moment. If so, the other functions concern that peel.
  bool begin(vtkAbstractVolumeMapper* mapper, vtkVolume* volume);

  /// Reads the pieces of rays behind what is peeled, and those before it. False if OpenGL refuses.
  bool readPieces(
    vtkOpenGLRenderWindow* window, const Viewport& viewport, RayPieces& back, RayPieces& front);

  /// Sets the textures of VTK's pass in a program.
  void setParameters(vtkShaderProgram* program) const;
  /// Whether the colours before what is peeled go on from those of the last peel.
  bool continuesFront() const { return this->Continues; }
  /// Whether it is the first one of a picture.
  bool isFirst() const { return this->First; }

  /// May be called twice, and with a window that is going away.
  void release(vtkWindow* window);

private:
  vtkOpenGLQuadHelper* MakeShader(vtkOpenGLRenderWindow* window);

  vtkOpenGLRenderPass* Pass = nullptr;
  vtkAbstractVolumeMapper* Mapper = nullptr;
  vtkVolume* Volume = nullptr;
  bool Continues = false;
  bool First = false;

  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // the one that the rest was made for
  std::map<std::string, std::unique_ptr<vtkOpenGLQuadHelper>> Shaders; // by source
  vtkSmartPointer<vtkTextureObject> Targets[2];
  vtkSmartPointer<vtkTextureObject> Nothing;
};
}

#endif
