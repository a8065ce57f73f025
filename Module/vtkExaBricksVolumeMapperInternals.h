// SPDX-License-Identifier: BSD-3-Clause
// The steps of a picture by vtkExaBricksVolumeMapper, in their order, and what the mapper keeps
// from one picture to the next.
#ifndef vtkExaBricksVolumeMapperInternals_h
#define vtkExaBricksVolumeMapperInternals_h

#include "Adapters/BrickedVolume.h"
#include "Adapters/Compositor.h"
#include "Adapters/DrawnRenderers.h"
#include "Adapters/ImageOutput.h"
#include "Adapters/PropertyInput.h"
#include "Core/InteractiveSampling.h"
#include "Vulkan/VolumeRenderer.h"
#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksVolumeMapper.h"

#include "vtkSmartPointer.h"

#include <set>

class vtkVolumeProperty;

struct vtkExaBricksVolumeMapper::vtkInternals
{
  vtkSmartPointer<vtkExaBricksBuilder> Builder = vtkSmartPointer<vtkExaBricksBuilder>::New();
  exabricks::VolumeRenderer Renderer;
  exabricks::Compositor Compositor;
  exabricks::ImageOutput Images; // of RenderToImage
  exabricks::DrawnRenderers Drawn;
  // In the picture of a volume that overlaps the one that this mapper draws.
  exabricks::DrawnRenderers DrawnWithOther;

  // What the renderer was last given.
  std::shared_ptr<const exabricks::BrickedVolume> Bricked;
  struct
  {
    std::shared_ptr<const exabricks::BrickedVolume> of;
    std::shared_ptr<const exabricks::BrickedVolume> alone;
  } Surfaces;             // of one of several components
  bool Completed = false; // whether its levels were completed
  bool Planar = false;    // whether it has the property's 2-D function
  exabricks::ColorsOf Colors = exabricks::ColorsOf::Values;
  vtkVolumeProperty* Property = nullptr; // compared only, never followed
  vtkMTimeType PropertyTime = 0;

  bool ReconstructionChosen = false;

  exabricks::InteractiveSampling Interactive;
  // What the passes of a picture around translucent geometry took so far, seconds.
  double RaysOfPasses = 0.0; // of one of them
  double MarchingOfPasses = 0.0;
  double OtherOfPasses = 0.0;
  vtkMTimeType InteractiveTime = 0; // of the mapper, when anything was last measured
  exabricks::Coarseness Coarseness; // of the last picture
  vtkIdType Rays = 0;               // and how many it had

  std::set<std::string> ReportedWarnings; // each is reported once
  bool SaidTransparent = false;   // that next to nothing shows: once, whatever the functions become
  std::string ReportedFault;      // of the last picture: reported once as long as it stays
  bool Aborted = false;           // the window was told to stop in the last picture
  std::string ConfigurationFault; // empty if the builder has the mapper's input and array

  explicit vtkInternals(vtkExaBricksVolumeMapper* self)
    : Self(self)
  {
  }

  // The steps of a picture, in their order.
  std::string ConfigureBuilder();
  std::shared_ptr<const exabricks::BrickedVolume> GetBrickedVolume() const;
  std::shared_ptr<const exabricks::BrickedVolume> FindShown(vtkVolumeProperty* property);
  std::optional<std::string> Draw(vtkRenderer* ren, vtkVolume* vol,
    const std::shared_ptr<const exabricks::BrickedVolume>& bricked);
  std::string CheckData(vtkVolumeProperty* property, const exabricks::BrickedVolume& bricked);
  exabricks::Requests CheckLighting(
    vtkVolumeProperty* property, const exabricks::BrickedVolume& bricked) const;
  void UpdateRenderer(
    vtkVolumeProperty* property, const std::shared_ptr<const exabricks::BrickedVolume>& bricked);
  void UpdateVolume(const std::shared_ptr<const exabricks::BrickedVolume>& bricked, bool completed);
  void UpdateTransferFunction(vtkVolumeProperty* property, const exabricks::BrickedVolume& bricked);
  exabricks::Reconstruction FindReconstruction(vtkVolumeProperty* property) const;
  bool UsesNanColor(vtkVolumeProperty* property, const exabricks::BrickedVolume& bricked) const;
  exabricks::View MakeView(vtkRenderer* ren, vtkVolume* vol,
    const exabricks::BrickedVolume& bricked, int width, int height) const;
  std::optional<std::string> Composite(
    vtkRenderer* ren, vtkVolume* vol, const exabricks::BrickedVolume& bricked);

  bool AdjustsSampleDistances(vtkRenderer* ren) const;
  void MeasurePasses();
  exabricks::Coarseness ChooseCoarseness(vtkRenderer* ren, vtkVolume* vol,
    const exabricks::BrickedVolume& bricked, int width, int height);
  std::vector<double> FindCellsInPixels(const exabricks::View& view, const glm::dvec3& size) const;
  exabricks::View MakeCoarseView(vtkRenderer* ren, vtkVolume* vol,
    const exabricks::BrickedVolume& bricked, int width, int height) const;

  // Volumes that overlap this one.
  struct Overlapping
  {
    vtkVolume* volume;
    vtkInternals* internals;
    std::shared_ptr<const exabricks::BrickedVolume> bricked;
  };
  std::vector<Overlapping> FindOverlapping(vtkRenderer* ren, vtkVolume* vol);
  bool MayJoin(vtkRenderer* ren, vtkVolume* candidate, const std::vector<vtkVolume*>& all) const;
  std::shared_ptr<const exabricks::BrickedVolume> MakeReady(vtkVolume* vol);
  std::string RenderPicture(vtkRenderer* ren, const exabricks::BrickedVolume& bricked,
    const std::vector<Overlapping>& others, const exabricks::View& view, exabricks::Pixels& picture,
    double& marching, const exabricks::VolumeRenderer::Progress& progress);

  void DropVolume();
  std::string Report(const exabricks::Requests& requests);
  void ReportFault(const std::string& fault);

private:
  vtkExaBricksVolumeMapper* const Self;
};

#endif
