// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkExaBricksRepresentation
 * @brief   ParaView's representation "ExaBricks": overlapping AMR drawn by vtkExaBricksVolumeMapper
 *
 * The volume is drawn where the data are: on the server if there is one, which sends the picture.
 * Where it cannot be drawn, as there is no Vulkan device, or the mapper cannot take the data, or no
 * array to color by was chosen, its outline is drawn, and the reason is reported once.
 *
 * The component that is drawn is that of the color map (vtkScalarsToColors::GetVectorMode()),
 * unless components are dependent. Every process may have any part of the blocks, or none.
 *
 * @sa
 * vtkExaBricksVolumeMapper vtkExaBricksVolume
 */
#ifndef vtkExaBricksRepresentation_h
#define vtkExaBricksRepresentation_h

#include "vtkNew.h" // for vtkNew
#include "vtkPVDataRepresentation.h"
#include "vtkParaViewExaBricksModule.h" // for the export macro
#include "vtkSmartPointer.h"            // for vtkSmartPointer

#include <string> // for the opacity array

class vtkColorTransferFunction;
class vtkExaBricksRedistribute;
class vtkExaBricksStatistics;
class vtkExaBricksVolume;
class vtkExaBricksVolumeMapper;
class vtkImplicitFunction;
class vtkOutlineSource;
class vtkOverlappingAMR;
class vtkPVTransferFunction2D;
class vtkPiecewiseFunction;
class vtkVolumeProperty;

class VTKPARAVIEWEXABRICKS_EXPORT vtkExaBricksRepresentation : public vtkPVDataRepresentation
{
public:
  static vtkExaBricksRepresentation* New();
  vtkTypeMacro(vtkExaBricksRepresentation, vtkPVDataRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;
  void SetVisibility(bool visible) override;

  ///@{
  /**
   * Of the volume, as for vtkProp3D. The matrix of SetUserTransform() is applied last.
   */
  void SetPosition(double x, double y, double z);
  void SetScale(double x, double y, double z);
  void SetOrientation(double x, double y, double z);
  void SetOrigin(double x, double y, double z);
  void SetUserTransform(const double matrix[16]);
  void SetPickable(int pickable);
  ///@}

  ///@{
  /**
   * Of the volume property. The unit distance is a world length.
   */
  void SetColor(vtkColorTransferFunction* color);
  void SetScalarOpacity(vtkPiecewiseFunction* opacity);
  void SetScalarOpacityUnitDistance(double distance);
  void SetShading(bool shading);
  void SetAmbient(double ambient);
  void SetDiffuse(double diffuse);
  void SetSpecular(double specular);
  void SetSpecularPower(double power);
  void SetVolumeAnisotropy(double anisotropy);
  void SetNumberOfIsosurfaceValues(int count);
  void SetIsosurfaceValue(int number, double value);
  void SetSliceFunction(vtkImplicitFunction* function);
  ///@}

  ///@{
  /**
   * What is drawn of an array with several components: the color map's choice of one, or their
   * magnitude; two or four of them as a color with an opacity; or each of up to four, with the same
   * colors and opacities.
   */
  enum ComponentsType
  {
    ONE = 0,
    DEPENDENT = 1,
    INDEPENDENT = 2
  };
  void SetComponents(int components);
  ///@}

  ///@{
  /**
   * An array that has the opacities, as for vtkVolumeRepresentation. The number of its components
   * stands for their magnitude. It has to be of the same cells or points as the one to color by.
   */
  void SetUseSeparateOpacityArray(bool use);
  void SelectOpacityArray(int index, int port, int connection, int association, const char* name);
  void SelectOpacityArrayComponent(int component);
  ///@}

  ///@{
  /**
   * A 2-D transfer function in place of colors and opacities, as for vtkVolumeRepresentation: of
   * the array to color by, and of its gradient's magnitude or of another
   * array of the same cells or points.
   */
  void SetUseTransfer2D(bool use);
  void SetTransferFunction2D(vtkPVTransferFunction2D* function);
  void SetUseGradientForTransfer2D(bool use);
  void SelectColorArray2(int index, int port, int connection, int association, const char* name);
  void SelectColorArray2Component(int component);
  ///@}

  ///@{
  /**
   * Of the mapper, see vtkExaBricksVolumeMapper. Where several ranks draw, the error tolerance is
   * not used.
   */
  void SetReconstruction(int reconstruction);
  void SetBlendMode(int mode);
  void SetStepScale(double scale);
  void SetErrorTolerance(double tolerance);
  void SetTraversal(int traversal);
  void SetEarlyTerminationOpacity(double opacity);
  void SetDevice(const char* device);
  void SetLevelRange(int first, int last);
  void SetUseNanColor(bool use);
  void SetVolumetricScatteringBlending(double blending);
  void SetGlobalIlluminationReach(double reach);
  void SetCropping(bool cropping);
  void SetCroppingRegionPlanes(
    double lowerX, double upperX, double lowerY, double upperY, double lowerZ, double upperZ);
  void SetCroppingRegionFlags(int flags);
  ///@}

  /// The object that tells what was drawn last; null on a client.
  void SetStatistics(vtkExaBricksStatistics* statistics);

protected:
  vtkExaBricksRepresentation();
  ~vtkExaBricksRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkExaBricksRepresentation(const vtkExaBricksRepresentation&) = delete;
  void operator=(const vtkExaBricksRepresentation&) = delete;

  // Whether several ranks draw a part each.
  bool IsOneOfSeveral();
  void ProvideData(vtkInformation* inInfo, vtkInformation* outInfo);
  void TakeDeliveredData(vtkInformation* inInfo);
  // Hands the mapper the array and the component; false if there is no array to draw.
  bool SelectArray(vtkOverlappingAMR* amr);
  // An array beside the one to color by.
  struct OtherArray
  {
    std::string name;
    int association = 0;
    int component = 0; // the number of its components stands for their magnitude

    void Select(int ofAssociation, const char* name);
  };
  // Hands the mapper the array with the opacities, or with the second variable of a 2-D function,
  // if there is one of these cells or points.
  bool SelectSecondArray(vtkOverlappingAMR* amr, int association);
  // Hands the property the 2-D function, where it is used.
  void SelectTransfer2D();
  // Called after each picture.
  void UpdateStatistics();

  vtkNew<vtkExaBricksRedistribute> Redistribute; // where there are several ranks
  vtkNew<vtkExaBricksVolumeMapper> Mapper;
  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkExaBricksVolume> Volume;
  vtkNew<vtkOutlineSource> OutlineSource;

  vtkSmartPointer<vtkDataObject> Data; // the part that this process draws
  double Bounds[6];                    // of it
  int Components = ONE;
  bool UseSeparateOpacityArray = false;
  OtherArray OpacityArray;
  bool UseTransfer2D = false;
  bool UseGradientForTransfer2D = true;
  OtherArray ColorArray2;
  vtkSmartPointer<vtkPVTransferFunction2D> TransferFunction2D;
  bool ReportedSecondArray = false;
  bool ReportedNoArray = false;
  bool ReportedPoints = false;
  vtkSmartPointer<vtkExaBricksStatistics> Statistics;
};

#endif
