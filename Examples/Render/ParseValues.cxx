// SPDX-License-Identifier: BSD-3-Clause

#include "ParseValues.h"

#include "Failure.h"

#include "vtkColor.h"
#include "vtkNamedColors.h"
#include "vtkNew.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <locale>
#include <sstream>

namespace render
{

namespace
{

[[noreturn]] void Refuse(
  const std::string& option, const std::string& expected, const std::string& found)
{
  throw Failure(ExitCode::BadArguments, option + " takes " + expected + ", not '" + found + "'.");
}

std::vector<std::string> splitText(const std::string& text, char separator)
{
  std::vector<std::string> parts(1);
  for (char c : text)
  {
    if (c == separator)
    {
      parts.emplace_back();
    }
    else
    {
      parts.back() += c;
    }
  }
  return parts;
}

bool parseThreeNumbers(const std::string& text, Vector3& v)
{
  const auto parts = splitText(text, ',');
  return parts.size() == 3 && parseNumber(parts[0], v[0]) && parseNumber(parts[1], v[1]) &&
    parseNumber(parts[2], v[2]);
}

}

bool parseNumber(const std::string& text, double& value)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  char rest;
  return (stream >> value) && std::isfinite(value) && !(stream >> rest);
}

std::string lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

std::array<int, 2> parseSize(const std::string& option, const std::string& text)
{
  const auto parts = splitText(text, 'x');
  std::array<int, 2> size{ { 0, 0 } };
  bool good = parts.size() == 2;
  for (int i = 0; good && i < 2; ++i)
  {
    double number;
    good = parseNumber(parts[i], number) && number >= 1 && number <= 16384 &&
      number == std::floor(number);
    size[i] = good ? static_cast<int>(number) : 0;
  }
  if (!good)
  {
    Refuse(option, "WIDTHxHEIGHT in pixels from 1 to 16384, such as 800x600", text);
  }
  return size;
}

Vector3 parseVector(const std::string& option, const std::string& text)
{
  Vector3 v;
  if (!parseThreeNumbers(text, v))
  {
    Refuse(option, "three numbers X,Y,Z, such as 0.5,-1,2", text);
  }
  return v;
}

Vector3 parseColor(const std::string& option, const std::string& text)
{
  Vector3 rgb;
  if (parseThreeNumbers(text, rgb))
  {
    if (*std::min_element(rgb.begin(), rgb.end()) < 0.0 ||
      *std::max_element(rgb.begin(), rgb.end()) > 1.0)
    {
      Refuse(option, "red, green and blue from 0 to 1", text);
    }
    return rgb;
  }
  vtkNew<vtkNamedColors> names;
  if (!names->ColorExists(text))
  {
    Refuse(option, "R,G,B from 0 to 1 or the name of a colour, such as white", text);
  }
  const vtkColor3d color = names->GetColor3d(text);
  return { { color.GetRed(), color.GetGreen(), color.GetBlue() } };
}

std::optional<int> parseComponent(const std::string& option, const std::string& text)
{
  if (text == "magnitude")
  {
    return std::nullopt;
  }
  double number;
  if (!parseNumber(text, number) || number < 0 || number > 1000 || number != std::floor(number))
  {
    Refuse(option, "'magnitude' or a number that counts from 0", text);
  }
  return static_cast<int>(number);
}

std::vector<double> parseNumbers(const std::string& option, const std::string& text)
{
  std::vector<double> numbers;
  for (const std::string& part : splitText(text, ','))
  {
    double number = 0.0;
    if (!parseNumber(part, number))
    {
      Refuse(option, "numbers, separated by commas, such as 1.5,2", part);
    }
    numbers.push_back(number);
  }
  return numbers;
}

std::vector<OpacityPoint> parseOpacity(const std::string& option, const std::string& text)
{
  const std::string expected = "points value:opacity, separated by commas, such as 0:0,4:0.1,8:0.5";
  std::vector<OpacityPoint> points;
  for (const std::string& part : splitText(text, ','))
  {
    const auto pair = splitText(part, ':');
    OpacityPoint point;
    if (pair.size() != 2 || !parseNumber(pair[0], point.Value) ||
      !parseNumber(pair[1], point.Opacity))
    {
      Refuse(option, expected, part);
    }
    if (point.Opacity < 0.0 || point.Opacity > 1.0)
    {
      Refuse(option, "opacities from 0 to 1", part);
    }
    if (!points.empty() && point.Value <= points.back().Value)
    {
      Refuse(option, "points in the order of rising values", text);
    }
    points.push_back(point);
  }
  return points;
}

}
