// SPDX-License-Identifier: BSD-3-Clause
#include "Methods.h"

#include "WindowImage.h"

#include "Adapters/TransferFunctionInput.h"

#include "Output.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <cmath>
#include <stdexcept>

namespace exabricks
{
namespace benchmarks
{
namespace
{
void check(const std::string& fault)
{
  if (!fault.empty())
  {
    throw std::runtime_error(fault);
  }
}

double psnrRGB(const reference::Image& a, const reference::Image& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double d = a.pixels[i][c] - b.pixels[i][c];
      sum += d * d;
    }
  }
  return -10.0 * std::log10(sum / (3.0 * static_cast<double>(a.pixels.size())));
}

// On black.
void write(const reference::Image& image, const std::string& path)
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
  render::WritePNG(path, pixels);
}
}

void measureInTurn(std::vector<Method>& methods, int rounds)
{
  for (int round = -1; round < rounds; ++round)
  {
    for (Method& method : methods)
    {
      if (round < 0)
      {
        method.draw();
        continue;
      }
      method.costs.measure(method.draw);
      if (method.march)
      {
        method.marches.push_back(method.march());
      }
    }
  }
}

void judge(std::vector<Method>& methods, const reference::Image& oracle, const std::string& prefix)
{
  if (!prefix.empty())
  {
    write(oracle, prefix + "oracle.png");
  }
  int number = 0;
  for (Method& method : methods)
  {
    const reference::Image image = method.picture();
    method.decibelRGB = psnrRGB(image, oracle);
    if (method.hasOpacity)
    {
      method.decibelRGBA = reference::psnr(image, oracle);
      method.decibelDrawn = reference::psnrOfDrawn(image, oracle);
    }
    if (!prefix.empty())
    {
      write(image, prefix + "method" + std::to_string(++number) + ".png");
    }
  }
}

DirectRenderer::DirectRenderer(const Subject& subject, Traversal traversal)
{
  Costs costs;
  costs.measure(
    [&]
    {
      const vtkExaBricksData::Contents& contents = subject.contents();
      this->renderer.selectTraversal(traversal);
      this->renderer.selectDevice("");
      this->renderer.setVolume({ &contents.Structure->tree, &contents.Structure->bricks,
        &contents.Structure->hierarchy.cellWidth, &contents.Scalars, &contents.Ranges });
      this->setTransferFunction(makeTransferFunction(subject.property(), contents.Scalars.range));
    });
  this->setUp = costs.wall.front();
}

void DirectRenderer::setTransferFunction(const TransferFunction& transfer)
{
  this->renderer.setTransferFunction(transfer);
  check(this->renderer.prepare());
}

void DirectRenderer::render(const View& view) { check(this->renderer.render(view, this->pixels)); }

reference::Image DirectRenderer::image(const View& view)
{
  this->render(view);
  return { view.width, view.height, { this->pixels.begin(), this->pixels.end() } };
}

Method makeDirectMethod(const Subject& subject, const Request& request, DirectRenderer& direct,
  const std::string& name, double stepScale, double buildTime)
{
  Method method;
  method.name = name;
  method.setUp = buildTime + direct.setUp;
  method.hasOpacity = true;
  const View timed = subject.makeView(request.draw.Size, stepScale);
  const View judged = subject.makeView(request.accuracySize, stepScale);
  method.draw = [&direct, timed] { direct.render(timed); };
  method.picture = [&direct, judged] { return direct.image(judged); };
  method.march = [&direct] { return direct.renderer.statistics().marchTime; };
  return method;
}

Method makeMapperMethod(const Subject& subject, const Request& request, double buildTime)
{
  Method method;
  method.name = "vtkExaBricksVolumeMapper in a window";
  vtkRenderWindow* window = subject.window();
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
  Costs first;
  first.measure(method.draw);
  method.setUp = buildTime + first.wall.front();
  return method;
}
}
}
