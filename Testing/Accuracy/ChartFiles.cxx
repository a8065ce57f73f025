// SPDX-License-Identifier: BSD-3-Clause
#include "Accuracy/Charts.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iomanip>

namespace exabricks
{
namespace accuracy
{
namespace
{
// Fields of a line; in quotes they may hold commas, and quotes doubled.
std::vector<std::string> fieldsOf(const std::string& line)
{
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    const char c = line[i];
    if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"')
    {
      fields.back() += line[++i];
    }
    else if (c == '"')
    {
      quoted = !quoted;
    }
    else if (c == ',' && !quoted)
    {
      fields.emplace_back();
    }
    else if (c != '\r')
    {
      fields.back() += c;
    }
  }
  return fields;
}

std::string quoted(const std::string& text)
{
  std::string result = "\"";
  for (const char c : text)
  {
    result += c == '"' ? std::string("\"\"") : std::string(1, c);
  }
  return result + "\"";
}

// The item of that name, made if there is none yet.
template <typename Item>
Item& named(std::vector<Item>& items, const std::string& name)
{
  const auto found =
    std::find_if(items.begin(), items.end(), [&](const Item& item) { return item.name == name; });
  if (found != items.end())
  {
    return *found;
  }
  items.emplace_back();
  items.back().name = name;
  return items.back();
}
}

bool writeCsv(const std::vector<Chart>& charts, const std::string& file)
{
  std::ofstream out(file);
  out << "chart,series,x,y\n" << std::setprecision(10);
  for (const Chart& chart : charts)
  {
    for (const Series& series : chart.series)
    {
      for (const auto& point : series.points)
      {
        if (series.style != Series::Style::Guide)
        {
          out << quoted(chart.name) << ',' << quoted(series.name) << ',' << point.first << ','
              << point.second << '\n';
        }
      }
    }
  }
  return static_cast<bool>(out);
}

std::vector<Chart> readCsv(const std::string& file)
{
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> header = fieldsOf(line);
  std::array<std::size_t, 4> columns{};
  const char* const names[] = { "chart", "series", "x", "y" };
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    columns[i] = std::find(header.begin(), header.end(), names[i]) - header.begin();
    if (columns[i] == header.size())
    {
      return {};
    }
  }
  std::vector<Chart> charts;
  while (std::getline(in, line))
  {
    const std::vector<std::string> fields = fieldsOf(line);
    if (fields.size() < header.size())
    {
      continue;
    }
    Series& series = named(named(charts, fields[columns[0]]).series, fields[columns[1]]);
    series.points.emplace_back(std::strtod(fields[columns[2]].c_str(), nullptr),
      std::strtod(fields[columns[3]].c_str(), nullptr));
  }
  for (Chart& chart : charts)
  {
    chart.title = chart.name;
    for (Series& series : chart.series)
    {
      std::sort(series.points.begin(), series.points.end());
    }
  }
  return charts;
}
}
}
