// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkExaBricksRedistribute
 * @brief   gives each of several processes a box of an overlapping AMR to draw
 *
 * Readers of AMR deal blocks to processes in turn, so that the boxes that they hold overlap, and
 * what a process draws is neither whole (coarse cells lie under finer blocks of another process,
 * and cells beside its blocks are missing) nor before or behind what others draw. This filter cuts
 * the bounds into boxes of about equal numbers of leaf cells, by a k-d tree, and sends each process
 * the leaf cells in its box, and those around it that count for the reconstruction there. What
 * vtkExaBricksVolumeMapper then draws on a process ends at the faces of its box, and the pictures,
 * one over the other in the order of GetFrontToBack(), are that of one process.
 *
 * Input: what the process has of the AMR, in any way; blocks may be null, and blocks that several
 * processes have count once. Output: the process's part, without cells that finer ones cover; of
 * cell arrays all that every block has, with the ranges that they have on all processes in the
 * field data, so that transfer functions mean the same everywhere. Point arrays stay behind. Of one
 * process the output is the input.
 *
 * An ErrorTolerance does not count for a part, and maximum, minimum, average and additive blending
 * is that of the part, which the mapper says. Cells that are picked or selected are those of the
 * output.
 *
 * All processes have to update it together. Boxes of blocks travel first, and the structure is kept
 * while they stay the same: another array or time step moves values alone. What goes wrong on one
 * process is said by the first one, with the number of the other, and no process has blocks then.
 *
 * @sa
 * vtkExaBricksVolumeMapper
 */
#ifndef vtkExaBricksRedistribute_h
#define vtkExaBricksRedistribute_h

#include "vtkOverlappingAMRAlgorithm.h"
#include "vtkRenderingVolumeExaBricksModule.h" // for the export macro

#include <memory> // for std::unique_ptr

class vtkCamera;
class vtkIdList;
class vtkMatrix4x4;
class vtkMultiProcessController;

class VTKRENDERINGVOLUMEEXABRICKS_EXPORT vtkExaBricksRedistribute
  : public vtkOverlappingAMRAlgorithm
{
public:
  static vtkExaBricksRedistribute* New();
  vtkTypeMacro(vtkExaBricksRedistribute, vtkOverlappingAMRAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The processes. The global controller, if there is one, by default; null: there is one process.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  ///@{
  /**
   * Whether the mapper's reconstruction will be COMPLETED, which needs more cells around each box:
   * five of the coarsest cells nearby. Off by default: three cells of each level, one for the
   * reconstruction, and two as the last interval of samples may end beyond the box.
   */
  vtkSetMacro(ForCompleted, bool);
  vtkGetMacro(ForCompleted, bool);
  vtkBooleanMacro(ForCompleted, bool);
  ///@}

  ///@{
  /**
   * The levels that count, from the first to the last number: all by default. As
   * vtkExaBricksBuilder::SetLevelRange(), which a part has no use for.
   */
  vtkSetVector2Macro(LevelRange, int);
  vtkGetVector2Macro(LevelRange, int);
  ///@}

  /// The processes in the order in which what they draw hides that of others. `toWorld`: of the
  /// volume, or null. Those with nothing to draw are not among them. The same on all processes.
  void GetFrontToBack(vtkCamera* camera, vtkMatrix4x4* toWorld, vtkIdList* processes);

  /// The box that a process draws, in the data's own coordinates; uninitialised, if it draws
  /// nothing.
  void GetPartBounds(int process, double bounds[6]);

  /// Of all processes, in the last update.
  vtkIdType GetNumberOfLeafCells();

  ///@{
  /**
   * Of the last update, of this process: leaf cells that it draws, cells that it has for that, and
   * bytes of values that came from others.
   */
  vtkIdType GetNumberOfCellsToDraw();
  vtkIdType GetNumberOfCells();
  vtkTypeInt64 GetBytesReceived();
  ///@}

  /// How often the structure was cut into parts: it does not grow with arrays or time steps on the
  /// same boxes.
  int GetNumberOfStructureBuilds();

protected:
  vtkExaBricksRedistribute();
  ~vtkExaBricksRedistribute() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  bool ForCompleted = false;
  int LevelRange[2] = { 0, VTK_INT_MAX };

private:
  vtkExaBricksRedistribute(const vtkExaBricksRedistribute&) = delete;
  void operator=(const vtkExaBricksRedistribute&) = delete;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
