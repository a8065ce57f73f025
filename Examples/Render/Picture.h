// SPDX-License-Identifier: BSD-3-Clause
// One volume in a window off screen: sets it up from the options and the data, draws and times it.

#ifndef ExaBricksRenderPicture_h
#define ExaBricksRenderPicture_h

#include "Options.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkExaBricksData;
class vtkExaBricksFirstPicture;
class vtkExaBricksVolumeMapper;
class vtkImageData;
class vtkOverlappingAMR;
class vtkRenderer;
class vtkRenderWindow;
class vtkVolume;

namespace render
{

class Picture
{
public:
  // components: of the array.
  Picture(const Options& options, vtkRenderWindow* window, vtkOverlappingAMR* amr,
    const std::string& array, int components);
  ~Picture();

  // Builds bricks and regions, then chooses what the options leave to the data.
  void Prepare();

  // Axes around the data, and a scalar bar with a title. After Prepare().
  void Annotate(const std::string& title);

  // Draws once, then as often as is to be timed.
  void Draw();

  // Draws another data set with the same array, by the same camera, colours and opacities.
  void DrawOther(vtkOverlappingAMR* amr);

  // Draws after the camera has gone around the upward axis by so many degrees.
  void Turn(double degrees);

  // As it is in the window, in bytes.
  vtkSmartPointer<vtkImageData> Pixels() const;
  // Of the volume alone: red, green and blue, premultiplied, and opacity.
  vtkSmartPointer<vtkImageData> Floats();
  // What the output's ending asks for.
  vtkSmartPointer<vtkImageData> Result();

  vtkExaBricksVolumeMapper* Mapper() const;
  vtkExaBricksData* Data() const;
  vtkRenderer* Renderer() const;

  // Whether logarithms of the array would show more. After Prepare().
  bool LogarithmWanted() const;

  // In the values drawn: logarithms if the options ask for them.
  double ColorRange[2] = { 0.0, 1.0 };
  std::vector<OpacityPoint> Opacity;
  double OpacityUnit = 1.0;

  // Seconds.
  double PrepareTime = 0.0;
  double FirstFrameTime = 0.0;
  std::vector<double> FrameTimes;
  double MedianFrameTime() const; // of the frames after the first

private:
  void SetUpMapper(const std::string& array, int components);
  void SetUpBlending();
  bool ShowsAsChosen() const;
  void ChooseOpacity();
  void ApplyProperty();
  double DrawFrame();

  const Options& Asked;
  vtkSmartPointer<vtkExaBricksVolumeMapper> VolumeMapper;
  vtkSmartPointer<vtkExaBricksFirstPicture> Chosen;
  vtkSmartPointer<vtkVolume> Volume;
  vtkSmartPointer<vtkRenderer> Ren;
  vtkSmartPointer<vtkRenderWindow> Window;
};

}

#endif
