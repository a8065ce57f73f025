// SPDX-License-Identifier: BSD-3-Clause
#include "Request.h"

#include "Failure.h"
#include "ParseValues.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>

namespace exabricks
{
namespace benchmarks
{
namespace
{
const char* const Description =
  "Measures what vtkExaBricksVolumeMapper takes and how near its pictures come to what they ought\n"
  "to be, beside what else VTK has: scenes x methods x step scales, all methods in turn.\n"
  "Writes CSV to a folder, of which Utilities/report draws tables and charts. Needs a display\n"
  "(xvfb-run -a).";

const char* const Footer =
  "Examples\n"
  "  Is all well on this machine? Exits with 1 if a bound of structure or accuracy is broken:\n"
  "    exabricks-benchmark --quick --output results\n"
  "  Everything, with the data sets whose names are known (--list) in a folder:\n"
  "    exabricks-benchmark --full --data folder --output results\n"
  "  One's own data, against all that VTK has:\n"
  "    exabricks-benchmark plt00216 --array magvort --output results\n"
  "  Tables and charts of it:\n"
  "    python3 Utilities/report results\n"
  "\n"
  "Exit codes: 0 fine, 1 rendering failed or a bound is broken, 2 bad arguments, 3 input cannot\n"
  "be read, 4 output cannot be written.";

[[noreturn]] void refuse(const std::string& why)
{
  throw render::Failure(render::ExitCode::BadArguments, why + " See --help.");
}

// The options as typed, where a value has to be looked at after CLI11 is through.
struct Texts
{
  std::string size, accuracySize, component, opacity;
  bool quick = false, full = false, list = false, noPeers = false;
  int rounds = 0;
  double budget = 0.0;
};

void addOptions(CLI::App& app, Request& request, Texts& texts)
{
  render::Options& draw = request.input.draw;
  app.add_flag("--quick", texts.quick, "Small scenes, few steps; checks bounds")->group("What");
  app.add_flag("--full", texts.full, "Everything, with growth up to --largest")->group("What");
  app.add_option("--scenes", request.scenes, "Names or groups of scenes, in quotes")
    ->delimiter(';')
    ->group("What");
  app.add_option("--methods", request.methods, "Methods whose names begin so, parted by ; [all]")
    ->delimiter(';')
    ->group("What");
  app.add_flag("--no-peers", texts.noPeers, "Leave VTK's own mappers out")->group("What");
  app.add_option("--data", request.data, "Folder with data sets of known names; may be repeated")
    ->group("What");
  app
    .add_option("--leaf-cells", request.leafCells,
      "About so many in stand-ins and other scenes of any size [their own]")
    ->check(CLI::Range(1e4, 1e9))
    ->group("What");
  app.add_flag("--growth", request.growth, "Time and memory against the number of leaf cells")
    ->group("What");
  app.add_option("--largest", request.largest, "Leaf cells of the largest scene there [1e7]")
    ->check(CLI::Range(1e5, 1e9))
    ->group("What");
  app
    .add_option("--changes", request.plan.changes,
      "Times to change colours, opacity and camera and see what that costs [0]")
    ->check(CLI::Range(0, 1000))
    ->group("What");
  app
    .add_flag("--march", request.march,
      "Print what a march does in the scenes (samples, regions, lanes that are on), as CSV")
    ->group("What");
  app
    .add_option("--ranks", request.ranks,
      "Print what up to so many processes cost in the scenes (cells, bytes, time), as CSV")
    ->check(CLI::Range(1, 65536))
    ->group("What");
  app.add_flag("--structure", request.structure, "Print time and memory by size of bricks, as CSV")
    ->group("What");
  app.add_flag("--list", texts.list, "Say which scenes and methods there are")->group("What");

  app.add_option("-o,--output", request.folder, "Folder of the results; made if need be")
    ->group("How");
  app.add_option("--size", texts.size, "Of the frames that are timed [512x512, quick: 256x256]")
    ->group("How");
  app
    .add_option("--accuracy-size", texts.accuracySize,
      "Of the pictures that are compared [that of the timed frames, quick: 128x128]")
    ->group("How");
  app.add_option("--rounds", texts.rounds, "Timed frames of each [5, full and quick: 3]")
    ->check(CLI::Range(1, 10000))
    ->group("How");
  app
    .add_option("--budget", texts.budget,
      "Seconds of timed frames of one method; it is drawn no more beyond [5, full: 1, quick: 2]")
    ->check(CLI::PositiveNumber)
    ->group("How");
  app
    .add_option(
      "--step-scales", request.plan.stepScales, "Instead of the methods' own, parted by ,")
    ->delimiter(',')
    ->check(CLI::PositiveNumber)
    ->group("How");
  app
    .add_option(
      "--largest-grid", request.plan.largestGrid, "Cells along an axis, of resampling [512]")
    ->check(CLI::Range(1, 2048))
    ->group("How");
  app.add_option("--pictures", request.plan.pictures, "Folder to write the pictures to")
    ->group("How");

  app.add_option("input", draw.Input, "AMR data set, as exabricks-render opens it")->group("Input");
  app.add_option("-a,--array", draw.Array, "Cell array [the first scalar one]")->group("Input");
  app.add_option("--component", texts.component, "Of a vector: N from 0, or magnitude [magnitude]")
    ->group("Input");
  app.add_flag("--log", draw.Log, "Draw log10 of the array")->group("Input");
  app.add_option("--levels", draw.Levels, "Number of levels to use, from the coarsest [all]")
    ->group("Input");
  app.add_option("--view", draw.View, "Side to look from: iso +x -x +y -y +z -z [iso]")
    ->group("Input");
  app.add_option("--color-map", draw.ColorMap, "Colour map [viridis]")->group("Input");
  app.add_option("--opacity", texts.opacity, "Opacity points V:O,V:O,... [from the histogram]")
    ->group("Input");
  app.add_option("--opacity-unit", draw.OpacityUnit, "Unit distance [diagonal / 100]")
    ->group("Input");
  app.add_option("--scene", request.input.scene, "JSON file with camera and transfer function")
    ->group("Input");
}

void chooseTask(const Texts& texts, Request& request)
{
  const bool measures = texts.quick || texts.full || !request.scenes.empty() ||
    !request.input.draw.Input.empty() || request.growth || request.structure || request.march ||
    request.ranks > 0;
  if (texts.quick && texts.full)
  {
    refuse("--quick and --full exclude one another.");
  }
  if (texts.list)
  {
    request.task = Request::Task::List;
    return;
  }
  if (!measures)
  {
    refuse("Nothing to measure: give --quick, --full, --scenes or an input.");
  }
  if (request.folder.empty() && !request.structure && !request.march && request.ranks == 0)
  {
    refuse("--output is missing: the folder that results are written to.");
  }
}

void checkFiles(const Request& request)
{
  for (const std::string& folder : request.data)
  {
    if (!std::filesystem::is_directory(folder))
    {
      throw render::Failure(
        render::ExitCode::InputUnreadable, "--data: there is no folder '" + folder + "'.");
    }
  }
  if (!request.input.scene.empty() && request.input.draw.Input.empty())
  {
    refuse("--scene says how to look at an input: give one.");
  }
}
}

bool parseRequest(int argc, char** argv, Request& request)
{
  CLI::App app(Description, "exabricks-benchmark");
  app.footer(Footer);
  Texts texts;
  addOptions(app, request, texts);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::CallForHelp& help)
  {
    app.exit(help);
    return false;
  }
  catch (const CLI::ParseError& error)
  {
    refuse(std::string(error.what()) + ".");
  }
  chooseTask(texts, request);
  checkFiles(request);

  Plan& plan = request.plan;
  plan.quick = texts.quick;
  request.full = texts.full;
  request.growth = request.growth || texts.full;
  const auto size =
    [&](const char* option, const std::string& text, const Size& full, const Size& quick)
  { return text.empty() ? (texts.quick ? quick : full) : render::parseSize(option, text); };
  plan.size = size("--size", texts.size, { 512, 512 }, { 256, 256 });
  // By an error tolerance a large picture is drawn in another way than a small one.
  plan.accuracySize = size("--accuracy-size", texts.accuracySize, plan.size, { 128, 128 });
  plan.rounds = texts.rounds > 0 ? texts.rounds : texts.quick || texts.full ? 3 : 5;
  plan.budget = texts.budget > 0.0 ? texts.budget : texts.full ? 1.0 : texts.quick ? 2.0 : 5.0;
  render::Options& draw = request.input.draw;
  draw.Quiet = true;
  draw.Size = plan.size;
  draw.Component =
    texts.component.empty() ? std::nullopt : render::parseComponent("--component", texts.component);
  if (!texts.opacity.empty())
  {
    draw.Opacity = render::parseOpacity("--opacity", texts.opacity);
  }

  const std::vector<MethodKind> all = listMethods();
  for (const MethodKind& kind : all)
  {
    const bool named = request.methods.empty() ||
      std::any_of(request.methods.begin(), request.methods.end(),
        [&](const std::string& name) { return kind.name.compare(0, name.size(), name) == 0; });
    if (named && !(texts.noPeers && kind.role == Role::Peer))
    {
      plan.methods.push_back(kind);
    }
  }
  if (plan.methods.empty())
  {
    refuse("There is no such method. --list says which there are.");
  }
  return true;
}
}
}
