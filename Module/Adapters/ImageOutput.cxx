// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/ImageOutput.h"

#include "Adapters/FirstSeen.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>

namespace exabricks
{
namespace
{
// Less of opacity does not show.
constexpr double SeenOpacity = 0.5 / 255.0;
constexpr float NoDepth = 2.0f;

void prepare(vtkImageData* image, int width, int height)
{
  image->Initialize();
  image->SetDimensions(width, height, std::min({ width, height, 1 }));
}
}

std::string ImageOutput::draw(
  VolumeRenderer& renderer, View view, const glm::dvec3& size, const ColorWindow& colors)
{
  view.target.depth = nullptr;
  std::vector<glm::vec4> picture;
  std::string fault = renderer.render(view, picture);
  if (!fault.empty() || picture.empty())
  {
    return fault;
  }
  const std::vector<std::optional<FirstSeen>> seen =
    findFirstSeen(renderer, view, size, SeenOpacity, fault);
  if (!fault.empty() || seen.size() != picture.size())
  {
    return fault;
  }
  colors.apply(picture);
  this->Width = view.target.width;
  this->Height = view.target.height;
  this->Colors = std::move(picture);
  this->FirstDepths.assign(seen.size(), NoDepth);
  this->BackDepths.assign(seen.size(), NoDepth);
  const glm::dmat4 toNdc = glm::inverse(view.camera.ndcToHalfCells);
  const auto depthOf = [&](const glm::dvec3& place)
  {
    const glm::dvec4 ndc = toNdc * glm::dvec4(place, 1.0);
    return static_cast<float>(std::clamp(0.5 + 0.5 * ndc.z / ndc.w, 0.0, 1.0));
  };
  for (std::size_t i = 0; i < seen.size(); ++i)
  {
    if (const std::optional<LineOfSight> line = findLine(view, middleOfPixel(view, i), size))
    {
      this->BackDepths[i] = depthOf(line->to);
    }
    if (seen[i])
    {
      this->FirstDepths[i] = depthOf(seen[i]->place);
    }
  }
  return {};
}

void ImageOutput::getColors(int scalarType, vtkImageData* image) const
{
  prepare(image, this->Width, this->Height);
  const auto colors =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(scalarType));
  colors->SetName("colors");
  colors->SetNumberOfComponents(4);
  colors->SetNumberOfTuples(static_cast<vtkIdType>(this->Colors.size()));
  for (std::size_t i = 0; i < this->Colors.size(); ++i)
  {
    const auto tuple = static_cast<vtkIdType>(i);
    if (scalarType == VTK_FLOAT)
    {
      const glm::vec4& color = this->Colors[i];
      colors->SetTuple4(tuple, color.r, color.g, color.b, color.a);
      continue;
    }
    const glm::vec4 color = glm::round(255.0f *
      glm::clamp(this->BackDepths[i] > 1.0f ? glm::vec4(1.0f, 1.0f, 1.0f, 0.0f) : this->Colors[i],
        0.0f, 1.0f));
    colors->SetTuple4(tuple, color.r, color.g, color.b, color.a);
  }
  image->GetPointData()->SetScalars(colors);
}

void ImageOutput::getDepths(int scalarType, bool clampToBackFace, vtkImageData* image) const
{
  prepare(image, this->Width, this->Height);
  const auto depths =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(scalarType));
  depths->SetName("depths");
  depths->SetNumberOfTuples(static_cast<vtkIdType>(this->FirstDepths.size()));
  const double greatest = scalarType == VTK_FLOAT ? 1.0 : depths->GetDataTypeMax();
  for (std::size_t i = 0; i < this->FirstDepths.size(); ++i)
  {
    const bool seen = this->FirstDepths[i] <= 1.0f;
    const float depth = std::min(seen ? this->FirstDepths[i]
        : clampToBackFace             ? this->BackDepths[i]
                                      : 1.0f,
      1.0f);
    const double scaled = greatest * depth;
    depths->SetTuple1(
      static_cast<vtkIdType>(i), scalarType == VTK_FLOAT ? scaled : std::round(scaled));
  }
  image->GetPointData()->SetScalars(depths);
}
}
