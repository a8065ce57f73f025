// SPDX-License-Identifier: BSD-3-Clause
// What lies in an HDF5 file: names of groups and data sets, and the shapes of these. HDF5's own
// library is not asked, as the one that VTK carries cannot be linked beside another. Read are
// groups of the old kind, tables of symbols, which are all that Enzo writes. The format: HDF5 File
// Format Specification Version 3.0, sections II.A, III.A, III.B, III.D and IV.A.
#ifndef ExaBricksFilesHDF5File_h
#define ExaBricksFilesHDF5File_h

#include "Files/Bytes.h"

#include <functional>
#include <map>
#include <vector>

namespace exabricks
{
/// All that finds a fault throws it as FileFault.
class HDF5File
{
public:
  using Members = std::map<std::string, std::uint64_t>; // names, and places of their objects

  struct Object
  {
    bool isKnown = false; // whether it is of a kind that is read here
    bool isGroup = false;
    std::vector<std::uint64_t> shape; // of a data set
    int valueClass = -1;              // 0: whole numbers, 1: floating point
    std::uint64_t valueBytes = 0;

    std::uint64_t tree = 0; // where a group's names are
    std::uint64_t heap = 0;
  };

  /// Finds files that are none of HDF5, or shorter than they say. `shown`: its name in faults.
  HDF5File(const std::filesystem::path& path, std::string shown);

  /// The place of the group that all others are in; 0, if the file is not of a kind that is read.
  std::uint64_t root() const { return this->Root; }
  Object readObject(std::uint64_t place);
  Members readMembers(const Object& group);

private:
  using Message = std::function<void(std::uint64_t type, const std::string& data)>;

  std::string ReadUpTo(std::uint64_t place, std::size_t count);
  std::string Read(std::uint64_t place, std::size_t count, const char* what);
  void ForEachMessage(std::uint64_t place, const Message& visit);
  void ReadNode(std::uint64_t place, int level, std::uint64_t names, Members& members);
  void ReadSymbols(std::uint64_t place, std::uint64_t names, Members& members);

  Bytes File;
  std::string Shown;
  std::uint64_t Root = 0;
  std::uint64_t BytesRead = 0;
};
}

#endif
