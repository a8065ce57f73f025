// SPDX-License-Identifier: BSD-3-Clause
#include "Changes.h"

#include "Adapters/TransferFunctionInput.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeProperty.h"

namespace exabricks
{
namespace benchmarks
{
namespace
{
vtkSmartPointer<vtkVolumeProperty> makeProperty(
  vtkColorTransferFunction* colors, vtkPiecewiseFunction* opacity)
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetColor(colors);
  property->SetScalarOpacity(opacity);
  return property;
}

vtkSmartPointer<vtkColorTransferFunction> swapRedAndBlue(vtkColorTransferFunction* from)
{
  auto colors = vtkSmartPointer<vtkColorTransferFunction>::New();
  double node[6];
  for (int i = 0; i < from->GetSize(); ++i)
  {
    from->GetNodeValue(i, node);
    colors->AddRGBPoint(node[0], node[3], node[2], node[1], node[4], node[5]);
  }
  return colors;
}

vtkSmartPointer<vtkPiecewiseFunction> scale(vtkPiecewiseFunction* from, double factor)
{
  auto opacity = vtkSmartPointer<vtkPiecewiseFunction>::New();
  double node[4];
  for (int i = 0; i < from->GetSize(); ++i)
  {
    from->GetNodeValue(i, node);
    opacity->AddPoint(node[0], factor * node[1], node[2], node[3]);
  }
  return opacity;
}

// Clear below the middle of the values that show.
vtkSmartPointer<vtkPiecewiseFunction> cutOff(vtkPiecewiseFunction* from)
{
  auto opacity = scale(from, 1.0);
  double shown[2] = { from->GetRange()[1], from->GetRange()[0] };
  double node[4];
  for (int i = 0; i < from->GetSize(); ++i)
  {
    from->GetNodeValue(i, node);
    if (node[1] > 0.0)
    {
      shown[0] = std::min(shown[0], node[0]);
      shown[1] = std::max(shown[1], node[0]);
    }
  }
  const double middle = 0.5 * (shown[0] + shown[1]);
  const double height = from->GetValue(middle);
  opacity->AddSegment(from->GetRange()[0], 0.0, middle, 0.0); // takes out the points between
  opacity->AddPoint(middle + 1e-6 * (shown[1] - shown[0]), height);
  return opacity;
}

struct Traverser
{
  DirectRenderer& direct;
  const char* name;
};

// Counts as kept what the renderer did not time anew.
void look(
  Change& change, const VolumeRenderer::Statistics& before, const VolumeRenderer::Statistics& after)
{
  change.keptVolume = change.keptVolume && before.uploadTime == after.uploadTime;
  if (before.colorTime != after.colorTime)
  {
    change.keptColors = false;
    change.color.push_back(after.colorTime);
  }
  if (before.opacityTime != after.opacityTime)
  {
    change.keptOpacity = false;
    change.opacity.push_back(after.opacityTime);
  }
  if (before.marchTime != after.marchTime)
  {
    change.march.push_back(after.marchTime);
  }
}
}

double meanOpacity(const reference::Image& image)
{
  double sum = 0.0;
  for (const glm::dvec4& pixel : image.pixels)
  {
    sum += pixel.a;
  }
  return sum / static_cast<double>(image.pixels.size());
}

std::vector<Change> measureChanges(
  const Subject& subject, const Request& request, DirectRenderer& kdTree, DirectRenderer& rayQuery)
{
  const Range& range = subject.contents().Scalars.range;
  vtkColorTransferFunction* colors = subject.property()->GetRGBTransferFunction();
  vtkPiecewiseFunction* opacity = subject.property()->GetScalarOpacity();
  const auto original = makeProperty(colors, opacity);
  const std::vector<std::pair<std::string, vtkSmartPointer<vtkVolumeProperty>>> others{
    { "colours", makeProperty(swapRedAndBlue(colors), opacity) },
    { "height of opacity", makeProperty(colors, scale(opacity, 0.9)) },
    { "values that show", makeProperty(colors, cutOff(opacity)) }
  };
  const Traverser traversers[] = { { kdTree, "k-d tree" }, { rayQuery, "ray query" } };
  std::vector<Change> changes;
  for (const auto& other : others)
  {
    std::vector<Change> pair{ { other.first, traversers[0].name },
      { other.first, traversers[1].name } };
    for (int i = 0; i < 2 * request.rounds; ++i)
    {
      vtkVolumeProperty* property = i % 2 == 0 ? other.second : original;
      for (int t = 0; t < 2; ++t)
      {
        DirectRenderer& direct = traversers[t].direct;
        const auto before = direct.renderer.statistics();
        pair[t].total.measure(
          [&] { direct.setTransferFunction(makeTransferFunction(property, range)); });
        look(pair[t], before, direct.renderer.statistics());
      }
    }
    changes.insert(changes.end(), pair.begin(), pair.end());
  }

  std::vector<Change> pair{ { "camera", traversers[0].name }, { "camera", traversers[1].name } };
  vtkCamera* camera = subject.renderer()->GetActiveCamera();
  for (int i = 0; i < 2 * request.rounds; ++i)
  {
    camera->Azimuth(i % 2 == 0 ? 5.0 : -5.0);
    const View view = subject.makeView(request.draw.Size, 1.0);
    for (int t = 0; t < 2; ++t)
    {
      DirectRenderer& direct = traversers[t].direct;
      const auto before = direct.renderer.statistics();
      pair[t].total.measure([&] { direct.render(view); });
      look(pair[t], before, direct.renderer.statistics());
    }
  }
  changes.insert(changes.end(), pair.begin(), pair.end());
  return changes;
}
}
}
