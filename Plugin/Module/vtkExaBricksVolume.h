// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkExaBricksVolume
 * @brief   a volume that shows its outline where it cannot be drawn
 *
 * Where a vtkExaBricksVolumeMapper cannot draw (no Vulkan device, wrong data), which it reports,
 * the outline shows where the data are all the same.
 *
 * @sa
 * vtkExaBricksRepresentation vtkExaBricksVolumeMapper
 */
#ifndef vtkExaBricksVolume_h
#define vtkExaBricksVolume_h

#include "vtkNew.h"                     // for vtkNew
#include "vtkParaViewExaBricksModule.h" // for the export macro
#include "vtkVolume.h"

class vtkActor;
class vtkAlgorithmOutput;
class vtkPolyDataMapper;

class VTKPARAVIEWEXABRICKS_EXPORT vtkExaBricksVolume : public vtkVolume
{
public:
  static vtkExaBricksVolume* New();
  vtkTypeMacro(vtkExaBricksVolume, vtkVolume);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The lines to draw in place of the volume: a vtkPolyData.
  void SetOutlineConnection(vtkAlgorithmOutput* output);

  ///@{
  /**
   * Do not ask the mapper, but draw the outline. Default on, until there is something to draw.
   */
  vtkSetMacro(OutlineOnly, bool);
  vtkGetMacro(OutlineOnly, bool);
  ///@}

  /// Those of the mapper's data, or of the outline alone.
  double* GetBounds() override;
  using vtkVolume::GetBounds;

  /// Invokes vtkCommand::EndEvent when it is done.
  int RenderVolumetricGeometry(vtkViewport* viewport) override;
  /// Draws the outline, if the volume was not drawn.
  int RenderOverlay(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkExaBricksVolume();
  ~vtkExaBricksVolume() override;

  bool OutlineOnly = true;
  vtkNew<vtkPolyDataMapper> OutlineMapper;
  vtkNew<vtkActor> Outline;

private:
  vtkExaBricksVolume(const vtkExaBricksVolume&) = delete;
  void operator=(const vtkExaBricksVolume&) = delete;
};

#endif
