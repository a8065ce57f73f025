// SPDX-License-Identifier: BSD-3-Clause
// The elements of an XML file, as VTK writes them. Expat, which VTK reads them with, would be one
// more library for what takes a page here: VTK's files have elements and attributes, no entities
// of their own, and raw bytes at their end, at which a parser has to stop.
#ifndef ExaBricksFilesXMLText_h
#define ExaBricksFilesXMLText_h

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace exabricks
{
struct XMLElement
{
  std::string name;
  std::size_t line = 0;
  std::map<std::string, std::string> attributes;
  std::vector<XMLElement> children;
  std::size_t textBegin = 0; // what stands between its tag and the next one
  std::size_t textEnd = 0;
  bool hasText = false; // whether there is more than blanks anywhere between its tags

  /// Null, if it has none of that name.
  const std::string* find(const std::string& attribute) const;
};

/// Reads the one element that a text consists of, up to the tag AppendedData, if it has one: what
/// follows may be raw bytes, and VTK stops there, too. `file`: for faults, which are thrown as
/// FileFault.
XMLElement readXML(const std::string& file, const std::string& text);
}

#endif
