// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkExaBricksVolumeMapper
 * @brief   volume rendering of an overlapping AMR as it is, with Vulkan
 *
 * A drop-in vtkVolumeMapper for vtkOverlappingAMR: no resampling, no covered cells drawn, no seams.
 * Leaf cells are grouped into bricks and active brick regions (vtkExaBricksBuilder); rays march
 * region by region with the continuous tent-basis reconstruction, adaptive steps, corrected opacity
 * and space skipping on a Vulkan device: a GPU, or Mesa's lavapipe without one. The picture is
 * composited into the render window, cut by the depth of opaque geometry.
 *
 * @code
 * auto mapper = vtkSmartPointer<vtkExaBricksVolumeMapper>::New();
 * mapper->SetInputConnection(reader->GetOutputPort());
 * mapper->SetScalarModeToUseCellFieldData();
 * mapper->SelectScalarArray("density");
 * volume->SetMapper(mapper);
 * @endcode
 *
 * Of the volume property it honours colour (1 or 3 channels, smooth or discretised), scalar
 * opacity and its unit distance, a length in the data's own coordinates, before the volume's
 * matrix, the interpolation type, gradient opacity and shading by all lights of the renderer, both
 * with the blend modes composite, iso-surface and slice, and components (see VectorMode). Blend
 * modes: composite, maximum, minimum and average intensity, additive, iso-surface with up to 16
 * values, and slice with a vtkPlane, in world coordinates, as the property's slice function. It
 * says so when it is asked for what it does not do: an error where nothing is drawn, else a
 * warning. Colours of categories (IndexedLookup) need the nearest reconstruction.
 *
 * Clipping planes (AddClippingPlane(), SetClippingPlanes()) are in world coordinates and leave what
 * lies along their normals; with more than 32 of them, or one without a direction, nothing is
 * drawn, and an error says so. Cropping (CroppingOn(), SetCroppingRegionPlanes(),
 * SetCroppingRegionFlags()) is in the data's own coordinates; where an upper plane is below its
 * lower one, nothing is between the two. Both cut exactly, through cells and steps.
 *
 * The volume is picked by vtkPropPicker and area picks. vtkHardwareSelector tells the cells that
 * are first seen, their blocks as composite indices; vtkExaBricksPicker that of one place, with the
 * place and the cell's value.
 *
 * Volumes of this mapper that overlap in a renderer are drawn as one medium, with blend mode
 * composite and equal final colors: what each absorbs and emits adds up. Others are drawn one after
 * the other, as VTK sorts them.
 *
 * Where the renderer peels depth for volumes too (SetUseDepthPeelingForVolumes), translucent
 * geometry shows in the right order with it; else the volume is drawn over it.
 *
 * @par Thanks:
 * Wald, Zellmann, Usher, Morrical, Lang, Pascucci, "Ray Tracing Structured AMR Data Using
 * ExaBricks", IEEE VIS 2020.
 *
 * @sa
 * vtkExaBricksBuilder vtkExaBricksData vtkExaBricksPicker vtkAMRVolumeMapper
 */
#ifndef vtkExaBricksVolumeMapper_h
#define vtkExaBricksVolumeMapper_h

#include "vtkRenderingVolumeExaBricksModule.h" // for the export macro
#include "vtkVolumeMapper.h"

#include <memory>   // for std::unique_ptr
#include <optional> // for a pick

class vtkExaBricksBuilder;
class vtkImageData;
class vtkOverlappingAMR;
class vtkRenderWindow;
class vtkStringArray;
class vtkVolumeProperty;

namespace exabricks
{
struct FirstSeen;
}

class VTKRENDERINGVOLUMEEXABRICKS_EXPORT vtkExaBricksVolumeMapper : public vtkVolumeMapper
{
public:
  static vtkExaBricksVolumeMapper* New();
  vtkTypeMacro(vtkExaBricksVolumeMapper, vtkVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  using vtkVolumeMapper::SetInputData;
  virtual void SetInputData(vtkOverlappingAMR* amr);

  ///@{
  /**
   * How values between cells are found. BASIS: the mean of the cells' values weighted
   * with their tents, continuous also across levels. NEAREST: the value of the leaf cell that holds
   * the point. COMPLETED: trilinear interpolation in each level, whose lattice is completed by
   * values extrapolated from the other levels beside it, and between the levels the mean weighted
   * with the tents. Continuous, and exact for linear fields across levels, where the basis is off
   * by up to half a fine cell for a ratio of 2, and normals of the basis turn by some 75 degrees,
   * which shaded volumes and iso-surfaces show; costs as much time a picture as the basis, and
   * memory for one layer of cells more around each brick. Until one is chosen, the volume
   * property's interpolation type counts, as for VTK's mappers: nearest, its default, or linear,
   * which is BASIS.
   */
  enum ReconstructionType
  {
    BASIS = 0,
    NEAREST = 1,
    COMPLETED = 2
  };
  virtual void SetReconstruction(int reconstruction);
  vtkGetMacro(Reconstruction, int);
  void SetReconstructionToBasis() { this->SetReconstruction(BASIS); }
  void SetReconstructionToNearest() { this->SetReconstruction(NEAREST); }
  void SetReconstructionToCompleted() { this->SetReconstruction(COMPLETED); }
  const char* GetReconstructionAsString();
  ///@}

  ///@{
  /**
   * Greatest distance between two samples of the field on a ray, in cells of the finest level that
   * reaches the region that the ray is in. Default 1. Between samples, every value that the field
   * passes counts, however narrow the transfer function's spikes are; the error falls with the
   * square of the step, the time grows with its inverse. Has no effect on the nearest
   * reconstruction, which takes one interval for each cell, and on iso-surfaces: both are exact.
   */
  vtkSetClampMacro(StepScale, double, 0.001, 1000.0);
  vtkGetMacro(StepScale, double);
  ///@}

  ///@{
  /**
   * Distance of two samples of the field on a ray, a length in the data's own coordinates, the same
   * everywhere, as of vtkGPUVolumeRayCastMapper. 0 (default): that of the StepScale, which follows
   * the cells. A region shorter than it has one sample. Has no effect on the nearest
   * reconstruction and on iso-surfaces, which are exact.
   */
  vtkSetClampMacro(SampleDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SampleDistance, double);
  ///@}

  ///@{
  /**
   * How far apart the rays of a picture are, in pixels along each of its axes, as of VTK's ray cast
   * mappers. Default 1: one for each pixel; of 2, one for each four, between which the picture is
   * filled in, but not across edges of opaque geometry. Where sample distances are adjusted it is
   * chosen, from the least to the greatest one; beyond that, steps between samples grow too.
   */
  vtkSetClampMacro(ImageSampleDistance, float, 1.0f, 100.0f);
  vtkGetMacro(ImageSampleDistance, float);
  vtkSetClampMacro(MinimumImageSampleDistance, float, 1.0f, 100.0f);
  vtkGetMacro(MinimumImageSampleDistance, float);
  vtkSetClampMacro(MaximumImageSampleDistance, float, 1.0f, 100.0f);
  vtkGetMacro(MaximumImageSampleDistance, float);
  ///@}

  ///@{
  /**
   * Whether image sample distance and steps are chosen so that a picture takes the time allocated
   * to the volume (vtkProp::GetAllocatedRenderTime(), by the window's desired update rate), as of
   * vtkSmartVolumeMapper. With InteractiveAdjustSampleDistances on (the default) they are while the
   * window's desired update rate is at least InteractiveUpdateRate (1 by default), as it is while
   * an interactor moves something, and not when it stands still. With it off,
   * AutoAdjustSampleDistances decides. Levels whose cells lie closer together than rays are then
   * left out; the volume without them is made on a thread of its own, and kept, for which memory is
   * taken as for an ErrorTolerance, whose own levels and steps are those that were chosen last.
   * What is drawn when nothing is adjusted does not depend on what was drawn before.
   */
  vtkSetClampMacro(AutoAdjustSampleDistances, vtkTypeBool, 0, 1);
  vtkGetMacro(AutoAdjustSampleDistances, vtkTypeBool);
  vtkBooleanMacro(AutoAdjustSampleDistances, vtkTypeBool);
  vtkSetClampMacro(InteractiveAdjustSampleDistances, vtkTypeBool, 0, 1);
  vtkGetMacro(InteractiveAdjustSampleDistances, vtkTypeBool);
  vtkBooleanMacro(InteractiveAdjustSampleDistances, vtkTypeBool);
  vtkSetClampMacro(InteractiveUpdateRate, double, 1.0e-10, 1.0e10);
  vtkGetMacro(InteractiveUpdateRate, double);
  ///@}

  ///@{
  /**
   * Whether each pixel's samples lie elsewhere, as of vtkGPUVolumeRayCastMapper: what long steps
   * leave out is noise then, the same in each picture, and no bands. Off by default. Costs a sample
   * more in each region. Has no effect on the nearest reconstruction and on iso-surfaces, which are
   * exact, and where cells of a region are absent: intervals end at their faces.
   */
  vtkSetMacro(UseJittering, bool);
  vtkGetMacro(UseJittering, bool);
  vtkBooleanMacro(UseJittering, bool);
  ///@}

  ///@{
  /**
   * The error to draw with, as a root mean square over red, green, blue and opacity, in [0, 1], of
   * the pixels that are drawn (opacity of at least 1/255), beside the exact integral of the same
   * reconstruction; 0.004 is one of 255 steps. Steps are then chosen for each picture from a few of
   * its pixels, longer ones where the transfer function hardly varies over a region's values and
   * behind what is nearly opaque, and neither StepScale, SampleDistance nor EarlyTerminationOpacity
   * count.
   *
   * Finest levels that the picture hardly needs, as their cells are smaller than pixels or vary
   * little, are left out: the next one's cells take the mean of theirs. For that the device holds
   * the volume without them too, a quarter more memory where blocks are large, up to twice as much
   * in octrees of small ones.
   *
   * Rays go through every eighth pixel along each axis first, and through others where the picture
   * is not as these predict it (Levoy, "Volume rendering by adaptive refinement", The Visual
   * Computer 1990), so that half of the squared error is that of predictions; it is measured on
   * some pixels drawn to check it. Parts of a picture (tiles, eyes, what lies between translucent
   * geometry, volumes that overlap), jittered pictures and those of less than 40 000 pixels have a
   * ray for each pixel.
   *
   * The choice depends on the view and its opaque geometry alone, not on what was drawn before; the
   * parts of a picture have that of the whole, without regard to geometry. 0 (default): step and
   * opacity alone count, and all levels are drawn but while something moves. Has no effect on the
   * nearest reconstruction, which is exact. Below about 1e-4 a picture takes seconds, and single
   * precision is the limit.
   */
  vtkSetClampMacro(ErrorTolerance, double, 0.0, 1.0);
  vtkGetMacro(ErrorTolerance, double);
  ///@}

  ///@{
  /**
   * How rays find their regions: by ray queries on an acceleration structure (VK_KHR_ray_query), or
   * by a k-d tree, which every device can walk. Automatic (default): by ray queries on a GPU that
   * has them. The pictures are the same.
   */
  enum TraversalType
  {
    AUTOMATIC = 0,
    RAY_QUERY = 1,
    KD_TREE = 2
  };
  vtkSetClampMacro(Traversal, int, AUTOMATIC, KD_TREE);
  vtkGetMacro(Traversal, int);
  void SetTraversalToAutomatic() { this->SetTraversal(AUTOMATIC); }
  void SetTraversalToRayQuery() { this->SetTraversal(RAY_QUERY); }
  void SetTraversalToKdTree() { this->SetTraversal(KD_TREE); }
  const char* GetTraversalAsString();
  ///@}

  ///@{
  /**
   * Opacity at which a ray ends. Default 0.999; 1: at the far side of the data.
   */
  vtkSetClampMacro(EarlyTerminationOpacity, double, 0.0, 1.0);
  vtkGetMacro(EarlyTerminationOpacity, double);
  ///@}

  ///@{
  /**
   * What to draw of an array with several components: each (DISABLED, the default), their
   * magnitude, or one of them. The names are those of vtkSmartVolumeMapper. Each, of up to four: if
   * the property has IndependentComponents (its default), with colours, opacity, unit distance and
   * weight of its own; extinctions add up, each times its weight, so that the picture does not
   * depend on the order of components. Dependent ones: of two, the first has colours, the second
   * one opacity; of four, the first three are red, green and blue, up to the greatest number of the
   * array's type or, for floating point, 1, and the last one has opacity. A cell of which one
   * component is not finite is absent. Independent ones are shaded and lessened by their own
   * gradients, each with its material, and projected (maximum to additive) each by itself, colours
   * and greys added up by weight; dependent ones by the gradient of the last component, and by the
   * place where that one is greatest or least; averages and sums are of the first one.
   * Iso-surfaces are those of the independent component of the greatest weight, as if it were
   * alone; of two dependent ones those of the first, with colours and normals of it and the opacity
   * of the second; of four there are none: an error says so.
   */
  enum VectorModeType
  {
    DISABLED = -1,
    MAGNITUDE = 0,
    COMPONENT = 1
  };
  vtkSetClampMacro(VectorMode, int, DISABLED, COMPONENT);
  vtkGetMacro(VectorMode, int);
  void SetVectorModeToDisabled() { this->SetVectorMode(DISABLED); }
  void SetVectorModeToMagnitude() { this->SetVectorMode(MAGNITUDE); }
  void SetVectorModeToComponent() { this->SetVectorMode(COMPONENT); }
  virtual void SetVectorComponent(int component);
  vtkGetMacro(VectorComponent, int);
  ///@}

  ///@{
  /**
   * An array that has the opacity, beside the one with the colours: they are drawn as two dependent
   * components, whatever the property's IndependentComponents. Of the same cells or points; of an
   * array with several components one, or -1: their magnitude; of Transfer2DYAxisArray too. Null
   * (default): there is none.
   */
  vtkSetStringMacro(OpacityArrayName);
  vtkGetStringMacro(OpacityArrayName);
  vtkSetClampMacro(OpacityComponent, int, -1, VTK_INT_MAX);
  vtkGetMacro(OpacityComponent, int);
  ///@}

  ///@{
  /**
   * The array whose values are the second variable of the property's 2-D transfer function, as of
   * vtkGPUVolumeRayCastMapper; null (default): the magnitude of the gradient. A 2-D function
   * (vtkVolumeProperty::SetTransferFunction2D(), SetTransferFunctionMode()) goes over the
   * ranges of both arrays, or over gradients up to a quarter of the range over the mean width of a
   * finest cell. Between samples both variables go evenly, and up to 32 places of the function
   * count. Greatest and least values, surfaces and slices have the function's color and opacity of
   * both variables at their place, means and sums are of the first one. The property's gradient
   * opacity does not count beside it, as in VTK's mapper.
   */
  vtkSetStringMacro(Transfer2DYAxisArray);
  vtkGetStringMacro(Transfer2DYAxisArray);
  ///@}

  ///@{
  /**
   * Whether cells whose value is NaN or infinite show, each as it is, in the NanColor of the
   * property's color function, with its NanOpacity in a unit distance, and unlit. Off by default:
   * they are left out. Hidden cells never show. Counts with blend modes composite and slice, one
   * component and colors of three channels, else a warning says that it does not. No level is left
   * out then for an ErrorTolerance.
   */
  vtkSetMacro(UseNanColor, bool);
  vtkGetMacro(UseNanColor, bool);
  vtkBooleanMacro(UseNanColor, bool);
  ///@}

  ///@{
  /**
   * How light goes through a shaded volume, with blend mode composite, as of
   * vtkGPUVolumeRayCastMapper (VTK 9.2 and later). VolumetricScatteringBlending: 0 (default), all
   * that is seen is reflected by surfaces, along the normals; up to 1, what is thin and where the
   * field does not change rather scatters light as a medium; of 2 everything does, and normals do
   * not count. By the property's ScatteringAnisotropy (VTK 9.2 and later) more of it goes onwards,
   * or back. GlobalIlluminationReach: how far the volume casts shadows on itself, for what is
   * scattered: 0 (default), not at all; 1, through all of the bounds; half as far as they
   * reach along an axis at 0.64, half of their diagonal at 0.88.
   *
   * How much of each light comes to each cell is found once for as long as lights and opacities
   * stay, wherever the camera is, and is reconstructed between cells as the field is: shadows are
   * as fine as the cells are. That takes memory for as many values as cells and lights (of
   * several components for multiples of as many), and for each light about the time in which rays
   * through as many pixels as there are cells are marched: with steps of two cells, or twice the
   * StepScale if that is below 1, whatever the ErrorTolerance. A headlight moves
   * with the camera; while something moves, shadows are those of where the lights were. What is
   * behind opaque geometry is not shadowed by it. Of several volumes, or processes, each casts
   * shadows on itself alone.
   */
  vtkSetClampMacro(GlobalIlluminationReach, float, 0.0f, 1.0f);
  vtkGetMacro(GlobalIlluminationReach, float);
  vtkSetClampMacro(VolumetricScatteringBlending, float, 0.0f, 2.0f);
  vtkGetMacro(VolumetricScatteringBlending, float);
  ///@}

  ///@{
  /**
   * The levels of the AMR that are drawn, from the first to the last number: all by default. See
   * vtkExaBricksBuilder::SetLevelRange().
   */
  vtkSetVector2Macro(LevelRange, int);
  vtkGetVector2Macro(LevelRange, int);
  ///@}

  ///@{
  /**
   * Window and level of the picture's colours, as of vtkGPUVolumeRayCastMapper: a colour c of
   * opacity a becomes c / window + a (1/2 - level / window). 1 and 0.5 by default, which leave it.
   */
  vtkSetMacro(FinalColorWindow, double);
  vtkGetMacro(FinalColorWindow, double);
  vtkSetMacro(FinalColorLevel, double);
  vtkGetMacro(FinalColorLevel, double);
  ///@}

  ///@{
  /**
   * Whether Render() makes images of the size of the viewport and leaves the window as it is, as of
   * vtkGPUVolumeRayCastMapper. Off by default. Geometry and other volumes do not count for them.
   * GetColorImage(): red, green, blue, premultiplied, and opacity, of ColorImageScalarType:
   * VTK_UNSIGNED_CHAR, as bytes, white without opacity beyond the volume's bounds (the default), or
   * VTK_FLOAT, as they are, not cut off at 1, and 0 beyond. GetDepthImage(): window depths of where
   * anything is first seen, of DepthImageScalarType: VTK_FLOAT in [0, 1] (the default),
   * VTK_UNSIGNED_CHAR or VTK_UNSIGNED_SHORT up to their greatest number; where nothing is, the
   * greatest, or with ClampDepthToBackface the depth at which the ray leaves the bounds. Both are
   * without points until the first picture.
   */
  vtkSetMacro(RenderToImage, vtkTypeBool);
  vtkGetMacro(RenderToImage, vtkTypeBool);
  vtkBooleanMacro(RenderToImage, vtkTypeBool);
  virtual void SetColorImageScalarType(int type);
  vtkGetMacro(ColorImageScalarType, int);
  void SetColorImageScalarTypeToUnsignedChar() { this->SetColorImageScalarType(VTK_UNSIGNED_CHAR); }
  void SetColorImageScalarTypeToFloat() { this->SetColorImageScalarType(VTK_FLOAT); }
  virtual void SetDepthImageScalarType(int type);
  vtkGetMacro(DepthImageScalarType, int);
  void SetDepthImageScalarTypeToUnsignedChar() { this->SetDepthImageScalarType(VTK_UNSIGNED_CHAR); }
  void SetDepthImageScalarTypeToUnsignedShort()
  {
    this->SetDepthImageScalarType(VTK_UNSIGNED_SHORT);
  }
  void SetDepthImageScalarTypeToFloat() { this->SetDepthImageScalarType(VTK_FLOAT); }
  vtkSetMacro(ClampDepthToBackface, vtkTypeBool);
  vtkGetMacro(ClampDepthToBackface, vtkTypeBool);
  vtkBooleanMacro(ClampDepthToBackface, vtkTypeBool);
  void GetColorImage(vtkImageData* image);
  void GetDepthImage(vtkImageData* image);
  ///@}

  ///@{
  /**
   * The Vulkan device to render on: its index, or part of its name ("NVIDIA", "lavapipe"). Without
   * it (null or empty, the default) the environment variable EXABRICKS_DEVICE decides, and without
   * that the best device is taken. All mappers of a process share a device.
   */
  vtkSetStringMacro(Device);
  vtkGetStringMacro(Device);
  ///@}

  /// Whether it can draw into the window, as of vtkGPUVolumeRayCastMapper: 1, if that draws with
  /// OpenGL and the Device is there, else 0. The property does not matter: what of it cannot be
  /// drawn is said when it is.
  int IsRenderSupported(vtkRenderWindow* window, vtkVolumeProperty* property);

  /// One line for each Vulkan device: index, name, and what it can do.
  static void GetDevices(vtkStringArray* lines);

  /// Whether the volume is in the last picture of one of the renderers that show it. It is not
  /// where the volume is not visible or culled, where a render was aborted, or where an error has
  /// said, once, why it cannot be drawn.
  bool GetDrawn();

  /// The filter that makes bricks and regions. Its output is up to date after Update().
  vtkExaBricksBuilder* GetBuilder();

  ///@{
  /**
   * Of the last picture: the device's name, the traversal used, the number of regions in which the
   * transfer function shows anything, and the bytes that the volume takes on the device.
   */
  const char* GetDeviceName();
  const char* GetTraversalUsed();
  vtkIdType GetNumberOfActiveRegions();
  vtkTypeInt64 GetDeviceMemory();
  ///@}

  ///@{
  /**
   * Seconds that it took, the last time that each was done, to upload the volume, to upload tables
   * of changed colours, to select the active regions of changed opacities anew, to find how much of
   * the lights comes to the cells, and to march rays.
   */
  double GetUploadTime();
  double GetColorTime();
  double GetOpacityTime();
  double GetShadowTime();
  double GetMarchTime();
  ///@}

  ///@{
  /**
   * With which the last picture was drawn: the distance of its rays in pixels, and by what its
   * steps were multiplied.
   */
  double GetUsedImageSampleDistance();
  double GetUsedStepGrowth();
  ///@}

  /// How many of the finest levels the last picture did without, for the ErrorTolerance, or as
  /// something moves.
  int GetLevelsLeftOut();

  /// How many pixels of the last picture had a ray of their own, of a picture in several passes
  /// each: all, but for those that an ErrorTolerance lets be predicted from others.
  vtkIdType GetNumberOfRays();

  ///@{
  /**
   * The AMR's block, where it has one alone: what programs ask for the range or the size of their
   * image. Null for an AMR of several blocks, which is no vtkDataSet: see GetDataObjectInput().
   */
  vtkDataSet* GetInput() override { return this->GetInput(0); }
  vtkDataSet* GetInput(int port) override;
  ///@}

  /// The same, if scalars at its points are drawn: vtkCellPicker and vtkVolumePicker take it for
  /// the image to pick in.
  vtkDataSet* GetDataSetInput() override;

  double* GetBounds() override;
  void GetBounds(double bounds[6]) override { this->vtkVolumeMapper::GetBounds(bounds); }

  using vtkVolumeMapper::Update;
  /// Brings bricks, regions and values up to date.
  void Update(int port) override;
  void Update() override { this->Update(0); }

  /// In a selector's passes (vtkHardwareSelector, vtkPropPicker, area picks), draws the numbers
  /// that it asks for: of the prop where more than 3/255 of opacity shows, as VTK's GPU mapper
  /// does; of blocks and cells, where cells are selected, at the place at which opacity comes to
  /// 0.05. Where points are selected, nothing is. Of volumes that overlap, each finds its own first
  /// cells, and those of the one that VTK draws last are told.
  void Render(vtkRenderer* ren, vtkVolume* vol) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkExaBricksVolumeMapper();
  ~vtkExaBricksVolumeMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void ReportReferences(vtkGarbageCollector* collector) override;

  int Reconstruction = BASIS;
  double StepScale = 1.0;
  double SampleDistance = 0.0;
  float ImageSampleDistance = 1.0f;
  float MinimumImageSampleDistance = 1.0f;
  float MaximumImageSampleDistance = 10.0f;
  vtkTypeBool AutoAdjustSampleDistances = 1;
  vtkTypeBool InteractiveAdjustSampleDistances = 1;
  double InteractiveUpdateRate = 1.0;
  bool UseJittering = false;
  double ErrorTolerance = 0.0;
  int Traversal = AUTOMATIC;
  double EarlyTerminationOpacity = 0.999;
  int VectorMode = DISABLED;
  int VectorComponent = 0;
  char* OpacityArrayName = nullptr;
  int OpacityComponent = 0;
  char* Transfer2DYAxisArray = nullptr;
  bool UseNanColor = false;
  float GlobalIlluminationReach = 0.0f;
  float VolumetricScatteringBlending = 0.0f;
  int LevelRange[2] = { 0, VTK_INT_MAX };
  double FinalColorWindow = 1.0;
  double FinalColorLevel = 0.5;
  vtkTypeBool RenderToImage = 0;
  int ColorImageScalarType = VTK_UNSIGNED_CHAR;
  int DepthImageScalarType = VTK_FLOAT;
  vtkTypeBool ClampDepthToBackface = 0;
  char* Device = nullptr;

private:
  friend class vtkExaBricksPicker;
  // Where the volume is first seen at a place of the renderer's window, in half cells of the
  // builder's output. None: nowhere.
  std::optional<exabricks::FirstSeen> FindFirstSeen(
    vtkRenderer* ren, vtkVolume* vol, double displayX, double displayY, double opacity);

  vtkExaBricksVolumeMapper(const vtkExaBricksVolumeMapper&) = delete;
  void operator=(const vtkExaBricksVolumeMapper&) = delete;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
