// SPDX-License-Identifier: BSD-3-Clause
// Places of a file, read where a header says that something is there. What a header says may be
// anything: nothing is allocated by it, and what lies behind the end of the file is not there.
#ifndef ExaBricksFilesBytes_h
#define ExaBricksFilesBytes_h

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace exabricks
{
class Bytes
{
public:
  /// Throws a FileFault if there is no file that can be read; folders and devices are none.
  explicit Bytes(const std::filesystem::path& path);

  std::uintmax_t size() const { return this->Size; }
  /// `count` bytes from `begin` on, or those that there are.
  std::string read(std::uintmax_t begin, std::size_t count);

private:
  std::ifstream File;
  std::uintmax_t Size = 0;
};

/// A number of up to eight bytes, which begin at `at`.
std::uint64_t wholeNumber(
  const std::string& bytes, std::size_t at, std::size_t width, bool bigEndian = false);

/// A whole file of text. Throws a FileFault also if it is too large for a header.
std::string readText(const std::filesystem::path& path);
}

#endif
