// SPDX-License-Identifier: BSD-3-Clause
#include "Resampling.h"

#include "Method.h" // LongestSetUp
#include "Timing.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkResampleToImage.h"

#include <cmath>
#include <map>

namespace exabricks
{
namespace benchmarks
{
namespace
{
constexpr int Smallest = 128; // what estimates go by

std::map<std::pair<const Scene*, int>, ResampledGrid>& grids()
{
  static std::map<std::pair<const Scene*, int>, ResampledGrid> made;
  return made;
}

vtkSmartPointer<vtkImageData> makeGrid(const PeerData& data, int cells)
{
  const glm::dvec3 spacing = (data.hi - data.lo) / static_cast<double>(cells);
  const glm::dvec3 first = data.lo + 0.5 * spacing;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetOrigin(first.x, first.y, first.z);
  image->SetSpacing(spacing.x, spacing.y, spacing.z);
  image->SetDimensions(cells, cells, cells);
  return image;
}

vtkSmartPointer<vtkImageData> resample(const PeerData& data, int cells)
{
  auto image = makeGrid(data, cells);
  double bounds[6];
  image->GetBounds(bounds);
  vtkNew<vtkResampleToImage> sample;
  sample->SetInputDataObject(data.amr);
  sample->UseInputBoundsOff();
  sample->SetSamplingBounds(bounds);
  sample->SetSamplingDimensions(cells, cells, cells);
  sample->Update();
  image->GetPointData()->SetScalars(
    sample->GetOutput()->GetPointData()->GetArray(data.array.c_str()));
  return image;
}

// From the coarsest level to the finest, so that the finest cell's value stays.
vtkSmartPointer<vtkImageData> fill(const Scene& scene, const PeerData& data, int cells)
{
  auto image = makeGrid(data, cells);
  vtkNew<vtkFloatArray> values;
  values->SetName(data.array.c_str());
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  values->Fill(0.0);
  const Hierarchy& hierarchy = scene.model().hierarchy;
  const Box& bounds = scene.structure().tree.bounds;
  const glm::dvec3 width = glm::dvec3(bounds.size()) / static_cast<double>(cells); // logical
  std::vector<double> blockValues;
  for (int level = 0; level < hierarchy.levels(); ++level)
  {
    for (std::size_t b = 0; b < hierarchy.blocks.size(); ++b)
    {
      const Block& block = hierarchy.blocks[b];
      if (block.level != level)
      {
        continue;
      }
      blockValues.resize(static_cast<std::size_t>(block.cells.volume()));
      scene.model().cells->read(static_cast<int>(b), block.cells, blockValues.data());
      const Box box = hierarchy.logicalBox(block);
      const glm::dvec3 lo = (glm::dvec3(box.lo - bounds.lo)) / width - 0.5;
      const glm::dvec3 hi = (glm::dvec3(box.hi - bounds.lo)) / width - 0.5;
      const Int3 first = glm::max(Int3(glm::ceil(lo)), Int3(0));
      const Int3 last = glm::min(Int3(glm::ceil(hi)), Int3(cells));
      const Int3 size = block.cells.size();
      for (std::int64_t z = first.z; z < last.z; ++z)
      {
        for (std::int64_t y = first.y; y < last.y; ++y)
        {
          for (std::int64_t x = first.x; x < last.x; ++x)
          {
            const glm::dvec3 at = (glm::dvec3(x, y, z) + 0.5) * width + glm::dvec3(bounds.lo);
            const Int3 cell(glm::floor(at / static_cast<double>(hierarchy.cellWidth[level])));
            const Int3 in = glm::clamp(cell - block.cells.lo, Int3(0), size - std::int64_t(1));
            const double value = blockValues[in.x + size.x * (in.y + size.y * in.z)];
            if (std::isfinite(value))
            {
              values->SetValue(x + cells * (y + cells * z), static_cast<float>(value));
            }
          }
        }
      }
    }
  }
  image->GetPointData()->SetScalars(values);
  return image;
}
}

const ResampledGrid& resampled(const Scene& scene, int cells)
{
  const auto found = grids().find({ &scene, cells });
  if (found != grids().end())
  {
    return found->second;
  }
  double estimate = 0.0;
  if (cells > Smallest)
  {
    estimate = resampled(scene, Smallest).seconds * std::pow(cells / double(Smallest), 3.0);
  }
  const PeerData data = makePeerData(scene);
  ResampledGrid grid;
  grid.estimated = estimate > LongestSetUp;
  Costs costs;
  // A vector's component or magnitude is VTK's own business.
  costs.measure(
    [&] { grid.image = grid.estimated ? fill(scene, data, cells) : resample(data, cells); });
  grid.seconds = grid.estimated ? estimate : costs.wall.front();
  grid.bytes = 1024.0 * static_cast<double>(grid.image->GetActualMemorySize());
  return grids()[{ &scene, cells }] = grid;
}

void forgetResampled(const Scene& scene)
{
  for (auto i = grids().begin(); i != grids().end();)
  {
    i = i->first.first == &scene ? grids().erase(i) : std::next(i);
  }
}
}
}
