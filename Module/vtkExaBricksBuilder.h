// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkExaBricksBuilder
 * @brief   turns an overlapping AMR into bricks and active brick regions
 *
 * Takes a vtkOverlappingAMR in 3-D with any number of levels, any whole refinement ratio per level
 * and anisotropic spacing, and makes a vtkExaBricksData of one of its arrays, of any type. Choose
 * the array with SetInputArrayToProcess(0, 0, 0, association, name); without it the active cell
 * scalars are taken. Point arrays of an AMR of one block are drawn as VTK's mappers draw those of
 * an image: values between points are interpolated, and each point counts as a cell of the output.
 * Those of several blocks are converted to cells with vtkPointDataToCellData.
 *
 * Blocks may be null: a coarse cell counts as covered only where a finer block is really there.
 * Arrays may be larger than the AMR box (ghost layers). Cells marked HIDDENCELL in vtkGhostType,
 * NaN and infinite values are absent: transparent, without influence on their neighbours. Cells
 * marked DUPLICATECELL give way to the real cell, and where there is none of any level, as on the
 * process that does not own them, they are absent too; REFINEDCELL is found anew, as in VTK's AMR
 * filters. Where finer blocks cover a coarse cell in part, the rest of it keeps its value.
 *
 * Bricks and regions are built anew only when the boxes change: another array or time step on the
 * same boxes keeps them. Values are normalised in double precision to the range of the leaf cells.
 *
 * @sa
 * vtkExaBricksData vtkExaBricksVolumeMapper
 */
#ifndef vtkExaBricksBuilder_h
#define vtkExaBricksBuilder_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkRenderingVolumeExaBricksModule.h" // for the export macro

#include <memory> // for std::unique_ptr

class vtkExaBricksData;
class vtkOverlappingAMR;

class VTKRENDERINGVOLUMEEXABRICKS_EXPORT vtkExaBricksBuilder : public vtkDataObjectAlgorithm
{
public:
  static vtkExaBricksBuilder* New();
  vtkTypeMacro(vtkExaBricksBuilder, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What to take of an array with several components: their magnitude (default), one of them, or
   * (DISABLED) each, of at most four: then a cell of which one is not finite is absent. Ranges and
   * the cells of vtkExaBricksData are those of the first one. The names are those of
   * vtkSmartVolumeMapper.
   */
  enum VectorModeType
  {
    DISABLED = -1,
    MAGNITUDE = 0,
    COMPONENT = 1
  };
  vtkSetClampMacro(VectorMode, int, DISABLED, COMPONENT);
  vtkGetMacro(VectorMode, int);
  static const char* GetVectorModeAsString(int mode);
  void SetVectorModeToDisabled() { this->SetVectorMode(DISABLED); }
  void SetVectorModeToMagnitude() { this->SetVectorMode(MAGNITUDE); }
  void SetVectorModeToComponent() { this->SetVectorMode(COMPONENT); }
  vtkSetClampMacro(VectorComponent, int, 0, VTK_INT_MAX);
  vtkGetMacro(VectorComponent, int);
  ///@}

  ///@{
  /**
   * Another array, of the same cells or points, whose values are a second component: of its own
   * name and component, -1: the magnitude of several. Then VectorMode DISABLED takes the first
   * array's one component, and refuses several. Null (default): there is none.
   */
  vtkSetStringMacro(SecondArrayName);
  vtkGetStringMacro(SecondArrayName);
  vtkSetClampMacro(SecondComponent, int, -1, VTK_INT_MAX);
  vtkGetMacro(SecondComponent, int);
  ///@}

  ///@{
  /**
   * The levels of the AMR that count, from the first to the last number: all by default. Others are
   * left out as if they were not there: without fine ones, coarse cells below them come to light;
   * without coarse ones, there is nothing beside the fine blocks.
   */
  vtkSetVector2Macro(LevelRange, int);
  vtkGetVector2Macro(LevelRange, int);
  ///@}

  /// How often bricks and regions were built: it does not grow with arrays or time steps on the
  /// same boxes.
  vtkGetMacro(NumberOfStructureBuilds, int);

  vtkExaBricksData* GetOutput();

  /// Later than its output when the last run was aborted or there was no memory for it: the next
  /// Update() runs again.
  vtkMTimeType GetMTime() override;

protected:
  vtkExaBricksBuilder();
  ~vtkExaBricksBuilder() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int VectorMode = MAGNITUDE;
  int VectorComponent = 0;
  char* SecondArrayName = nullptr;
  int SecondComponent = 0;
  int LevelRange[2] = { 0, VTK_INT_MAX };
  int NumberOfStructureBuilds = 0;

private:
  vtkExaBricksBuilder(const vtkExaBricksBuilder&) = delete;
  void operator=(const vtkExaBricksBuilder&) = delete;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
