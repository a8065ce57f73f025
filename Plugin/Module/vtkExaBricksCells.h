// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkExaBricksCells
 * @brief   the bricks or the regions of an overlapping AMR as VTK cells
 *
 * A filter over vtkExaBricksData::GetBricksAsCells() and GetRegionsAsCells(), whose cell arrays the
 * output has. The array is chosen with SetInputArrayToProcess(0, ...).
 *
 * @sa
 * vtkExaBricksBuilder vtkExaBricksData
 */
#ifndef vtkExaBricksCells_h
#define vtkExaBricksCells_h

#include "vtkNew.h"                     // for vtkNew
#include "vtkParaViewExaBricksModule.h" // for the export macro
#include "vtkUnstructuredGridAlgorithm.h"

class vtkExaBricksBuilder;

class VTKPARAVIEWEXABRICKS_EXPORT vtkExaBricksCells : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkExaBricksCells* New();
  vtkTypeMacro(vtkExaBricksCells, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What to show. Default BRICKS.
   */
  enum CellsType
  {
    BRICKS = 0,
    REGIONS = 1
  };
  vtkSetClampMacro(Cells, int, BRICKS, REGIONS);
  vtkGetMacro(Cells, int);
  ///@}

protected:
  vtkExaBricksCells();
  ~vtkExaBricksCells() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Cells = BRICKS;
  vtkNew<vtkExaBricksBuilder> Builder;

private:
  vtkExaBricksCells(const vtkExaBricksCells&) = delete;
  void operator=(const vtkExaBricksCells&) = delete;
};

#endif
