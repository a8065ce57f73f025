// SPDX-License-Identifier: BSD-3-Clause
// What was measured, as text: fields between commas, in quotes where they hold commas or quotes
// themselves.
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

  const std::vector<std::string>& columns() const { return this->Columns; }
  std::size_t size() const { return this->Rows.size(); }

  /// Fields in the order of the columns.
  void add(const std::vector<std::string>& row) { this->Rows.push_back(row); }

  std::string text() const;
  /// Whether the file was written.
  bool write(const std::string& file) const;

private:
  std::vector<std::string> Columns;
  std::vector<std::vector<std::string>> Rows;
};

/// With ten digits; nothing for NaN.
std::string csvNumber(double value);
}
}

#endif
