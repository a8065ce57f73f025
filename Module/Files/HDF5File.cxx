// SPDX-License-Identifier: BSD-3-Clause
#include "Files/HDF5File.h"

#include "Files/TextScanner.h"

#include <algorithm>

namespace exabricks
{
namespace
{
constexpr std::size_t LongestName = 256;
constexpr std::size_t LongestHeader = 1 << 16; // of an object

std::uint64_t number(const std::string& bytes, std::size_t at, std::size_t width)
{
  if (at + width > bytes.size())
  {
    throw FileFault("expected longer messages in an HDF5 file, found one that ends early");
  }
  return wholeNumber(bytes, at, width);
}
}

HDF5File::HDF5File(const std::filesystem::path& path, std::string shown)
  : File(path)
  , Shown(std::move(shown))
{
  const std::string head = this->File.read(0, 96);
  if (head.substr(0, 8) != "\x89HDF\r\n\x1a\n")
  {
    throw FileFault(
      "expected an HDF5 file in " + this->Shown + ", found another, or a part of one");
  }
  const std::uint64_t version = number(head, 8, 1);
  const bool isOld = version < 2;
  const std::size_t places = isOld ? 24 + 4 * version : 12; // where base and end of the file are
  if (version > 3 || number(head, isOld ? 13 : 9, 1) != 8 || number(head, isOld ? 14 : 10, 1) != 8)
  {
    return;
  }
  const std::uint64_t base = number(head, places, 8);
  const std::uint64_t end = number(head, places + 16, 8);
  if (base != 0)
  {
    return;
  }
  if (end > this->File.size())
  {
    throw FileFault("expected " + std::to_string(end) + " bytes in " + this->Shown + ", found " +
      std::to_string(this->File.size()));
  }
  this->Root = isOld ? number(head, places + 40, 8) : 0;
}

// Parts may be damaged to lie in each other, without end. Those of whole files are read once, and
// names with what follows them.
std::string HDF5File::ReadUpTo(std::uint64_t place, std::size_t count)
{
  std::string bytes = this->File.read(place, count);
  this->BytesRead += bytes.size();
  if (this->BytesRead > 16 * this->File.size() + (1 << 20))
  {
    throw FileFault("expected groups that do not lie in each other in " + this->Shown +
      ", found some at byte " + std::to_string(place) + " that do");
  }
  return bytes;
}

std::string HDF5File::Read(std::uint64_t place, std::size_t count, const char* what)
{
  std::string bytes = this->ReadUpTo(place, count);
  if (bytes.size() < count)
  {
    throw FileFault("expected " + std::string(what) + " at byte " + std::to_string(place) + " of " +
      this->Shown + ", found the end of the file");
  }
  return bytes;
}

// Of an object's header, of version 1; others have none.
void HDF5File::ForEachMessage(std::uint64_t place, const Message& visit)
{
  const std::string head = this->Read(place, 16, "an object's header");
  if (number(head, 0, 1) != 1)
  {
    return;
  }
  std::uint64_t messages = number(head, 2, 2);
  std::vector<std::pair<std::uint64_t, std::uint64_t>> parts{ { place + 16, number(head, 8, 4) } };
  for (std::size_t i = 0; i < parts.size() && messages > 0; ++i)
  {
    const std::string part = this->Read(parts[i].first,
      static_cast<std::size_t>(std::min<std::uint64_t>(parts[i].second, LongestHeader)),
      "an object's messages");
    for (std::size_t at = 0; at + 8 <= part.size() && messages > 0; --messages)
    {
      const std::uint64_t type = number(part, at, 2);
      const auto size = static_cast<std::size_t>(number(part, at + 2, 2));
      const std::string data = part.substr(at + 8, size);
      if (type == 0x10)
      {
        parts.emplace_back(number(data, 0, 8), number(data, 8, 8));
      }
      visit(type, data);
      at += 8 + size;
    }
  }
}

HDF5File::Object HDF5File::readObject(std::uint64_t place)
{
  Object object;
  bool hasShape = false;
  this->ForEachMessage(place,
    [&](std::uint64_t type, const std::string& data)
    {
      if (type == 0x01) // the shape
      {
        const std::uint64_t version = number(data, 0, 1);
        const std::uint64_t rank = number(data, 1, 1);
        hasShape = version == 1 || version == 2;
        for (std::size_t i = 0; hasShape && i < rank; ++i)
        {
          object.shape.push_back(number(data, (version == 1 ? 8 : 4) + 8 * i, 8));
        }
      }
      else if (type == 0x03) // the type of the values
      {
        object.valueClass = static_cast<int>(number(data, 0, 1) & 0xf);
        object.valueBytes = number(data, 4, 4);
      }
      else if (type == 0x11) // the table of symbols
      {
        object.isGroup = true;
        object.tree = number(data, 0, 8);
        object.heap = number(data, 8, 8);
      }
    });
  object.isKnown = object.isGroup || (hasShape && object.valueClass >= 0);
  return object;
}

HDF5File::Members HDF5File::readMembers(const Object& group)
{
  const std::string heap = this->Read(group.heap, 32, "the names of a group");
  if (heap.substr(0, 4) != "HEAP")
  {
    throw FileFault("expected the names of a group at byte " + std::to_string(group.heap) + " of " +
      this->Shown + ", found something else");
  }
  Members members;
  this->ReadNode(group.tree, -1, number(heap, 24, 8), members);
  return members;
}

// A node of a B-tree; `level`: how many there are below it, -1 for the first.
void HDF5File::ReadNode(std::uint64_t place, int level, std::uint64_t names, Members& members)
{
  const std::string head = this->Read(place, 24, "a node of a group");
  const auto found = static_cast<int>(number(head, 5, 1));
  if (head.substr(0, 4) != "TREE" || number(head, 4, 1) != 0 || (level >= 0 && found != level))
  {
    throw FileFault("expected a node of a group at byte " + std::to_string(place) + " of " +
      this->Shown + ", found something else");
  }
  const auto children = static_cast<std::size_t>(number(head, 6, 2));
  const std::string keys = this->Read(place + 24, 16 * children, "the parts of a group");
  for (std::size_t i = 0; i < children; ++i)
  {
    const std::uint64_t child = number(keys, 16 * i + 8, 8);
    if (found > 0)
    {
      this->ReadNode(child, found - 1, names, members);
    }
    else
    {
      this->ReadSymbols(child, names, members);
    }
  }
}

void HDF5File::ReadSymbols(std::uint64_t place, std::uint64_t names, Members& members)
{
  const std::string head = this->Read(place, 8, "a table of symbols");
  if (head.substr(0, 4) != "SNOD")
  {
    throw FileFault("expected a table of symbols at byte " + std::to_string(place) + " of " +
      this->Shown + ", found something else");
  }
  const auto count = static_cast<std::size_t>(number(head, 6, 2));
  const std::string symbols = this->Read(place + 8, 40 * count, "a table of symbols");
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::string name = this->ReadUpTo(names + number(symbols, 40 * i, 8), LongestName);
    members[name.substr(0, std::min(name.find('\0'), name.size()))] =
      number(symbols, 40 * i + 8, 8);
  }
}
}
