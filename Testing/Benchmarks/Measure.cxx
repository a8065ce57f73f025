// SPDX-License-Identifier: BSD-3-Clause
#include "Measure.h"

#include "Changes.h"
#include "PictureErrors.h"
#include "PictureFile.h"
#include "Resampling.h"
#include "Timing.h"

#include "Reference/Similarity.h"

#include <cmath>
#include <iostream>

namespace exabricks
{
namespace benchmarks
{
namespace
{
using reference::Image;

// A method with one value of its parameter.
struct Entry
{
  const MethodKind* kind;
  Method* method;
  double value;
  Costs costs;
  std::vector<double> marches;
  Result row;
};

std::vector<double> valuesOf(const MethodKind& kind, const Plan& plan)
{
  if (kind.parameter == StepScale && !plan.stepScales.empty())
  {
    return plan.stepScales;
  }
  std::vector<double> values = plan.quick ? kind.few : kind.all;
  if (kind.role == Role::Peer)
  {
    values.erase(std::remove_if(values.begin(), values.end(),
                   [&](double value) { return value > plan.largestGrid; }),
      values.end());
  }
  return values;
}

Result makeRow(const Scene& scene, const MethodKind& kind, double value, const SetUp& setUp)
{
  Result row;
  row.scene = scene.name();
  row.method = kind.name;
  row.role = kind.role;
  row.parameter = kind.parameter;
  row.value = kind.parameter.empty() ? NotMeasured : value;
  row.setUp = setUp.seconds;
  row.resampling = setUp.resampling;
  row.hostBytes = setUp.hostBytes;
  row.deviceBytes = setUp.deviceBytes;
  row.note = setUp.note;
  return row;
}

double sum(const std::vector<double>& values)
{
  double result = 0.0;
  for (const double value : values)
  {
    result += value;
  }
  return result;
}

void drawInTurn(std::vector<Entry>& entries, const Plan& plan)
{
  for (int round = -1; round < plan.rounds; ++round)
  {
    for (Entry& entry : entries)
    {
      if (round < 0)
      {
        entry.method->draw(plan.size, entry.value);
      }
      else if (round == 0 || sum(entry.costs.wall) < plan.budget)
      {
        entry.costs.measure([&] { entry.method->draw(plan.size, entry.value); });
        entry.marches.push_back(entry.method->marchSeconds());
      }
    }
  }
}

class Truths
{
public:
  Truths(const Scene& scene, const Size& size)
    : Subject(scene)
    , Pixels(size)
  {
    this->Costs_.measure([&] { this->Common = scene.renderTruth(size, this->Error); });
  }

  const Image& common() const { return this->Common; }
  double error() const { return this->Error; }
  double seconds() const { return this->Costs_.wall.front(); }

  /// Of the method's own reconstruction.
  const Image& own(reference::Reconstruction field)
  {
    if (field == reference::Reconstruction::Basis && !this->Subject.model().truth)
    {
      return this->Common;
    }
    Image& image = this->Own[field];
    if (image.pixels.empty())
    {
      double error = 0.0;
      image = this->Subject.renderReference(this->Pixels, field, error);
    }
    return image;
  }

private:
  const Scene& Subject;
  const Size Pixels;
  Image Common;
  std::map<reference::Reconstruction, Image> Own;
  double Error = 0.0;
  Costs Costs_;
};

void judge(Entry& entry, const Image& image, Truths& truths)
{
  Result& row = entry.row;
  const Image& truth = truths.common();
  if (brightest(image) == 0.0 && brightest(truth) > 0.0)
  {
    row.note = row.note.empty() ? "no picture: black" : row.note;
    return;
  }
  row.rmse = rootMeanSquare(image, truth);
  row.psnr = toDecibels(row.rmse);
  row.psnrDrawn = toDecibels(rootMeanSquareOfDrawn(image, truth));
  row.ssim = reference::structuralSimilarity(image, truth);
  if (entry.method->hasOpacity())
  {
    row.psnrRGBA = reference::psnr(image, truth);
    row.psnrRGBADrawn = reference::psnrOfDrawn(image, truth);
  }
  if (entry.kind->field)
  {
    row.rmseOwn = rootMeanSquare(image, truths.own(*entry.kind->field));
  }
}

std::string fileName(const Result& row)
{
  std::string name = row.scene + " " + row.method;
  if (!std::isnan(row.value))
  {
    name += " " + accuracy::csvNumber(row.value);
  }
  return pictureFileName(name);
}
}

void say(const std::string& what) { std::cerr << "exabricks-benchmark: " << what << std::endl; }

void measureScene(const Scene& scene, const std::string& group, const Plan& plan, Results& results)
{
  SceneMeasurements measured = measureStructure(scene, group, plan.size, 0);
  std::vector<std::unique_ptr<Method>> methods;
  std::vector<Entry> entries;
  std::vector<Result> rows; // of what is not drawn
  for (const MethodKind& kind : plan.methods)
  {
    const std::vector<double> values = valuesOf(kind, plan);
    if (values.empty())
    {
      continue;
    }
    say(scene.name() + ": setting up " + kind.name);
    methods.push_back(kind.make(scene));
    for (const double value : values)
    {
      const SetUp setUp = methods.back()->setUp(value);
      const Result row = makeRow(scene, kind, value, setUp);
      if (setUp.possible)
      {
        entries.push_back({ &kind, methods.back().get(), value, {}, {}, row });
      }
      else
      {
        rows.push_back(row);
      }
    }
  }
  say(scene.name() + ": drawing");
  drawInTurn(entries, plan);

  say(scene.name() + ": comparing with the reference");
  Truths truths(scene, plan.accuracySize);
  measured.truthTime = truths.seconds();
  measured.truthError = truths.error();
  double opacity = 0.0;
  for (const glm::dvec4& pixel : truths.common().pixels)
  {
    opacity += pixel.a / static_cast<double>(truths.common().pixels.size());
  }
  measured.meanOpacity = opacity;
  if (!plan.pictures.empty())
  {
    writePicture(truths.common(), plan.pictures, pictureFileName(scene.name() + " reference"));
  }
  for (Entry& entry : entries)
  {
    entry.method->draw(plan.accuracySize, entry.value);
    const Image image = entry.method->picture();
    judge(entry, image, truths);
    if (!plan.pictures.empty())
    {
      writePicture(image, plan.pictures, fileName(entry.row));
    }
    entry.row.samples = entry.method->samples(plan.accuracySize, entry.value);
    entry.row.rounds = static_cast<int>(entry.costs.wall.size());
    entry.row.wall = median(entry.costs.wall);
    entry.row.cpu = median(entry.costs.cpu);
    entry.row.march = median(entry.marches);
    results.rows.push_back(entry.row);
  }
  results.rows.insert(results.rows.end(), rows.begin(), rows.end());
  results.scenes.push_back(measured);
  if (plan.changes > 0)
  {
    say(scene.name() + ": changing colours, opacity and camera");
    measureChanges(scene, plan.size, plan.changes, results.changes);
  }
  forgetResampled(scene);
}
}
}
