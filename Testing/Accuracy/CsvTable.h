// SPDX-License-Identifier: BSD-3-Clause
// Tables as text: fields between commas, in quotes where they hold commas or quotes themselves.
#ifndef ExaBricksAccuracyCsvTable_h
#define ExaBricksAccuracyCsvTable_h

#include <cstddef>
#include <string>
#include <vector>

namespace exabricks
{
namespace accuracy
{
class CsvTable
{
public:
  CsvTable() = default;
  explicit CsvTable(const std::vector<std::string>& columns)
    : Columns(columns)
  {
  }

  /// Lines with too few fields are passed over. An empty table if the text has no first line.
  static CsvTable parse(const std::string& text);
  static CsvTable read(const std::string& file);
  std::string text() const;

  const std::vector<std::string>& columns() const { return this->Columns; }
  bool has(const std::string& column) const;
  std::size_t size() const { return this->Rows.size(); }

  /// Fields in the order of the columns.
  void add(const std::vector<std::string>& row) { this->Rows.push_back(row); }
  /// Empty, and NaN, where there is no such column or nothing in it.
  std::string field(std::size_t row, const std::string& column) const;
  double number(std::size_t row, const std::string& column) const;

private:
  std::size_t Find(const std::string& column) const;

  std::vector<std::string> Columns;
  std::vector<std::vector<std::string>> Rows;
};

/// With ten digits; nothing for NaN.
std::string csvNumber(double value);
}
}

#endif
