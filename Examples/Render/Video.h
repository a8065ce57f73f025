// SPDX-License-Identifier: BSD-3-Clause
// Pictures into a video, by the program ffmpeg, which reads them from a pipe.

#ifndef ExaBricksRenderVideo_h
#define ExaBricksRenderVideo_h

#include <cstdio>
#include <string>

class vtkImageData;

namespace render
{

class Video
{
public:
  // Whether a path's ending is that of a video: .mp4, .mkv or .webm.
  static bool IsOne(const std::string& path);
  // Before the long work. Throws Failure(OutputUnwritable) if there is no ffmpeg, or the path leads
  // to what is no regular file.
  static void Check(const std::string& path);

  // A file at the path replaces another one when all is done. framesPerSecond: of the pictures.
  Video(const std::string& path, double framesPerSecond);
  // Leaves nothing behind that is not finished.
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;

  // Red, green and blue in bytes; all of one size. Throws Failure(OutputUnwritable).
  void Add(vtkImageData* picture);
  void Finish();

private:
  void Start(int width, int height);
  int Close(); // returns 0 if the program ended well

  const std::string Path;
  const std::string Part; // the file as long as it grows
  const double Rate;
  std::FILE* Pipe = nullptr;
  int Process = 0;
};

}

#endif
