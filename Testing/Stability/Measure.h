// SPDX-License-Identifier: BSD-3-Clause
// Draws a setting with our renderer, through VTK's objects and the module's adapters but without a
// window; and says how far the picture is from what it ought to be.
#ifndef ExaBricksStabilityMeasure_h
#define ExaBricksStabilityMeasure_h

#include "Case.h"

#include "Adapters/BrickedVolume.h"
#include "Vulkan/VolumeRenderer.h"

#include "vtkNew.h"

class vtkCamera;
class vtkVolume;
class vtkVolumeProperty;

namespace exabricks
{
namespace stability
{
// The setting's objects for a scene of VTK.
void setCamera(const Setting& setting, vtkCamera* camera);
void setProperty(const Setting& setting, vtkVolumeProperty* property);
void setMatrix(const Setting& setting, vtkVolume* volume);

/// One for each way to draw, for all subjects, as pipelines take long to compile. To be destroyed
/// before the program ends: Vulkan's layers may be gone then.
class Renderers
{
public:
  VolumeRenderer& get(Reconstruction reconstruction, Traversal traversal);

private:
  VolumeRenderer All[2][2];
};

class Subject
{
public:
  explicit Subject(Setting setting);
  ~Subject();

  const Setting& setting() const { return this->Given; }
  const BrickedVolume& bricked() const { return *this->Bricked; }

  /// Pictures that are right: several where a ray may take either side of a face.
  std::vector<reference::Image> truths(Reconstruction reconstruction) const;

  /// Throws what the renderer says is wrong.
  reference::Image draw(
    Renderers& renderers, Reconstruction reconstruction, Traversal traversal) const;

private:
  void Build();
  reference::Oracle MakeOracle() const;
  std::vector<reference::View> Views(Reconstruction reconstruction) const;

  const Setting Given;
  std::shared_ptr<const BrickedVolume> Bricked;
};

struct Errors
{
  double all = 0.0;      // PSNR over all pixels, dB; infinite for equal pictures
  double drawn = 0.0;    // over those that either picture shows something in
  double greatest = 0.0; // difference in any channel of any pixel
  double coverage = 0.0; // share of the pixels that the truth shows something in
};

/// Each pixel against that of the nearest truth. A value that is not finite is infinitely wrong.
/// `channels`: 4, or 3 without opacity.
Errors compare(
  const reference::Image& picture, const std::vector<reference::Image>& truths, int channels = 4);
}
}

#endif
