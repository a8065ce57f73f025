// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkExaBricksPicker
 * @brief   picks the cell of an AMR volume that is seen at a place of the window
 *
 * Shoots a ray through a place of the window at all volumes that vtkExaBricksVolumeMapper draws,
 * and answers with the place where the nearest one is first seen: where the opacity from the viewer
 * on comes to VolumeOpacityIsovalue; with blend modes maximum and minimum, where the value is that
 * is shown; with average and additive, where the data begin. What is cut away by clipping planes
 * and cropping, and what lies behind the geometry of the last picture, is not picked.
 * (vtkCellPicker and vtkVolumePicker take volumes of images alone; vtkPropPicker and area picks
 * find the volume, and not the place in it; vtkHardwareSelector the cells of an area.)
 *
 * @code
 * vtkNew<vtkExaBricksPicker> picker;
 * if (picker->Pick(x, y, 0.0, renderer))
 * {
 *   picker->GetPickPosition(position);
 *   std::cout << picker->GetValue() << " in cell " << picker->GetCellId() << " of block "
 *             << picker->GetBlock() << " of level " << picker->GetLevel();
 * }
 * @endcode
 *
 * @sa
 * vtkExaBricksVolumeMapper vtkCellPicker
 */
#ifndef vtkExaBricksPicker_h
#define vtkExaBricksPicker_h

#include "vtkAbstractPropPicker.h"
#include "vtkRenderingVolumeExaBricksModule.h" // for the export macro

#include <vector> // for the values

class vtkOverlappingAMR;

namespace exabricks
{
struct BrickedVolume;
}

class VTKRENDERINGVOLUMEEXABRICKS_EXPORT vtkExaBricksPicker : public vtkAbstractPropPicker
{
public:
  static vtkExaBricksPicker* New();
  vtkTypeMacro(vtkExaBricksPicker, vtkAbstractPropPicker);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Picks at display coordinates (pixels from the window's lower left corner; the third is not
  /// used). Returns 1 if a volume was picked: GetVolume(), GetPickPosition() and what follows tell
  /// more. Invokes StartPickEvent, PickEvent and EndPickEvent.
  int Pick(double selectionX, double selectionY, double selectionZ, vtkRenderer* renderer) override;

  ///@{
  /**
   * Opacity at which a ray counts as stopped, in (0, 1]. Default 0.05, as of vtkVolumePicker.
   */
  vtkSetClampMacro(VolumeOpacityIsovalue, double, 1e-6, 1.0);
  vtkGetMacro(VolumeOpacityIsovalue, double);
  ///@}

  ///@{
  /**
   * The leaf cell that was picked: its level of the AMR, the index of its block in that level, its
   * id and indices in the block's grid, or -1 where nothing was picked.
   */
  vtkGetMacro(Level, int);
  vtkGetMacro(Block, int);
  vtkGetMacro(CellId, vtkIdType);
  vtkGetVector3Macro(CellIJK, int);
  ///@}

  /// The value of that cell in the array that is drawn: the component or the magnitude that is
  /// drawn of several, or of each component that is, the one asked for. NaN where nothing was
  /// picked.
  double GetValue(int component = 0);

protected:
  vtkExaBricksPicker() = default;
  ~vtkExaBricksPicker() override = default;

  void Initialize() override;

  double VolumeOpacityIsovalue = 0.05;
  int Level = -1;
  int Block = -1;
  vtkIdType CellId = -1;
  int CellIJK[3] = { -1, -1, -1 };

private:
  vtkExaBricksPicker(const vtkExaBricksPicker&) = delete;
  void operator=(const vtkExaBricksPicker&) = delete;

  void FindCell(
    const exabricks::BrickedVolume& bricked, vtkOverlappingAMR* amr, const double inCell[3]);

  std::vector<double> Values; // of the cell's components
};

#endif
