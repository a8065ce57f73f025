// SPDX-License-Identifier: BSD-3-Clause
#include "Files/Bytes.h"

#include "Files/TextScanner.h"

#include <algorithm>

namespace exabricks
{
namespace
{
constexpr std::uintmax_t LargestText = std::uintmax_t(1) << 31;
}

Bytes::Bytes(const std::filesystem::path& path)
{
  std::error_code error;
  // Opening a FIFO would wait for one who writes.
  if (std::filesystem::is_regular_file(path, error))
  {
    this->Size = std::filesystem::file_size(path, error);
    this->File.open(path, std::ios::binary);
  }
  if (error || !this->File.is_open())
  {
    throw FileFault("expected the file '" + path.string() + "', found none that can be read");
  }
}

std::string Bytes::read(std::uintmax_t begin, std::size_t count)
{
  if (begin >= this->Size)
  {
    return {};
  }
  std::string bytes(
    static_cast<std::size_t>(std::min<std::uintmax_t>(count, this->Size - begin)), '\0');
  this->File.clear();
  this->File.seekg(static_cast<std::streamoff>(begin));
  this->File.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(this->File.gcount(), 0)));
  return bytes;
}

std::uint64_t wholeNumber(
  const std::string& bytes, std::size_t at, std::size_t width, bool bigEndian)
{
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < width; ++i)
  {
    const std::size_t place = at + (bigEndian ? i : width - 1 - i);
    number = number << 8 | static_cast<unsigned char>(bytes.at(place));
  }
  return number;
}

std::string readText(const std::filesystem::path& path)
{
  Bytes bytes(path);
  if (bytes.size() > LargestText)
  {
    throw FileFault("expected a header of text, found a file of " + std::to_string(bytes.size()) +
      " bytes in '" + path.string() + "'");
  }
  return bytes.read(0, static_cast<std::size_t>(bytes.size()));
}
}
