// SPDX-License-Identifier: BSD-3-Clause
#include "PictureFile.h"

#include "Output.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace exabricks
{
namespace benchmarks
{
std::string pictureFileName(const std::string& text)
{
  std::string name;
  for (const char c : text)
  {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) || c == '.';
    if (plain || (!name.empty() && name.back() != '_'))
    {
      name += plain ? c : '_';
    }
  }
  return name + ".png";
}

void writePicture(const reference::Image& image, const std::string& folder, const std::string& name)
{
  vtkNew<vtkImageData> pixels;
  pixels->SetDimensions(image.width, image.height, 1);
  pixels->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* out = static_cast<unsigned char*>(pixels->GetScalarPointer());
  for (const glm::dvec4& pixel : image.pixels)
  {
    for (int c = 0; c < 3; ++c)
    {
      *out++ = static_cast<unsigned char>(std::lround(255.0 * std::clamp(pixel[c], 0.0, 1.0)));
    }
  }
  render::writePicture((std::filesystem::path(folder) / name).string(), pixels);
}
}
}
