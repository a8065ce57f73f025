// SPDX-License-Identifier: BSD-3-Clause
#include "Accuracy/CsvTable.h"

#include <cmath>
#include <cstdio>
#include <fstream>

namespace exabricks
{
namespace accuracy
{
namespace
{
std::string quotedIfNeeded(const std::string& text)
{
  if (text.find_first_of(",\"") == std::string::npos)
  {
    return text;
  }
  std::string result = "\"";
  for (const char c : text)
  {
    result += c == '"' ? std::string("\"\"") : std::string(1, c);
  }
  return result + "\"";
}

void append(std::string& text, const std::vector<std::string>& fields)
{
  for (std::size_t i = 0; i < fields.size(); ++i)
  {
    text += (i > 0 ? "," : "") + quotedIfNeeded(fields[i]);
  }
  text += '\n';
}
}

std::string CsvTable::text() const
{
  std::string text;
  append(text, this->Columns);
  for (const auto& row : this->Rows)
  {
    append(text, row);
  }
  return text;
}

bool CsvTable::write(const std::string& file) const
{
  std::ofstream out(file);
  out << this->text();
  return static_cast<bool>(out.flush());
}

std::string csvNumber(double value)
{
  if (std::isnan(value))
  {
    return {};
  }
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}
}
}
