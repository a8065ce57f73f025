// SPDX-License-Identifier: BSD-3-Clause
// exabricks-render: draws AMR data sets as volumes into pictures. The order of the work is the
// order of this file: options, input, array, picture, output, report.

#include "DidYouMean.h"
#include "Display.h"
#include "Messages.h"
#include "OpenAMR.h"
#include "Options.h"
#include "Output.h"
#include "Picture.h"
#include "PictureSeries.h"
#include "Report.h"

#include "vtkExaBricksFirstPicture.h"
#include "vtkImageData.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <new>
#include <set>
#include <sstream>

namespace
{

using namespace render;

// How gladly an array is drawn that nobody named.
int preference(const ArrayInfo& array)
{
  return array.Components > 1 ? -1
    : array.Varies()          ? 1 + vtkExaBricksFirstPicture::GetArrayPreference(array.Name)
                              : 0;
}

// The array that was named, or the one that is preferred.
ArrayInfo chooseArray(const Options& options, const AMRFile& file)
{
  const ArrayInfo* chosen = nullptr;
  std::string names;
  std::vector<std::string> all;
  for (const ArrayInfo& array : file.Arrays())
  {
    names += (names.empty() ? "" : ", ") + array.Name;
    all.push_back(array.Name);
    const bool fits = options.Array.empty() ? array.Components == 1 : array.Name == options.Array;
    if (fits && (!chosen || preference(array) > preference(*chosen)))
    {
      chosen = &array;
    }
  }
  if (file.Arrays().empty())
  {
    throw Failure(ExitCode::InputUnreadable,
      "'" + options.Input + "' has no cell arrays, and only those are drawn.");
  }
  if (!chosen)
  {
    throw Failure(ExitCode::BadArguments,
      options.Array.empty()
        ? "There is no scalar cell array: choose a vector with --array: " + names
        : "There is no cell array '" + options.Array + "': choose of " + names + "." +
          didYouMean(options.Array, all));
  }
  if (options.Component && *options.Component >= chosen->Components)
  {
    throw Failure(ExitCode::BadArguments,
      "--component " + std::to_string(*options.Component) + ": '" + chosen->Name + "' has " +
        std::to_string(chosen->Components) + ", counted from 0.");
  }
  return *chosen;
}

// Sets the picture up. Where the options leave it open, the array is drawn as a logarithm if that
// shows more, and they ask for it afterwards.
std::unique_ptr<Picture> setUp(
  Options& options, vtkRenderWindow* window, vtkOverlappingAMR* amr, const ArrayInfo& array)
{
  const auto make = [&]
  {
    const std::string drawn = options.Log
      ? vtkExaBricksFirstPicture::AddLogarithm(amr, array.Name, options.Component.value_or(-1))
      : array.Name;
    auto picture =
      std::make_unique<Picture>(options, window, amr, drawn, options.Log ? 1 : array.Components);
    picture->Prepare();
    return picture;
  };
  std::unique_ptr<Picture> picture = make();
  if (picture->LogarithmWanted() && !options.Linear && !options.Range && options.Opacity.empty())
  {
    options.Log = true;
    picture.reset();
    picture = make();
  }
  return picture;
}

// The first picture is drawn already.
void writeTurntable(const Options& options, Picture& picture)
{
  PictureSeries series(options.Output, options.FramesPerSecond);
  for (int i = 0; i < options.Turntable; ++i)
  {
    if (i > 0)
    {
      picture.Turn(360.0 / options.Turntable);
    }
    series.Add(picture.Result());
  }
  series.Finish();
}

// All data sets as the picture is set up. The one before is there until the next one is drawn.
void writeTimeSeries(const Options& options, Picture& picture, const std::string& array)
{
  PictureSeries series(options.Output, options.FramesPerSecond);
  for (const std::string& input : options.Inputs)
  {
    AMRFile file(input);
    const auto& arrays = file.Arrays();
    if (std::none_of(
          arrays.begin(), arrays.end(), [&](const ArrayInfo& a) { return a.Name == array; }))
    {
      throw Failure(ExitCode::InputUnreadable,
        "'" + input + "' has no cell array '" + array + "', which '" + options.Input +
          "' has: a time series has the same arrays in each file.");
    }
    const auto amr = file.Read(array, options.Levels, options.Quiet);
    if (options.Log)
    {
      vtkExaBricksFirstPicture::AddLogarithm(amr, array, options.Component.value_or(-1));
    }
    picture.DrawOther(amr);
    series.Add(picture.Result());
  }
  series.Finish();
}

// The name of an array's file among several: it comes before the ending.
std::string nameOfArray(const std::string& path, std::string array)
{
  std::replace_if(
    array.begin(), array.end(),
    [](unsigned char c) { return !std::isalnum(c) && c != '.' && c != '_' && c != '+'; }, '_');
  const std::filesystem::path all(path);
  return (all.parent_path() / (all.stem().string() + "-" + array + all.extension().string()))
    .string();
}

void drawIntoFile(Options options);

// Each array into files of its own. All are looked for before the first one is drawn.
void drawArrays(const Options& options)
{
  std::set<std::string> outputs;
  std::vector<Options> all;
  const AMRFile file(options.Input);
  for (const std::string& array : options.Arrays)
  {
    Options one = options;
    one.Arrays.clear();
    one.Array = array;
    chooseArray(one, file);
    one.Output = nameOfArray(options.Output, array);
    one.Statistics = options.Statistics.empty() ? "" : nameOfArray(options.Statistics, array);
    if (!outputs.insert(one.Output).second)
    {
      throw Failure(ExitCode::BadArguments,
        "--array: of two arrays the picture would be '" + one.Output + "': draw one of them.");
    }
    checkWritable(one.Output);
    if (!one.Statistics.empty())
    {
      checkWritable(one.Statistics);
    }
    all.push_back(one);
  }
  for (const Options& one : all)
  {
    drawIntoFile(one);
  }
}

void drawIntoFile(Options options)
{
  if (!options.Arrays.empty() && !options.ListArrays)
  {
    drawArrays(options);
    return;
  }
  auto file = std::make_unique<AMRFile>(options.Input);
  if (options.ListArrays)
  {
    printArrays(std::cout, *file);
    return;
  }
  const ArrayInfo array = chooseArray(options, *file);
  checkWritable(options.Output);
  if (Video::IsOne(options.Output))
  {
    Video::Check(options.Output);
  }
  if (!options.Statistics.empty())
  {
    checkWritable(options.Statistics);
  }

  auto window = makeWindow();

  const auto start = std::chrono::steady_clock::now();
  auto amr = file->Read(array.Name, options.Levels, options.Quiet);
  const std::chrono::duration<double> readTime = std::chrono::steady_clock::now() - start;

  const bool logAsked = options.Log;
  const std::unique_ptr<Picture> picture = setUp(options, window, amr, array);
  if (options.Annotate)
  {
    picture->Annotate(arrayText(options, array));
  }
  picture->Draw();

  const render::Run run{ options, *file, *picture, array, readTime.count(),
    options.Log && !logAsked };
  // Of the first picture of a turntable, and of the last one of a time series.
  const std::string statistics = statisticsJson(run);
  std::ostringstream report;
  printReport(report, run);
  if (options.Turntable > 0)
  {
    writeTurntable(options, *picture);
  }
  else if (options.IsSeries())
  {
    amr = nullptr;
    file.reset();
    writeTimeSeries(options, *picture, array.Name);
  }
  else
  {
    writePicture(options.Output, picture->Result());
  }
  if (!options.Statistics.empty())
  {
    writeText(options.Statistics, statistics);
  }
  if (!options.Quiet)
  {
    std::cout << report.str();
  }
}

}

int main(int argc, char** argv)
{
  Options options;
  try
  {
    if (parseOptions(argc, argv, options))
    {
      takeMessages(options.Quiet);
      drawIntoFile(options);
      throwIfErrors(ExitCode::RenderingFailed, "VTK met an error while it cleaned up");
    }
    return static_cast<int>(ExitCode::Fine);
  }
  catch (const Failure& failure)
  {
    std::cerr << "exabricks-render: " << failure.what() << '\n';
    return static_cast<int>(failure.Code);
  }
  catch (const std::bad_alloc&)
  {
    std::cerr << "exabricks-render: '" << options.Input
              << "' was read, but drawing it takes more memory than there is. Draw fewer levels "
                 "(--levels) or a smaller picture (--size), or use a machine with more memory.\n";
    return static_cast<int>(ExitCode::RenderingFailed);
  }
  catch (const std::exception& error)
  {
    std::cerr << "exabricks-render: '" << options.Input
              << "' could not be drawn, for a reason that this program does not know ("
              << error.what() << "). Please report it, with the command line and the data.\n";
    return static_cast<int>(ExitCode::RenderingFailed);
  }
}
