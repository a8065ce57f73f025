// SPDX-License-Identifier: BSD-3-Clause

#include "CheckOptions.h"

#include "DidYouMean.h"
#include "Failure.h"
#include "Output.h"
#include "Video.h"

#include "vtkExaBricksFirstPicture.h"

#include <algorithm>
#include <sstream>

namespace render
{

namespace
{

std::vector<std::string> colorMaps()
{
  std::vector<std::string> names;
  std::istringstream text(vtkExaBricksFirstPicture::GetColorMapNames());
  for (std::string name; std::getline(text >> std::ws, name, ',');)
  {
    names.push_back(name);
  }
  return names;
}

}

bool hasOutputEnding(const std::string& path)
{
  const std::string ending = pictureEnding(path);
  return ending == ".png" || ending == ".jpg" || ending == ".tif" || Video::IsOne(path);
}

void checkTogether(
  const Options& o, bool viewGiven, bool stepGiven, bool fpsGiven, bool backgroundGiven)
{
  auto refuse = [](const std::string& message) { throw Failure(ExitCode::BadArguments, message); };
  if (o.Input.empty())
  {
    refuse("No input was named: give an AMR data set, or a --scene that names one. See "
           "exabricks-render --help.");
  }
  if ((o.BlendMode == "isosurface") != !o.IsoValues.empty())
  {
    refuse(o.IsoValues.empty()
        ? "--blend-mode isosurface draws the values that --iso names: give some."
        : "--iso names iso-surfaces: give --blend-mode isosurface with it.");
  }
  if ((o.BlendMode == "slice") != o.Slice.has_value())
  {
    refuse(o.Slice ? "--slice names a plane: give --blend-mode slice with it."
                   : "--blend-mode slice draws the plane that --slice names: give one, such as "
                     "--slice 0,0,0.5 0,0,1.");
  }
  if (o.Slice && o.Slice->Normal == Vector3{ { 0.0, 0.0, 0.0 } })
  {
    refuse("--slice takes a point and a normal that is not 0,0,0, such as --slice 0,0,0.5 0,0,1.");
  }
  if (o.Log &&
    std::any_of(o.IsoValues.begin(), o.IsoValues.end(), [](double v) { return v <= 0.0; }))
  {
    refuse("--log draws only values above zero: give --iso values above zero.");
  }
  if (!o.ListArrays)
  {
    if (o.Output.empty())
    {
      refuse("No output was named: give a file after the input, such as picture.png.");
    }
    if (!hasOutputEnding(o.Output) || (Video::IsOne(o.Output) && !o.IsSeries()))
    {
      refuse(Video::IsOne(o.Output)
          ? "A video is of several pictures: give several inputs, or --turntable; or an output "
            "that "
            "ends in .png."
          : "The output has to end in .png, .jpg, .jpeg or .tif, or of several pictures in .mp4, "
            ".mkv "
            "or .webm, found '" +
            o.Output + "'." +
            (o.Array.empty() ? "" : " Of several arrays, each has an --array before it."));
    }
    if (holdsFloats(o.Output) && (o.Annotate || backgroundGiven))
    {
      refuse(o.Annotate
          ? "A .tif holds the volume alone, as floats: leave --annotate out, or give an "
            "output that ends in .png."
          : "A .tif holds the volume alone, as floats, with its opacity: leave "
            "--background out, or give an output that ends in .png.");
    }
    if (o.Arrays.size() > 1 && o.Component)
    {
      refuse("--component is of one array: give one --array with it.");
    }
    if (o.Turntable > 0 && o.Inputs.size() > 1)
    {
      refuse("--turntable turns one data set: give one input, or leave --turntable out.");
    }
  }
  if (o.Colors.empty() && !vtkExaBricksFirstPicture::HasColorMap(o.ColorMap))
  {
    refuse("--color-map takes one of " + vtkExaBricksFirstPicture::GetColorMapNames() + ", not '" +
      o.ColorMap + "'." + didYouMean(o.ColorMap, colorMaps()));
  }
  if (fpsGiven && !Video::IsOne(o.Output))
  {
    refuse("--fps is of a video: give an output that ends in .mp4, .mkv or .webm.");
  }
  if (viewGiven && o.Position)
  {
    refuse("--view and --position both place the camera: give one of them.");
  }
  if (stepGiven && o.ErrorTolerance > 0.0)
  {
    refuse("--step-scale and --error-tolerance both choose the steps: give one of them.");
  }
  if (o.Log && o.Linear)
  {
    refuse("--log and --linear ask for opposite things: give one of them.");
  }
  if (o.Range && !((*o.Range)[0] < (*o.Range)[1]))
  {
    refuse("--range takes MIN and MAX with MIN below MAX, such as --range 0 10.");
  }
  if (o.Log && o.Range && (*o.Range)[0] <= 0.0)
  {
    refuse("--log draws only values above zero: give a --range that starts above zero.");
  }
  if (o.Log && !o.Opacity.empty() && o.Opacity.front().Value <= 0.0)
  {
    refuse("--log draws only values above zero: give --opacity points at values above zero.");
  }
}

}
