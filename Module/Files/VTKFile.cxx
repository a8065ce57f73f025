// SPDX-License-Identifier: BSD-3-Clause
#include "Files/VTKFile.h"

#include "Files/TextScanner.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace exabricks
{
namespace
{
constexpr std::uintmax_t LargestText = std::uintmax_t(1) << 31;
constexpr std::int64_t MostComponents = 1024;
constexpr std::uint64_t MostBytes = std::uint64_t(1) << 62; // of an array

// Bits of a value; 0: they differ.
const std::map<std::string, std::uint64_t> TypeBits = { { "Float32", 32 }, { "Float64", 64 },
  { "Int8", 8 }, { "UInt8", 8 }, { "Int16", 16 }, { "UInt16", 16 }, { "Int32", 32 },
  { "UInt32", 32 }, { "Int64", 64 }, { "UInt64", 64 }, { "Bit", 1 }, { "String", 0 } };

bool isBlank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

std::uint64_t base64Length(std::uint64_t bytes) { return (bytes + 2) / 3 * 4; }

int base64Digit(char c)
{
  static const std::string digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t place = digits.find(c);
  return place == std::string::npos ? -1 : static_cast<int>(place);
}

// Up to the first character that is none of the encoding's.
std::string decodeBase64(const std::string& text)
{
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text)
  {
    const int digit = base64Digit(c);
    if (digit < 0)
    {
      break;
    }
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count >= 8)
    {
      count -= 8;
      bytes += static_cast<char>(bits >> count & 0xff);
    }
  }
  return bytes;
}
}

VTKFile::VTKFile(const std::filesystem::path& path, std::string shown)
  : File(path)
  , Shown(std::move(shown))
{
  this->ReadUpToData(path);
  this->Root = readXML(this->Shown, this->Text);
  this->CheckRoot();
  this->CheckText(this->Root);
}

void VTKFile::ReadUpToData(const std::filesystem::path& path)
{
  const std::string mark = "<AppendedData"; // VTK looks for no more
  const std::size_t step = 1 << 16;
  std::size_t markPlace = std::string::npos;
  while (this->Text.size() < this->File.size())
  {
    const std::size_t before = this->Text.size();
    this->Text += this->File.read(before, step);
    const std::size_t first = this->Text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    if (this->Text.size() == before || first == std::string::npos || this->Text[first] != '<')
    {
      break; // no XML, which the reader says
    }
    if (markPlace == std::string::npos)
    {
      markPlace = this->Text.find(mark, before < mark.size() ? 0 : before - mark.size());
    }
    const std::size_t end =
      markPlace == std::string::npos ? markPlace : this->Text.find('>', markPlace);
    if (end != std::string::npos)
    {
      this->Text.resize(end + 1);
      const std::string next = this->File.read(end + 1, 256);
      const auto place = std::find_if_not(next.begin(), next.end(), isBlank);
      if (place == next.end() || *place != '_')
      {
        throw FileFault(
          "expected '_' after the tag 'AppendedData' of " + this->Shown + ", found something else");
      }
      this->AppendedBegin = end + 2 + static_cast<std::uintmax_t>(place - next.begin());
      return;
    }
    if (this->Text.size() > LargestText)
    {
      throw FileFault("expected less than 2^31 bytes of text, found a file of " +
        std::to_string(this->File.size()) + " bytes in '" + path.string() + "'");
    }
  }
}

void VTKFile::CheckRoot()
{
  if (this->Root.name != "VTKFile")
  {
    this->fail(this->Root, "an element 'VTKFile'", inQuotes(this->Root.name));
  }
  const auto among = [&](const std::string& attribute, const std::vector<std::string>& values,
                       const std::string& otherwise)
  {
    const std::string* value = this->Root.find(attribute);
    if (value && std::find(values.begin(), values.end(), *value) == values.end())
    {
      this->fail(this->Root, "one of VTK's values of '" + attribute + "'", inQuotes(*value));
    }
    return value ? *value : otherwise;
  };
  this->IsBigEndian =
    among("byte_order", { "LittleEndian", "BigEndian" }, "LittleEndian") == "BigEndian";
  this->HeadWidth = among("header_type", { "UInt32", "UInt64" }, "UInt32") == "UInt64" ? 8 : 4;
  this->IsCompressed = !among(
    "compressor", { "vtkZLibDataCompressor", "vtkLZ4DataCompressor", "vtkLZMADataCompressor" }, "")
                          .empty();
  if (this->AppendedBegin > 0)
  {
    const XMLElement& data = this->child(this->Root, "AppendedData");
    const std::string& encoding = this->text(data, "encoding");
    if (encoding != "raw" && encoding != "base64")
    {
      this->fail(data, "the encoding 'raw' or 'base64'", inQuotes(encoding));
    }
    this->IsAppendedBase64 = encoding == "base64";
  }
}

// An element whose first character was changed would be text, which VTK passes without a word.
void VTKFile::CheckText(const XMLElement& element) const
{
  static const std::set<std::string> withoutText{ "VTKFile", "vtkOverlappingAMR",
    "vtkHierarchicalBoxDataSet", "Block", "DataSet", "ImageData", "Piece", "PointData", "CellData",
    "FieldData" };
  if (withoutText.count(element.name) > 0)
  {
    if (element.hasText)
    {
      this->fail(element, "nothing but elements inside '" + element.name + "'", "text");
    }
    for (const XMLElement& child : element.children)
    {
      this->CheckText(child);
    }
  }
}

void VTKFile::fail(
  const XMLElement& element, const std::string& expected, const std::string& found) const
{
  throw FileFault("expected " + expected + " in line " + std::to_string(element.line) + " of " +
    this->Shown + ", found " + found);
}

const XMLElement& VTKFile::child(const XMLElement& parent, const std::string& name) const
{
  const auto isIt = [&](const XMLElement& element) { return element.name == name; };
  const auto count = std::count_if(parent.children.begin(), parent.children.end(), isIt);
  if (count != 1)
  {
    this->fail(parent, "one element '" + name + "' inside '" + parent.name + "'",
      std::to_string(count) + " of them");
  }
  return *std::find_if(parent.children.begin(), parent.children.end(), isIt);
}

const std::string& VTKFile::text(const XMLElement& element, const std::string& attribute) const
{
  const std::string* text = element.find(attribute);
  if (!text || text->empty())
  {
    this->fail(element, "a value of '" + attribute + "' of '" + element.name + "'", "none");
  }
  return *text;
}

std::vector<std::int64_t> VTKFile::integers(const XMLElement& element, const std::string& attribute,
  std::size_t count, std::int64_t least, std::int64_t most) const
{
  TextScanner scanner(this->Shown, this->text(element, attribute), element.line);
  std::vector<std::int64_t> integers;
  while (integers.size() < count)
  {
    integers.push_back(scanner.integer("a number in '" + attribute + "'", least, most));
  }
  if (!scanner.isAtEnd())
  {
    scanner.fail(std::to_string(count) + " numbers in '" + attribute + "'", "more");
  }
  return integers;
}

std::vector<double> VTKFile::numbers(
  const XMLElement& element, const std::string& attribute, std::size_t count) const
{
  TextScanner scanner(this->Shown, this->text(element, attribute), element.line);
  std::vector<double> numbers;
  while (numbers.size() < count)
  {
    numbers.push_back(scanner.number("a number in '" + attribute + "'"));
  }
  if (!scanner.isAtEnd())
  {
    scanner.fail(std::to_string(count) + " numbers in '" + attribute + "'", "more");
  }
  return numbers;
}

void VTKFile::checkArrays(const XMLElement& attributes, std::uint64_t tuples)
{
  std::set<std::string> names;
  for (const XMLElement& array : attributes.children)
  {
    // VTK's reader is lost where two have one name.
    if (!names.insert(this->text(array, "Name")).second)
    {
      this->fail(
        array, "arrays with names of their own", inQuotes(this->text(array, "Name")) + " twice");
    }
    this->CheckArray(array, &tuples);
  }
}

void VTKFile::checkFieldData(const XMLElement& parent)
{
  for (const XMLElement& data : parent.children)
  {
    for (std::size_t i = 0; data.name == "FieldData" && i < data.children.size(); ++i)
    {
      const XMLElement& array = data.children[i];
      std::uint64_t tuples = 0;
      if (array.find("NumberOfTuples"))
      {
        tuples = static_cast<std::uint64_t>(
          this->integers(array, "NumberOfTuples", 1, 0, INT64_MAX).front());
      }
      this->CheckArray(array, array.find("NumberOfTuples") ? &tuples : nullptr);
    }
  }
}

void VTKFile::CheckKeys(const XMLElement& array) const
{
  for (const XMLElement& key : array.children)
  {
    if (key.name == "InformationKey" && key.find("length"))
    {
      const auto values = std::count_if(key.children.begin(), key.children.end(),
        [](const XMLElement& value) { return value.name == "Value"; });
      this->integers(key, "length", 1, values, values);
    }
  }
}

// `tuples`: how many values each component ought to have, null if it does not say.
void VTKFile::CheckArray(const XMLElement& array, const std::uint64_t* tuples)
{
  if (array.name != "DataArray" && array.name != "Array")
  {
    this->fail(array, "an element 'DataArray'", inQuotes(array.name));
  }
  const auto type = TypeBits.find(this->text(array, "type"));
  if (type == TypeBits.end())
  {
    this->fail(array, "a type of VTK's values", inQuotes(this->text(array, "type")));
  }
  const std::uint64_t components = array.find("NumberOfComponents")
    ? static_cast<std::uint64_t>(
        this->integers(array, "NumberOfComponents", 1, 1, MostComponents).front())
    : 1;
  this->CheckKeys(array);
  const std::uint64_t bits = type->second;
  if (tuples && *tuples > MostBytes / components / std::max<std::uint64_t>(bits / 8, 1))
  {
    this->fail(array, "at most 2^62 bytes of data",
      std::to_string(*tuples) + " values of " + std::to_string(components) + " components");
  }
  const std::uint64_t values = tuples ? *tuples * components : 0;

  // VTK goes by the offset, whatever the format is said to be.
  const std::string format = array.find("format") ? this->text(array, "format") : "ascii";
  const bool isAppended = array.find("offset") != nullptr;
  if (isAppended != (format == "appended") ||
    (!isAppended && format != "ascii" && format != "binary"))
  {
    this->fail(array, "the format 'appended' with an offset, 'binary' or 'ascii' without",
      inQuotes(format) + (isAppended ? " with one" : " without"));
  }
  const auto textBegin = this->Text.begin() + static_cast<std::ptrdiff_t>(array.textBegin);
  const auto textEnd = this->Text.begin() + static_cast<std::ptrdiff_t>(array.textEnd);
  if (format == "ascii")
  {
    std::uint64_t found = 0;
    for (auto c = textBegin; c != textEnd; ++c)
    {
      found += !isBlank(*c) && (c == textBegin || isBlank(*(c - 1)));
    }
    if (tuples && bits > 0 ? found != values : found < values)
    {
      this->fail(array, std::to_string(values) + " values", std::to_string(found));
    }
    return;
  }
  std::uint64_t size = 0;
  if (isAppended)
  {
    if (this->AppendedBegin == 0)
    {
      this->fail(array, "appended data at the end of the file", "none");
    }
    const auto offset = this->integers(array, "offset", 1, 0, INT64_MAX / 2).front();
    this->Appended.push_back(
      this->FindData(array, this->AppendedBegin + static_cast<std::uintmax_t>(offset),
        this->File.size(), this->IsAppendedBase64, size));
  }
  else
  {
    const auto first = std::find_if_not(textBegin, textEnd, isBlank);
    auto last = textEnd;
    while (last != first && isBlank(*(last - 1)))
    {
      --last;
    }
    const auto end = static_cast<std::uintmax_t>(last - this->Text.begin());
    const Span span = this->FindData(
      array, static_cast<std::uintmax_t>(first - this->Text.begin()), end, true, size);
    if (span.end != end)
    {
      this->fail(array, "data of " + std::to_string(size) + " bytes", "more");
    }
  }
  const std::uint64_t wanted =
    bits == 1 ? (values + 7) / 8 : values * std::max<std::uint64_t>(bits / 8, 1);
  if (tuples && (bits > 0 ? size != wanted : size < wanted))
  {
    this->fail(array,
      std::to_string(wanted) + " bytes of data for " + std::to_string(values) + " values",
      std::to_string(size));
  }
}

// Some bytes of those that are stored, perhaps encoded, from `begin` on.
std::string VTKFile::ReadDecoded(
  std::uintmax_t begin, bool isBase64, std::uint64_t first, std::size_t count)
{
  if (!isBase64)
  {
    return this->File.read(begin + first, count);
  }
  const std::uint64_t group = first / 3;
  const std::string bytes = decodeBase64(this->File.read(
    begin + 4 * group, static_cast<std::size_t>(base64Length(first - 3 * group + count))));
  return bytes.substr(std::min<std::size_t>(first - 3 * group, bytes.size()), count);
}

std::uint64_t VTKFile::SumOfParts(
  const XMLElement& array, std::uintmax_t begin, bool isBase64, std::uint64_t parts)
{
  std::uint64_t sum = 0;
  for (std::uint64_t part = 0; part < parts;)
  {
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(parts - part, 1 << 12));
    const std::string heads =
      this->ReadDecoded(begin, isBase64, (3 + part) * this->HeadWidth, count * this->HeadWidth);
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::uint64_t size = heads.size() < (i + 1) * this->HeadWidth
        ? 0
        : wholeNumber(heads, i * this->HeadWidth, this->HeadWidth, this->IsBigEndian);
      if (size == 0 || size > this->File.size() || sum > this->File.size())
      {
        this->fail(array, "sizes of compressed data that the file has room for",
          std::to_string(size) + " bytes");
      }
      sum += size;
    }
    part += count;
  }
  return sum;
}

// Where an array's data are, which begin with their size or, if they are compressed, with the
// number of parts, their size before, that of the last part, and the sizes after. `size`: of the
// data without compression. They have to end before `end`.
VTKFile::Span VTKFile::FindData(const XMLElement& array, std::uintmax_t begin, std::uintmax_t end,
  bool isBase64, std::uint64_t& size)
{
  const std::size_t width = this->HeadWidth;
  const std::string head =
    this->ReadDecoded(begin, isBase64, 0, (this->IsCompressed ? 3 : 1) * width);
  if (head.size() < (this->IsCompressed ? 3 : 1) * width)
  {
    this->fail(array, "data from byte " + std::to_string(begin) + " on", "none that can be read");
  }
  const std::uint64_t first = wholeNumber(head, 0, width, this->IsBigEndian);
  const std::uint64_t room = end > begin ? end - begin : 0;
  if (first > room)
  {
    this->fail(array,
      std::to_string(first) + (this->IsCompressed ? " parts" : " bytes") + " of data from byte " +
        std::to_string(begin) + " on",
      std::to_string(room) + " bytes up to their end");
  }
  Span span{ begin, begin };
  size = first;
  if (this->IsCompressed)
  {
    const std::uint64_t partSize = wholeNumber(head, width, width, this->IsBigEndian);
    const std::uint64_t lastSize = wholeNumber(head, 2 * width, width, this->IsBigEndian);
    if (first > 0 && (partSize == 0 || partSize > MostBytes / first || lastSize > partSize))
    {
      this->fail(array, "parts of compressed data of one size, and a last one that is not larger",
        std::to_string(first) + " of " + std::to_string(partSize) + " bytes, the last of " +
          std::to_string(lastSize));
    }
    size = first == 0 ? 0 : (first - 1) * partSize + (lastSize == 0 ? partSize : lastSize);
    const std::uint64_t headBytes = (3 + first) * width;
    const std::uint64_t stored = this->SumOfParts(array, begin, isBase64, first);
    span.end += isBase64 ? base64Length(headBytes) + base64Length(stored) : headBytes + stored;
  }
  else
  {
    span.end += isBase64 ? base64Length(width + size) : width + size;
  }
  if (span.end > end)
  {
    this->fail(array,
      "data from byte " + std::to_string(begin) + " to byte " + std::to_string(span.end),
      "their end at byte " + std::to_string(end));
  }
  return span;
}

// They lie one behind the other, and some may be those of two arrays.
void VTKFile::checkAppendedData()
{
  if (this->AppendedBegin == 0)
  {
    return;
  }
  std::sort(this->Appended.begin(), this->Appended.end(),
    [](const Span& a, const Span& b) { return a.begin < b.begin; });
  Span last{ this->AppendedBegin, this->AppendedBegin };
  const XMLElement& element = this->child(this->Root, "AppendedData");
  for (const Span& span : this->Appended)
  {
    if (span.begin != last.end && (span.begin != last.begin || span.end != last.end))
    {
      this->fail(element, "an array's data from byte " + std::to_string(last.end) + " on",
        "the next to begin at byte " + std::to_string(span.begin));
    }
    last = span;
  }
  std::string rest = this->File.read(last.end, 256);
  rest.erase(std::remove_if(rest.begin(), rest.end(), isBlank), rest.end());
  if (rest != "</AppendedData></VTKFile>")
  {
    this->fail(element,
      "the end of the appended data and of the file after byte " + std::to_string(last.end),
      rest.empty() ? "nothing" : "something else");
  }
}
}
