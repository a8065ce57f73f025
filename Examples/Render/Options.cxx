// SPDX-License-Identifier: BSD-3-Clause

#include "Options.h"

#include "CheckOptions.h"
#include "Failure.h"
#include "ParseValues.h"
#include "Scene.h"

#include "vtkExaBricksFirstPicture.h"
#include "vtkExaBricksVolumeMapper.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkVersion.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <functional>
#include <iostream>

namespace render
{

namespace
{

const char* const Description =
  "Draws AMR data sets as volumes, by active brick regions on a Vulkan device, into pictures.\n"
  "All that is not asked for is taken from the data: array, range, opacity and camera.\n"
  "\n"
  "INPUT is one of\n"
  "  a .vthb or .vth file (VTK), an AMReX plotfile (its folder), an Enzo .hierarchy file,\n"
  "  a FLASH .hdf5 file, or a .vtkhdf file (where VTK can read AMR from it).\n"
  "Several are a time series. What is taken from the data is then that of the last one, for all.\n"
  "\n"
  "OUTPUT is a .png or .jpg, or a .tif of floats: red, green and blue, premultiplied, and opacity "
  "of\n"
  "the volume alone; or, of a time series or a turntable, a video: .mp4, .mkv, .webm\n"
  "(by the program ffmpeg); several pictures are numbered, OUTPUT-0000.png and on.";

const char* const Footer =
  "Values in --range and --opacity are those of the array, with --log too.\n"
  "An opacity holds for one unit distance (--opacity-unit, in the data's length): the picture "
  "does\n"
  "not change with the step or the resolution.\n"
  "\n"
  "Examples\n"
  "  What is in a file, then a first picture of one array:\n"
  "    exabricks-render plt00216 --list-arrays\n"
  "    exabricks-render plt00216 rings.png --array magvort\n"
  "  A thin shell around 4 and the core above 10, seen from +y, on white:\n"
  "    exabricks-render plt00216 rings.png -a magvort --view +y --background white \\\n"
  "      --opacity 3.5:0,4:0.2,4.5:0,9:0,11:0.5 --opacity-unit 0.01\n"
  "  Six decades of density, coarse levels only:\n"
  "    exabricks-render DD0010.hierarchy gas.png -a Density --log --levels 4\n"
  "  A film of a run:\n"
  "    exabricks-render plt00000 plt00100 plt00200 film.mp4 -a magvort --fps 10\n"
  "  A measurement: median of 20 frames, all numbers in a file:\n"
  "    exabricks-render data.vthb out.png --frames 20 --stats out.json --device llvmpipe\n"
  "\n"
  "Exit codes: 0 fine, 1 rendering failed, 2 bad arguments, 3 input cannot be read,\n"
  "4 output cannot be written.";

// CLI11's own let NaN through, which is neither below nor above.
CLI::Validator numberThat(const std::string& which, const std::function<bool(double)>& fits)
{
  return CLI::Validator(
    [=](std::string& value)
    {
      double number = 0.0;
      return parseNumber(value, number) && fits(number)
        ? std::string()
        : "expected a number " + which + ", found '" + value + "'";
    },
    which);
}

CLI::Validator numberBetween(double least, double most)
{
  std::ostringstream which;
  which << "from " << least << " to " << most;
  return numberThat(which.str(), [=](double number) { return number >= least && number <= most; });
}

CLI::Validator positiveNumber()
{
  return numberThat("above 0", [](double number) { return number > 0.0; });
}

// The options as typed, where a value has to be looked at after CLI11 is through.
struct Texts
{
  std::vector<std::string> Files;
  std::string Size, Position, Focal, Up, Background, Component, Opacity, Iso;
  std::vector<double> Range;
  std::vector<std::string> Slice, Arrays;
};

void addOptions(CLI::App& app, Options& o, Texts& texts)
{
  app.add_option("files", texts.Files, "What to draw, and the file to write")
    ->type_name("INPUT... OUTPUT");
  app
    .add_option(
      "--scene", o.Scene, "Take what is not asked for from a file that --stats or the viewer wrote")
    ->type_name("FILE.json");
  app.add_flag("--list-arrays", o.ListArrays, "Say what the input holds, and draw nothing");
  app
    .add_flag_callback(
      "--list-devices", [] { throw CLI::Success(); }, "Say which Vulkan devices there are")
    ->trigger_on_parse();
  app
    .add_option("--stats", o.Statistics,
      "Write all numbers of the run, of several pictures of the first or, of a time series, the "
      "last "
      "one, to this file")
    ->type_name("FILE.json");
  app.add_option("--turntable", o.Turntable, "Draw N pictures of one turn about the upward axis")
    ->type_name("N")
    ->check(CLI::Range(2, 10000));
  app.add_option("--fps", o.FramesPerSecond, "Pictures of a video in a second [25]")
    ->type_name("N")
    ->check(numberBetween(0.1, 240.0));
  app.add_flag("-q,--quiet", o.Quiet, "Print nothing but errors");

  const std::string data = "Data";
  app
    .add_option("-a,--array", texts.Arrays,
      "Cell array to draw [density, temperature, or the first that varies]; of several, each has "
      "files with its name before their ending, and --range and --opacity hold for all")
    ->type_name("NAME")
    ->allow_extra_args(false)
    ->group(data);
  app.add_option("--component", texts.Component, "Of a vector: N from 0, or magnitude [magnitude]")
    ->type_name("N")
    ->group(data);
  app
    .add_flag("--log", o.Log,
      "Draw log10 of the array; cells not above zero become absent [where that shows more]")
    ->group(data);
  app.add_flag("--linear", o.Linear, "Draw the array itself")->group(data);
  app.add_option("--levels", o.Levels, "Number of levels to use, from the coarsest [all]")
    ->type_name("N")
    ->check(CLI::Range(1, 1000))
    ->group(data);

  const std::string camera = "Camera";
  app.add_option("--size", texts.Size, "Size of the picture in pixels [800x600]")
    ->type_name("WxH")
    ->group(camera);
  app
    .add_option(
      "--view", o.View, "Side to look from, at all that shows: iso +x -x +y -y +z -z [iso]")
    ->type_name("SIDE")
    ->check(CLI::IsMember({ "iso", "+x", "-x", "+y", "-y", "+z", "-z" }))
    ->group(camera);
  app.add_option("--position", texts.Position, "Place of the camera, instead of --view")
    ->type_name("X,Y,Z")
    ->group(camera);
  app.add_option("--focal", texts.Focal, "Point to look at [centre of what shows]")
    ->type_name("X,Y,Z")
    ->group(camera);
  app
    .add_option(
      "--up", texts.Up, "Direction that is up in the picture [z, or y if it looks along z]")
    ->type_name("X,Y,Z")
    ->group(camera);
  app.add_option("--view-angle", o.ViewAngle, "Vertical angle of view in degrees [30]")
    ->type_name("DEG")
    ->check(numberBetween(0.1, 170.0))
    ->group(camera);
  app.add_flag("--parallel", o.Parallel, "Parallel projection")->group(camera);
  app.add_option("--zoom", o.Zoom, "Enlarge the picture about its centre [1]")
    ->type_name("FACTOR")
    ->check(positiveNumber())
    ->group(camera);

  const std::string look = "Look";
  app
    .add_option("--color-map", o.ColorMap,
      "Colour map: " + vtkExaBricksFirstPicture::GetColorMapNames() + " [viridis]")
    ->type_name("NAME")
    ->group(look);
  app.add_option("--range", texts.Range, "Values at the ends of the colour map [all leaf cells]")
    ->type_name("MIN MAX")
    ->expected(2)
    ->group(look);
  app
    .add_option("--opacity", texts.Opacity,
      "Opacity points V:O,V:O,... [by the histogram and the blend mode]")
    ->type_name("POINTS")
    ->group(look);
  app
    .add_option("--opacity-unit", o.OpacityUnit,
      "Distance that opacities hold for [of what shows: diagonal / 100]")
    ->type_name("LENGTH")
    ->check(positiveNumber())
    ->group(look);
  app.add_option("--background", texts.Background, "Colour behind the volume [black]")
    ->type_name("R,G,B|NAME")
    ->group(look);

  app
    .add_option("--blend-mode", o.BlendMode,
      "composite, maximum, minimum, average, additive, isosurface or slice [composite]")
    ->type_name("MODE")
    ->check(CLI::IsMember(
      { "composite", "maximum", "minimum", "average", "additive", "isosurface", "slice" }))
    ->group(look);
  app.add_option("--iso", texts.Iso, "Values of iso-surfaces, which --blend-mode isosurface draws")
    ->type_name("V,V,...")
    ->group(look);
  app
    .add_option("--slice", texts.Slice,
      "A point and the normal of the plane that --blend-mode slice draws, opaque where --opacity "
      "says nothing")
    ->type_name("X,Y,Z X,Y,Z")
    ->expected(2)
    ->group(look);
  app.add_flag("--annotate", o.Annotate, "Draw axes around the data, and a scalar bar")
    ->group(look);
  app
    .add_flag("--shade,!--no-shade", o.Shaded,
      "Light the volume from the camera, or not [iso-surfaces alone]")
    ->group(look);

  const std::string method = "Method";
  app
    .add_option("--reconstruction", o.Reconstruction,
      "Between cell centres: basis, nearest or completed [basis]")
    ->type_name("KIND")
    ->check(CLI::IsMember({ "basis", "nearest", "completed" }))
    ->group(method);
  app.add_option("--step-scale", o.StepScale, "Step along a ray, in cells [1]; 0.5 draws smoother")
    ->type_name("S")
    ->check(numberBetween(0.001, 1000.0))
    ->group(method);
  app
    .add_option("--error-tolerance", o.ErrorTolerance,
      "Error to draw with, of drawn pixels in [0, 1], instead of a step scale; 0.004 is one of 255")
    ->type_name("E")
    ->check(numberBetween(0.0, 1.0))
    ->group(method);
  app.add_option("--traversal", o.Traversal, "automatic, ray-query or kd-tree [automatic]")
    ->type_name("KIND")
    ->check(CLI::IsMember({ "automatic", "ray-query", "kd-tree" }))
    ->group(method);
  app.add_option("--device", o.Device, "Vulkan device: index, or part of its name [the best]")
    ->type_name("WHICH")
    ->group(method);
  app
    .add_option("--frames", o.Frames,
      "Time N frames after the first, and give the median; of a time series those of the last file")
    ->type_name("N")
    ->check(CLI::Range(1, 1000000))
    ->group(method);
}

// The last one is the output's; where a scene names the input, or arrays are to be listed, there
// may be one alone.
void takeFiles(const std::vector<std::string>& files, Options& o)
{
  if (o.ListArrays)
  {
    o.Input = files.empty() ? o.Input : files.front();
    if (files.size() > 2 || (files.size() == 2 && !hasOutputEnding(files.back())))
    {
      throw Failure(ExitCode::BadArguments, "--list-arrays tells of one input: give one alone.");
    }
  }
  else if (files.size() > 1)
  {
    o.Inputs.assign(files.begin(), files.end() - 1);
    o.Input = o.Inputs.back();
    o.Output = files.back();
  }
  else if (files.size() == 1)
  {
    (o.Input.empty() ? o.Input : o.Output) = files.front();
  }
}

void takeTexts(const Texts& texts, Options& o)
{
  takeFiles(texts.Files, o);
  if (!texts.Arrays.empty())
  {
    o.Array = texts.Arrays.front();
    o.Arrays = texts.Arrays;
    if (o.Arrays.size() == 1)
    {
      o.Arrays.clear();
    }
  }
  auto vector = [](const char* option, const std::string& text, std::optional<Vector3>& v)
  {
    if (!text.empty())
    {
      v = parseVector(option, text);
    }
  };
  vector("--position", texts.Position, o.Position);
  vector("--focal", texts.Focal, o.Focal);
  vector("--up", texts.Up, o.Up);
  if (!texts.Size.empty())
  {
    o.Size = parseSize("--size", texts.Size);
  }
  if (!texts.Background.empty())
  {
    o.Background = parseColor("--background", texts.Background);
    o.BackgroundName = texts.Background;
  }
  if (!texts.Component.empty())
  {
    o.Component = parseComponent("--component", texts.Component);
  }
  if (!texts.Opacity.empty())
  {
    o.Opacity = parseOpacity("--opacity", texts.Opacity);
  }
  if (!texts.Iso.empty())
  {
    o.IsoValues = parseNumbers("--iso", texts.Iso);
  }
  if (!texts.Slice.empty())
  {
    o.Slice =
      Plane{ parseVector("--slice", texts.Slice[0]), parseVector("--slice", texts.Slice[1]) };
  }
  if (!texts.Range.empty())
  {
    o.Range = { { texts.Range[0], texts.Range[1] } };
  }
}

void printDevices(std::ostream& out)
{
  vtkNew<vtkStringArray> lines;
  vtkExaBricksVolumeMapper::GetDevices(lines);
  for (vtkIdType i = 0; i < lines->GetNumberOfValues(); ++i)
  {
    out << lines->GetValue(i) << '\n';
  }
  if (lines->GetNumberOfValues() == 0)
  {
    out << "no Vulkan device: install a driver (Debian: mesa-vulkan-drivers 24.1 or newer)\n";
  }
}

// The file that --scene names; empty: none. Options count after it, wherever they stand.
std::string findScene(int argc, char** argv)
{
  const std::string with = "--scene=";
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument == "--scene" && i + 1 < argc)
    {
      return argv[i + 1];
    }
    if (argument.compare(0, with.size(), with) == 0)
    {
      return argument.substr(with.size());
    }
  }
  return {};
}

// What in a scene does not hold together with what is asked for.
void dropFromScene(const CLI::App& app, const Options& scene, Options& o)
{
  const auto asked = [&](const char* option) { return app.count(option) > 0; };
  if (asked("--view"))
  {
    const auto keepAsked = [&](const char* option, std::optional<Vector3>& of)
    {
      if (!asked(option))
      {
        of.reset();
      }
    };
    keepAsked("--position", o.Position);
    keepAsked("--focal", o.Focal);
    keepAsked("--up", o.Up);
    o.ParallelScale = 0.0;
  }
  if (asked("--log"))
  {
    o.Linear = false;
  }
  if (asked("--linear"))
  {
    o.Log = false;
  }
  if (asked("--color-map"))
  {
    o.Colors.clear();
  }
  // Of several arrays none has what is of the scene's alone.
  const bool otherArray = asked("--array") && (o.Arrays.size() > 1 || o.Array != scene.Array);
  const bool otherValues = otherArray || o.Log != scene.Log || asked("--component");
  if (otherValues)
  {
    if (!asked("--range"))
    {
      o.Range.reset();
    }
    if (!asked("--opacity"))
    {
      o.Opacity.clear();
    }
    o.Colors.clear();
    if (otherArray && !asked("--component"))
    {
      o.Component.reset();
    }
  }
  if (asked("--step-scale") && !asked("--error-tolerance"))
  {
    o.ErrorTolerance = 0.0;
  }
  if (asked("--blend-mode") && o.BlendMode != "isosurface" && !asked("--iso"))
  {
    o.IsoValues.clear();
  }
  if (asked("--blend-mode") && o.BlendMode != "slice" && !asked("--slice"))
  {
    o.Slice.reset();
  }
}

}

bool parseOptions(int argc, char** argv, Options& options)
{
  CLI::App app(Description, "exabricks-render");
  app.footer(Footer);
  app.get_formatter()->column_width(34);
  app.set_version_flag("--version",
    std::string("exabricks-render " EXABRICKS_VERSION " (VTK ") + vtkVersion::GetVTKVersion() +
      ")");
  Texts texts;
  // What is asked for counts before what the scene says.
  if (const std::string scene = findScene(argc, argv); !scene.empty())
  {
    readScene(scene, options);
  }
  const Options before = options;
  addOptions(app, options, texts);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() == 0)
    {
      if (app.count("--list-devices") > 0)
      {
        printDevices(std::cout);
      }
      app.exit(error, std::cout, std::cerr);
      return false;
    }
    throw Failure(ExitCode::BadArguments,
      std::string(error.what()) + "\nSee exabricks-render --help for what can be asked for.");
  }
  takeTexts(texts, options);
  if (!options.Scene.empty())
  {
    dropFromScene(app, before, options);
  }
  if (app.count("--blend-mode") > 0 && app.count("--shade") == 0)
  {
    options.Shaded = options.Shaded || options.BlendMode == "isosurface"; // else it is a silhouette
  }
  checkTogether(options, app.count("--view") > 0, app.count("--step-scale") > 0,
    app.count("--fps") > 0, app.count("--background") > 0);
  return true;
}

}
