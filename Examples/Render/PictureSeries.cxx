// SPDX-License-Identifier: BSD-3-Clause

#include "PictureSeries.h"

#include "Output.h"

#include <filesystem>
#include <iomanip>
#include <sstream>

namespace render
{

PictureSeries::PictureSeries(const std::string& path, double framesPerSecond)
  : Path(path)
  , AsVideo(Video::IsOne(path) ? std::make_unique<Video>(path, framesPerSecond) : nullptr)
{
}

void PictureSeries::Add(vtkImageData* picture)
{
  if (this->AsVideo)
  {
    this->AsVideo->Add(picture);
    return;
  }
  const std::filesystem::path path(this->Path);
  std::ostringstream name;
  name << path.stem().string() << '-' << std::setw(4) << std::setfill('0') << this->Count++
       << path.extension().string();
  writePicture((path.parent_path() / name.str()).string(), picture);
}

void PictureSeries::Finish()
{
  if (this->AsVideo)
  {
    this->AsVideo->Finish();
  }
}

}
