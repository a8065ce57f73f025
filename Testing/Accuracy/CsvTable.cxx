// SPDX-License-Identifier: BSD-3-Clause
#include "Accuracy/CsvTable.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>

namespace exabricks
{
namespace accuracy
{
namespace
{
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

CsvTable CsvTable::parse(const std::string& text)
{
  std::istringstream in(text);
  std::string line;
  if (!std::getline(in, line))
  {
    return {};
  }
  CsvTable table(fieldsOf(line));
  while (std::getline(in, line))
  {
    std::vector<std::string> fields = fieldsOf(line);
    if (fields.size() >= table.Columns.size())
    {
      table.Rows.push_back(std::move(fields));
    }
  }
  return table;
}

CsvTable CsvTable::read(const std::string& file)
{
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return parse(text.str());
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

std::size_t CsvTable::Find(const std::string& column) const
{
  return std::find(this->Columns.begin(), this->Columns.end(), column) - this->Columns.begin();
}

bool CsvTable::has(const std::string& column) const
{
  return this->Find(column) < this->Columns.size();
}

std::string CsvTable::field(std::size_t row, const std::string& column) const
{
  const std::size_t at = this->Find(column);
  return at < this->Columns.size() ? this->Rows[row][at] : std::string();
}

double CsvTable::number(std::size_t row, const std::string& column) const
{
  const std::string text = this->field(row, column);
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return end == text.c_str() ? std::numeric_limits<double>::quiet_NaN() : value;
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
