// SPDX-License-Identifier: BSD-3-Clause
// exabricks-render: draws an AMR data set as a volume into a PNG. The order of the work is the
// order of this file: options, input, array, picture, output, report.

#include "Display.h"
#include "Logarithm.h"
#include "Messages.h"
#include "OpenAMR.h"
#include "Options.h"
#include "Output.h"
#include "Picture.h"
#include "Report.h"

#include "vtkImageData.h"
#include "vtkRenderWindow.h"

#include <chrono>
#include <exception>
#include <iostream>
#include <new>

namespace
{

using namespace render;

// The array that was named, or the first scalar one.
ArrayInfo chooseArray(const Options& options, const AMRFile& file)
{
  const ArrayInfo* chosen = nullptr;
  std::string names;
  for (const ArrayInfo& array : file.Arrays())
  {
    names += (names.empty() ? "" : ", ") + array.Name;
    if (!chosen && (options.Array.empty() ? array.Components == 1 : array.Name == options.Array))
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
        : "There is no cell array '" + options.Array + "': choose of " + names);
  }
  if (options.Component && *options.Component >= chosen->Components)
  {
    throw Failure(ExitCode::BadArguments,
      "--component " + std::to_string(*options.Component) + ": '" + chosen->Name + "' has " +
        std::to_string(chosen->Components) + ", counted from 0.");
  }
  return *chosen;
}

void drawIntoFile(const Options& options)
{
  AMRFile file(options.Input);
  if (options.ListArrays)
  {
    printArrays(std::cout, file);
    return;
  }
  const ArrayInfo array = chooseArray(options, file);
  checkWritable(options.Output);
  if (!options.Statistics.empty())
  {
    checkWritable(options.Statistics);
  }

  auto window = makeWindow();

  const auto start = std::chrono::steady_clock::now();
  auto amr = file.Read(array.Name, options.Levels, options.Quiet);
  const std::chrono::duration<double> readTime = std::chrono::steady_clock::now() - start;

  const std::string drawn =
    options.Log ? addLogarithm(amr, array.Name, options.Component) : array.Name;
  Picture picture(options, window, amr, drawn, options.Log ? 1 : array.Components);
  picture.Prepare();
  picture.Draw();

  const render::Run run{ options, file, picture, array, readTime.count() };
  writePNG(options.Output, picture.Pixels());
  if (!options.Statistics.empty())
  {
    writeText(options.Statistics, statisticsJson(run));
  }
  if (!options.Quiet)
  {
    printReport(std::cout, run);
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
