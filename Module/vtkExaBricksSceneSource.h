// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkExaBricksSceneSource
 * @brief   makes stand-ins for the models that the ExaBricks paper measures, in any size
 *
 * The originals are not free or too large to ship. The stand-ins share with them what the time of
 * rendering depends on: the mean number of cells in a brick, and the kind of hierarchy. Cloud and
 * the three times of Impact are octrees of small fragments, Wind and Gear have large blocks, Exajet
 * has four levels around a thin body, on a lattice far from 0. How many cells lie on each level the
 * paper does not say: the stand-ins have fractions of their own, the same for every number of
 * cells. Equal settings make equal data.
 *
 * Output port 0 is a vtkOverlappingAMR with the cell array "value" (float, in [0, 1], without
 * unit); cells under finer ones are marked REFINEDCELL in vtkGhostType. Lengths have no unit
 * either; the largest side of a scene is 1 to 3, of Exajet 8 for each finest cell. Output port 1
 * is a vtkPolyData, the opaque surface inside Gear and Exajet, empty for the others. Camera and
 * volume property are set to the scene's own view. Of several processes that ask for a piece each,
 * as ParaView's do, each has blocks of its own, dealt in turn, and the boxes of all:
 *
 * @code
 * vtkNew<vtkExaBricksSceneSource> source;
 * source->SetSceneToGear();
 * source->SetNumberOfLeafCells(10000000);
 * mapper->SetInputConnection(source->GetOutputPort(0));
 * surfaceMapper->SetInputConnection(source->GetOutputPort(1));
 * source->InitializeProperty(volume->GetProperty());
 * source->InitializeCamera(renderer->GetActiveCamera());
 * renderer->ResetCameraClippingRange();
 * @endcode
 *
 * @par Thanks:
 * Wald, Zellmann, Usher, Morrical, Lang, Pascucci, "Ray Tracing Structured AMR Data Using
 * ExaBricks", IEEE VIS 2020.
 *
 * @sa
 * vtkExaBricksBuilder vtkExaBricksVolumeMapper
 */
#ifndef vtkExaBricksSceneSource_h
#define vtkExaBricksSceneSource_h

#include "vtkOverlappingAMRAlgorithm.h"
#include "vtkRenderingVolumeExaBricksModule.h" // for the export macro

#include <memory> // for std::unique_ptr

class vtkCamera;
class vtkPolyData;
class vtkVolumeProperty;

class VTKRENDERINGVOLUMEEXABRICKS_EXPORT vtkExaBricksSceneSource : public vtkOverlappingAMRAlgorithm
{
public:
  static vtkExaBricksSceneSource* New();
  vtkTypeMacro(vtkExaBricksSceneSource, vtkOverlappingAMRAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Which scene to make. Default CLOUD. The two of Exajet are two views of the same data.
   */
  enum SceneType
  {
    CLOUD = 0,
    IMPACT_5K = 1,
    IMPACT_20K = 2,
    IMPACT_46K = 3,
    WIND = 4,
    GEAR = 5,
    EXAJET_REAR = 6,
    EXAJET_WING = 7
  };
  vtkSetClampMacro(Scene, int, CLOUD, EXAJET_WING);
  vtkGetMacro(Scene, int);
  void SetSceneToCloud() { this->SetScene(CLOUD); }
  void SetSceneToImpact5K() { this->SetScene(IMPACT_5K); }
  void SetSceneToImpact20K() { this->SetScene(IMPACT_20K); }
  void SetSceneToImpact46K() { this->SetScene(IMPACT_46K); }
  void SetSceneToWind() { this->SetScene(WIND); }
  void SetSceneToGear() { this->SetScene(GEAR); }
  void SetSceneToExajetRear() { this->SetScene(EXAJET_REAR); }
  void SetSceneToExajetWing() { this->SetScene(EXAJET_WING); }
  ///@}

  ///@{
  /**
   * By name, in capital letters or not: "Cloud", "Impact-5K", "Impact-20K", "Impact-46K", "Wind",
   * "Gear", "Exajet-rear", "Exajet-wing".
   */
  void SetSceneName(const char* name);
  const char* GetSceneName();
  ///@}

  ///@{
  /**
   * How many leaf cells (cells that no finer block covers) to make, to within 20 %. Default 200000.
   * With fewer than GetLeastNumberOfLeafCells() the scene would not be what it stands for: that
   * many are made instead, with a warning.
   */
  vtkSetClampMacro(NumberOfLeafCells, vtkIdType, 1, VTK_ID_MAX);
  vtkGetMacro(NumberOfLeafCells, vtkIdType);
  vtkIdType GetLeastNumberOfLeafCells();
  ///@}

  /// Mean number of leaf cells in a brick of the original, from the memory in the paper's tables.
  double GetCellsPerBrickOfOriginal();

  ///@{
  /**
   * Set the scene's own view. The camera's clipping range is left to the renderer. The opacity unit
   * distance is a length in the data's coordinates, transfer functions are in units of the cell
   * array, interpolation is linear. They depend on the scene and its number of cells, and bring the
   * source up to date.
   */
  void InitializeCamera(vtkCamera* camera);
  void InitializeProperty(vtkVolumeProperty* property);
  ///@}

  /// The surface inside the volume: output port 1.
  vtkPolyData* GetMesh();

  /// Later than its output when there was no memory for the last run: the next Update() runs again.
  vtkMTimeType GetMTime() override;

protected:
  vtkExaBricksSceneSource();
  ~vtkExaBricksSceneSource() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Scene = CLOUD;
  vtkIdType NumberOfLeafCells = 200000;

private:
  vtkExaBricksSceneSource(const vtkExaBricksSceneSource&) = delete;
  void operator=(const vtkExaBricksSceneSource&) = delete;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
