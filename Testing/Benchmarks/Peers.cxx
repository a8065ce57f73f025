// SPDX-License-Identifier: BSD-3-Clause
#include "Methods.h"
#include "PeerMappers.h"
#include "WindowImage.h"

#include "Display.h"

#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

namespace exabricks
{
namespace benchmarks
{
namespace
{
constexpr int ResampledCells = 256; // along each axis

PeerData dataOf(const Subject& subject)
{
  const vtkExaBricksData::Contents& contents = subject.contents();
  const glm::dvec3 lo = contents.World(glm::dvec3(0.0));
  const glm::dvec3 hi = contents.World(2.0 * glm::dvec3(contents.Structure->tree.bounds.size()));
  const glm::dvec3& spacing = contents.Spacing;
  return { subject.amr(), subject.array(), subject.component(), lo, hi,
    std::min({ spacing.x, spacing.y, spacing.z }) };
}

// A window with the subject's camera and functions.
Method makeWindowMethod(
  const Subject& subject, const Request& request, const std::string& name, vtkVolumeMapper* mapper)
{
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(subject.property()->GetRGBTransferFunction());
  property->SetScalarOpacity(subject.property()->GetScalarOpacity());
  property->SetScalarOpacityUnitDistance(subject.property()->GetScalarOpacityUnitDistance());
  property->SetInterpolationTypeToLinear();
  property->ShadeOff();
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  renderer->SetBackground(0.0, 0.0, 0.0);
  renderer->SetActiveCamera(subject.renderer()->GetActiveCamera());
  auto window = render::MakeWindow();
  window->AddRenderer(renderer);
  window->SetDesiredUpdateRate(0.0001); // never coarser for the sake of speed

  Method method;
  method.name = name;
  const auto drawAt = [window](const std::array<int, 2>& size)
  {
    window->SetSize(size[0], size[1]);
    window->Render();
    window->WaitForCompletion();
  };
  method.draw = [=, size = request.draw.Size] { drawAt(size); };
  method.picture = [=, size = request.accuracySize]
  {
    drawAt(size);
    return readWindow(window);
  };
  return method;
}

Method makeMultiBlock(const Subject& subject, const Request& request, bool blanked)
{
  Method method;
  Costs setUp;
  setUp.measure(
    [&]
    {
      const auto mapper = makeMultiBlockMapper(dataOf(subject), blanked);
      method = makeWindowMethod(subject, request,
        blanked ? "vtkMultiBlockVolumeMapper, covered cells blanked"
                : "vtkMultiBlockVolumeMapper, all blocks",
        mapper);
      method.draw();
    });
  method.setUp = setUp.wall.front();
  return method;
}

Method makeResampled(const Subject& subject, const Request& request)
{
  Method method;
  Costs setUp;
  setUp.measure(
    [&]
    {
      const auto mapper = makeResampledMapper(dataOf(subject), ResampledCells);
      method = makeWindowMethod(
        subject, request, "vtkResampleToImage 256^3, vtkGPUVolumeRayCastMapper", mapper);
      method.draw();
    });
  method.setUp = setUp.wall.front();
  return method;
}
}

std::vector<Method> makePeers(const Subject& subject, const Request& request)
{
  return { makeMultiBlock(subject, request, false), makeMultiBlock(subject, request, true),
    makeResampled(subject, request) };
}
}
}
