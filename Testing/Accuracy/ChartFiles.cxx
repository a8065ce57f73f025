// SPDX-License-Identifier: BSD-3-Clause
#include "Accuracy/Charts.h"
#include "Accuracy/CsvTable.h"

#include <algorithm>
#include <fstream>

namespace exabricks
{
namespace accuracy
{
namespace
{
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
  CsvTable table({ "chart", "series", "x", "y" });
  for (const Chart& chart : charts)
  {
    for (const Series& series : chart.series)
    {
      for (const auto& point : series.points)
      {
        if (series.style != Series::Style::Guide && series.style != Series::Style::Front)
        {
          table.add({ chart.name, series.name, csvNumber(point.first), csvNumber(point.second) });
        }
      }
    }
  }
  std::ofstream out(file);
  out << table.text();
  return static_cast<bool>(out);
}

std::vector<Chart> readCsv(const std::string& file)
{
  const CsvTable table = CsvTable::read(file);
  for (const char* column : { "chart", "series", "x", "y" })
  {
    if (!table.has(column))
    {
      return {};
    }
  }
  std::vector<Chart> charts;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    Series& series =
      named(named(charts, table.field(row, "chart")).series, table.field(row, "series"));
    series.points.emplace_back(table.number(row, "x"), table.number(row, "y"));
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
