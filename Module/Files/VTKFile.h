// SPDX-License-Identifier: BSD-3-Clause
// A file of one of VTK's XML formats: its elements, and whether the data of its arrays are as long
// as they ought to be. The format: VTK, IO/XML/vtkXMLWriter.cxx and
// IO/XMLParser/vtkXMLDataParser.cxx.
#ifndef ExaBricksFilesVTKFile_h
#define ExaBricksFilesVTKFile_h

#include "Files/Bytes.h"
#include "Files/XMLText.h"

#include <array>
#include <vector>

namespace exabricks
{
/// All that finds a fault throws it as FileFault.
class VTKFile
{
public:
  /// `shown`: its name in faults.
  VTKFile(const std::filesystem::path& path, std::string shown);

  const std::string& name() const { return this->Shown; }
  const XMLElement& root() const { return this->Root; }
  /// The one child of this name.
  const XMLElement& child(const XMLElement& parent, const std::string& name) const;
  /// At least `least`, and at most `most`, numbers of an attribute.
  std::vector<std::int64_t> integers(const XMLElement& element, const std::string& attribute,
    std::size_t count, std::int64_t least, std::int64_t most) const;
  std::vector<double> numbers(
    const XMLElement& element, const std::string& attribute, std::size_t count) const;
  const std::string& text(const XMLElement& element, const std::string& attribute) const;

  /// PointData or CellData, whose arrays have so many values for each component.
  void checkArrays(const XMLElement& attributes, std::uint64_t tuples);
  /// FieldData; its arrays say themselves how many values they have.
  void checkFieldData(const XMLElement& parent);
  /// To be called last: all of the appended data are those of an array that was checked.
  void checkAppendedData();

  [[noreturn]] void fail(
    const XMLElement& element, const std::string& expected, const std::string& found) const;

private:
  struct Span
  {
    std::uintmax_t begin = 0;
    std::uintmax_t end = 0;
  };

  void ReadUpToData(const std::filesystem::path& path);
  void CheckRoot();
  void CheckText(const XMLElement& element) const;
  void CheckArray(const XMLElement& array, const std::uint64_t* tuples);
  void CheckKeys(const XMLElement& array) const;
  Span FindData(const XMLElement& array, std::uintmax_t begin, std::uintmax_t end, bool isBase64,
    std::uint64_t& size);
  std::uint64_t SumOfParts(
    const XMLElement& array, std::uintmax_t begin, bool isBase64, std::uint64_t parts);
  std::string ReadDecoded(
    std::uintmax_t begin, bool isBase64, std::uint64_t first, std::size_t count);

  Bytes File;
  std::string Shown;
  std::string Text; // up to the raw data
  XMLElement Root;
  bool IsBigEndian = false;
  std::size_t HeadWidth = 4; // of the numbers before each array's data
  bool IsCompressed = false;
  std::uintmax_t AppendedBegin = 0; // 0: there are none
  bool IsAppendedBase64 = false;
  std::vector<Span> Appended;
};
}

#endif
