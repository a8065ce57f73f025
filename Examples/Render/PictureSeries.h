// SPDX-License-Identifier: BSD-3-Clause
// Where several pictures go: numbered files, or a video.

#ifndef ExaBricksRenderPictureSeries_h
#define ExaBricksRenderPictureSeries_h

#include "Video.h"

#include <memory>
#include <string>

class vtkImageData;

namespace render
{

class PictureSeries
{
public:
  // A path that ends as a picture does gets a number before its ending: picture-0000.png.
  PictureSeries(const std::string& path, double framesPerSecond);

  // Throw Failure(OutputUnwritable).
  void Add(vtkImageData* picture);
  void Finish();

private:
  const std::string Path;
  std::unique_ptr<Video> AsVideo; // null: numbered files
  int Count = 0;
};

}

#endif
