// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkExaBricksFirstPicture
 * @brief   chooses colors, opacities and a camera for AMR that nobody has looked at yet
 *
 * VTK's default opacity and unit distance leave AMR next to invisible, or opaque. This looks at the
 * leaf cells and chooses what shows them: rare values are opaque, and the most common ones, which
 * together hold 80 % of the cells, are clear. The camera frames what shows.
 *
 * @code
 * mapper->Update();
 * vtkNew<vtkExaBricksFirstPicture> picture;
 * if (picture->Choose(mapper->GetBuilder()->GetOutput()))
 * {
 *   picture->InitializeProperty(volume->GetProperty());
 *   picture->InitializeCamera(renderer->GetActiveCamera(), 4.0 / 3.0);
 * }
 * @endcode
 *
 * Where GetLogarithmWanted(), the logarithm of the array shows more: add it to the blocks as an
 * array of its own, draw that, and SetLogarithmic(true) before Choose().
 *
 * @sa
 * vtkExaBricksVolumeMapper vtkExaBricksData
 */
#ifndef vtkExaBricksFirstPicture_h
#define vtkExaBricksFirstPicture_h

#include "vtkObject.h"
#include "vtkRenderingVolumeExaBricksModule.h" // for the export macro
#include "vtkVolumeMapper.h"                   // for its blend modes

#include <string> // for names

class vtkCamera;
class vtkColorTransferFunction;
class vtkExaBricksData;
class vtkOverlappingAMR;
class vtkPiecewiseFunction;
class vtkVolumeProperty;

class VTKRENDERINGVOLUMEEXABRICKS_EXPORT vtkExaBricksFirstPicture : public vtkObject
{
public:
  static vtkExaBricksFirstPicture* New();
  vtkTypeMacro(vtkExaBricksFirstPicture, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether values are logarithms to the base of 10: of those no more than eight decades show, and
   * none below the most common one. Default false.
   */
  vtkSetMacro(Logarithmic, bool);
  vtkGetMacro(Logarithmic, bool);
  vtkBooleanMacro(Logarithmic, bool);
  ///@}

  ///@{
  /**
   * The way of blending that the picture is for, of vtkVolumeMapper::BlendModes. Default
   * COMPOSITE_BLEND. Of the greatest value opacity rises along the range; all others show all
   * values as they are, and all of the bounds but for iso-surfaces. For ADDITIVE_BLEND the unit
   * distance is the length by which sums become bright.
   */
  vtkSetMacro(BlendMode, int);
  vtkGetMacro(BlendMode, int);
  ///@}

  /// Chooses by the first component of `data`. False, with an error, if it has no cell with a
  /// value; then all is as it was.
  bool Choose(vtkExaBricksData* data);

  ///@{
  /**
   * What was chosen: the range of values over which a color map is spread; the length, in the
   * data's own coordinates, for which opacities hold; the bounds, in the same coordinates, of the
   * part that holds all but a fiftieth, along each axis, of what shows; and whether, of values that
   * are no logarithms, logarithms would show more.
   */
  vtkGetVector2Macro(ColorRange, double);
  vtkGetMacro(ScalarOpacityUnitDistance, double);
  vtkGetVector6Macro(ShownBounds, double);
  vtkGetMacro(LogarithmWanted, bool);
  ///@}

  /// Opacities of the unit distance, with values of the array.
  vtkPiecewiseFunction* GetScalarOpacity() { return this->ScalarOpacity; }

  ///@{
  /**
   * The color map of InitializeProperty(): viridis, plasma, inferno, magma, cividis, turbo, gray or
   * cool-warm. Default viridis. An unknown name is an error, and changes nothing.
   */
  void SetColorMap(const std::string& name);
  const std::string& GetColorMap() const { return this->ColorMap; }
  /// All names, separated by a comma and a blank.
  static std::string GetColorMapNames();
  static bool HasColorMap(const std::string& name);
  /// Spreads a map over a range, or around its one value; values outside take the end colors.
  static void FillColorMap(
    const std::string& name, const double range[2], vtkColorTransferFunction* colors);
  ///@}

  ///@{
  /**
   * What is drawn of data with many arrays: how gladly one of that name, from 0 on: density and
   * temperature before others. Whether an array tells how much of each cell is fluid (vfrac,
   * volFrac, vol_frac), and a way to mark the cells as hidden of which nothing is, as the values
   * that codes write into embedded boundaries mean nothing: returns how many they are.
   */
  static int GetArrayPreference(const std::string& array);
  static bool IsVolumeFraction(const std::string& array);
  static vtkIdType HideCoveredCells(vtkOverlappingAMR* amr);
  ///@}

  /// Adds log10 of a cell array to every block that has it, as an array of doubles, and returns its
  /// name, "log10(array)". Of several components one is taken, which is part of the name, or the
  /// magnitude where `component` is negative. Where there is no logarithm the value is NaN, which
  /// the mapper takes for absent.
  static std::string AddLogarithm(
    vtkOverlappingAMR* amr, const std::string& array, int component = -1);

  /// Sets colors, opacities and unit distance of all components, and linear interpolation. Each
  /// call makes new functions.
  void InitializeProperty(vtkVolumeProperty* property);

  /// Looks at all of ShownBounds from the front right and above, in a picture `aspect` times as
  /// wide as it is high. The clipping range is left to the renderer.
  void InitializeCamera(vtkCamera* camera, double aspect);

  /// Moves the camera along its direction of projection, to where all of the bounds is in the
  /// picture around its focal point, with 5 % of margin. Parallel scale likewise.
  static void FitCamera(vtkCamera* camera, const double bounds[6], double aspect);

protected:
  vtkExaBricksFirstPicture();
  ~vtkExaBricksFirstPicture() override;

  bool Logarithmic = false;
  bool LogarithmWanted = false;
  int BlendMode = vtkVolumeMapper::COMPOSITE_BLEND;
  double ColorRange[2] = { 0.0, 1.0 };
  double ScalarOpacityUnitDistance = 1.0;
  double ShownBounds[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  std::string ColorMap = "viridis";

private:
  vtkExaBricksFirstPicture(const vtkExaBricksFirstPicture&) = delete;
  void operator=(const vtkExaBricksFirstPicture&) = delete;

  vtkPiecewiseFunction* const ScalarOpacity;
};

#endif
