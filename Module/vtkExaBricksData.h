// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkExaBricksData
 * @brief   bricks, active brick regions and normalised values of an overlapping AMR
 *
 * vtkExaBricksBuilder makes it and vtkExaBricksVolumeMapper draws it. *Bricks* are boxes of leaf
 * cells (cells that no finer block covers) of one level; *regions* are disjoint boxes that
 * partition the data's bounds, each with the fixed list of bricks whose support reaches into it.
 * Both can be looked at as VTK cells. Of an array of which each component is taken, ranges, the
 * histogram and what is active are those of the first one.
 *
 * @par Thanks:
 * Wald, Zellmann, Usher, Morrical, Lang, Pascucci, "Ray Tracing Structured AMR Data Using
 * ExaBricks", IEEE VIS 2020.
 *
 * @sa
 * vtkExaBricksBuilder vtkExaBricksVolumeMapper
 */
#ifndef vtkExaBricksData_h
#define vtkExaBricksData_h

#include "vtkDataObject.h"
#include "vtkRenderingVolumeExaBricksModule.h" // for the export macro

#include <memory> // for std::shared_ptr

class vtkDoubleArray;
class vtkIdTypeArray;
class vtkPiecewiseFunction;
class vtkUnstructuredGrid;

namespace exabricks
{
struct BrickedVolume;
}

class VTKRENDERINGVOLUMEEXABRICKS_EXPORT vtkExaBricksData : public vtkDataObject
{
public:
  static vtkExaBricksData* New();
  vtkTypeMacro(vtkExaBricksData, vtkDataObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Initialize() override;
  void ShallowCopy(vtkDataObject* source) override;
  /// Shares what it holds, as that never changes.
  void DeepCopy(vtkDataObject* source) override;
  /// In KiB.
  unsigned long GetActualMemorySize() override;

  ///@{
  /**
   * What it is made of. Levels and blocks that hold no data are not counted.
   */
  int GetNumberOfLevels();
  vtkIdType GetNumberOfBlocks();
  vtkIdType GetNumberOfLeafCells();
  vtkIdType GetNumberOfBricks();
  vtkIdType GetNumberOfRegions();
  ///@}

  /// Number of leaf cells without a value, as they are hidden, NaN or infinite.
  vtkIdType GetNumberOfAbsentCells();

  /// Range of the leaf cells' values; (1, 0) if there are none.
  void GetScalarRange(double range[2]);

  /// Name of the array, or null.
  const char* GetArrayName();

  /// World bounds of the leaf cells; an uninitialised bounding box if there are none.
  void GetBounds(double bounds[6]);

  /// World size of a cell of the finest level.
  void GetFinestSpacing(double spacing[3]);

  ///@{
  /**
   * Seconds that it took to build bricks and regions, 0 if those of the data before were kept; and
   * to read and normalise the values.
   */
  double GetStructureTime();
  double GetScalarsTime();
  ///@}

  /// Counts leaf cells in `bins` bins of equal width over the scalar range, each cell once.
  void GetHistogram(int bins, vtkIdTypeArray* counts);

  /// The share of the volume that the leaf cells of each of these bins take, of that of all cells
  /// with a value: the sum is 1.
  void GetVolumeHistogram(int bins, vtkDoubleArray* shares);

  /**
   * The bricks as voxels, with cell arrays "Level" (of the AMR), "Cells" (along x, y, z) and
   * "Range" (least and greatest value; 1, 0 if all cells are absent).
   */
  void GetBricksAsCells(vtkUnstructuredGrid* output);

  /**
   * The regions as voxels, with cell arrays "Level" (finest of its bricks; -1 if it holds no data),
   * "BrickCount", "Range" (least and greatest value that the reconstruction can take; 1, 0 if it
   * holds no data) and "Active" (1 if `opacity` shows anything in it; without `opacity`, if it
   * holds data).
   */
  void GetRegionsAsCells(vtkUnstructuredGrid* output, vtkPiecewiseFunction* opacity = nullptr);

#ifndef __VTK_WRAP__
  /// What it holds (Adapters/BrickedVolume.h); null if that is nothing.
  const std::shared_ptr<const exabricks::BrickedVolume>& GetBrickedVolume() const
  {
    return this->Bricked;
  }
  void SetBrickedVolume(std::shared_ptr<const exabricks::BrickedVolume> bricked);
#endif

protected:
  vtkExaBricksData();
  ~vtkExaBricksData() override;

private:
  vtkExaBricksData(const vtkExaBricksData&) = delete;
  void operator=(const vtkExaBricksData&) = delete;

  std::shared_ptr<const exabricks::BrickedVolume> Bricked;
};

#endif
