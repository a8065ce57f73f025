// SPDX-License-Identifier: BSD-3-Clause
#include "Files/Plotfile.h"

#include "Files/Bytes.h"
#include "Files/TextScanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace exabricks
{
namespace
{
namespace fs = std::filesystem;

constexpr std::int64_t MostLevels = 64;
constexpr std::int64_t FarthestCell = std::int64_t(1) << 30; // indices are 32 bits wide

struct CellBox
{
  std::array<std::int64_t, 3> lo;
  std::array<std::int64_t, 3> hi; // the last cell

  std::int64_t cells() const
  {
    std::int64_t product = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      product *= this->hi[axis] - this->lo[axis] + 1;
    }
    return product;
  }
  bool operator==(const CellBox& other) const
  {
    return this->lo == other.lo && this->hi == other.hi;
  }
};

// ((lo) (hi) (centering)), each of three numbers
CellBox readBox(TextScanner& scanner)
{
  CellBox box{};
  const auto readPoint =
    [&](std::array<std::int64_t, 3>& point, const char* what, std::int64_t least, std::int64_t most)
  {
    scanner.expect('(');
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = scanner.integer(what, least, most);
      scanner.expect(axis < 2 ? ',' : ')');
    }
  };
  scanner.expect('(');
  readPoint(box.lo, "a box's first cell", -FarthestCell, FarthestCell);
  readPoint(box.hi, "a box's last cell", -FarthestCell, FarthestCell);
  std::array<std::int64_t, 3> centering{};
  readPoint(centering, "a box's centering, that of cells", 0, 0);
  scanner.expect(')');
  for (int axis = 0; axis < 3; ++axis)
  {
    // So that the product fits into 62 bits.
    if (box.hi[axis] < box.lo[axis] || box.hi[axis] - box.lo[axis] >= (1 << 20))
    {
      scanner.fail("a box of 1 to 2^20 cells along each axis",
        std::to_string(box.hi[axis] - box.lo[axis] + 1) + " along one");
    }
  }
  return box;
}

struct Level
{
  CellBox domain{};
  std::array<double, 3> spacing{};
  std::size_t grids = 0;
  std::vector<std::array<double, 6>> bounds; // of each grid, lower and upper along x, y and z
  std::string path;                          // of its boxes, without the ending _H
};

struct Header
{
  std::int64_t components = 0;
  std::array<double, 3> lower{};
  std::array<double, 3> upper{};
  std::vector<Level> levels;
};

bool near(double a, double b, double scale) { return std::abs(a - b) <= 1e-3 * std::abs(scale); }

Header readHeader(const fs::path& folder)
{
  TextScanner scanner("'Header'", readText(folder / "Header"));
  const std::string version = scanner.line("the version of a plotfile");
  readKind(
    [&]
    {
      if (version != "HyperCLaw-V1.1")
      {
        scanner.fail("the version 'HyperCLaw-V1.1'", "'" + version.substr(0, 40) + "'");
      }
    });
  Header header;
  header.components =
    scanner.integer("the number of variables", 1, static_cast<std::int64_t>(scanner.size()));
  for (std::int64_t i = 0; i < header.components; ++i)
  {
    scanner.line("the name of a variable");
  }
  readKind([&] { scanner.integer("the number of dimensions", 3, 3); });
  scanner.number("the time");
  header.levels.resize(static_cast<std::size_t>(
    scanner.integer("the number of the finest level", 0, MostLevels - 1) + 1));
  for (double& corner : header.lower)
  {
    corner = scanner.number("the lower corner of the domain");
  }
  for (double& corner : header.upper)
  {
    corner = scanner.number("the upper corner of the domain");
  }
  std::vector<std::int64_t> ratios;
  for (std::size_t i = 1; i < header.levels.size(); ++i)
  {
    ratios.push_back(scanner.integer("a refinement ratio", 2, 1024));
  }
  for (Level& level : header.levels)
  {
    level.domain = readBox(scanner);
  }
  for (std::size_t i = 0; i < header.levels.size(); ++i)
  {
    scanner.integer("a number of steps", 0, INT64_MAX);
  }
  for (std::size_t i = 0; i < header.levels.size(); ++i)
  {
    Level& level = header.levels[i];
    for (int axis = 0; axis < 3; ++axis)
    {
      level.spacing[axis] = scanner.number("a width of cells");
      const double cells = static_cast<double>(level.domain.hi[axis] - level.domain.lo[axis] + 1);
      const double extent = header.upper[axis] - header.lower[axis];
      if (!(level.spacing[axis] > 0.0) || !near(level.spacing[axis] * cells, extent, extent))
      {
        scanner.fail("cells of level " + std::to_string(i) + " that fill the domain",
          "a width of " + std::to_string(level.spacing[axis]));
      }
      if (i > 0 &&
        !near(level.spacing[axis] * static_cast<double>(ratios[i - 1]),
          header.levels[i - 1].spacing[axis], header.levels[i - 1].spacing[axis]))
      {
        scanner.fail("cells of level " + std::to_string(i) + " by the refinement ratio smaller",
          "a ratio of " + std::to_string(ratios[i - 1]));
      }
    }
  }
  readKind([&] { scanner.integer("the kind of coordinates, Cartesian", 0, 0); });
  scanner.integer("the width of a boundary", 0, 0);
  for (std::size_t i = 0; i < header.levels.size(); ++i)
  {
    Level& level = header.levels[i];
    const auto number = static_cast<std::int64_t>(i);
    scanner.integer("the number of the level", number, number);
    level.grids = static_cast<std::size_t>(
      scanner.integer("the number of boxes", 1, static_cast<std::int64_t>(scanner.size())));
    scanner.number("the level's time");
    scanner.integer("the level's number of steps", 0, INT64_MAX);
    for (std::size_t grid = 0; grid < level.grids; ++grid)
    {
      level.bounds.emplace_back();
      for (double& bound : level.bounds.back())
      {
        bound = scanner.number("a bound of a box");
      }
    }
    level.path = scanner.word("the path of the level's boxes");
    const fs::path path(level.path);
    if (path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end())
    {
      scanner.fail("a path inside the plotfile", "'" + level.path.substr(0, 40) + "'");
    }
  }
  return header;
}

// A box's data in a file of them: a line of text, and the values, component by component.
struct Fab
{
  std::uintmax_t begin = 0;
  std::uintmax_t end = 0;
};

Fab readFab(const fs::path& folder, const std::string& name, std::uintmax_t offset,
  const CellBox& box, std::int64_t components, std::int64_t ghosts)
{
  Bytes file(folder / name);
  const std::uintmax_t size = file.size();
  std::string line = file.read(offset, 400);
  line.resize(std::min(line.find('\n'), line.size()));
  TextScanner scanner("the box at byte " + std::to_string(offset) + " of '" + name + "'", line);
  for (const char expected : { 'F', 'A', 'B', '(', '(' })
  {
    scanner.expect(expected);
  }
  scanner.integer("the parts of a number's description", 8, 8);
  scanner.expect(',');
  scanner.expect('(');
  const std::int64_t bits = scanner.integer("the bits of a number", 32, 64);
  if (bits != 32 && bits != 64)
  {
    scanner.fail("numbers of 32 or 64 bits", std::to_string(bits));
  }
  // Those of IEEE 754.
  const std::array<std::int64_t, 7> format = bits == 64
    ? std::array<std::int64_t, 7>{ 11, 52, 0, 1, 12, 0, 1023 }
    : std::array<std::int64_t, 7>{ 8, 23, 0, 1, 9, 0, 127 };
  for (const std::int64_t part : format)
  {
    scanner.integer("the format of IEEE numbers", part, part);
  }
  scanner.expect(')');
  scanner.expect(')');
  scanner.expect(',');
  scanner.expect('(');
  const std::int64_t bytes = scanner.integer("a number's bytes", bits / 8, bits / 8);
  scanner.expect(',');
  scanner.expect('(');
  const std::int64_t firstPlace = scanner.integer("the first byte's place", 1, bytes);
  if (firstPlace != 1 && firstPlace != bytes)
  {
    scanner.fail("bytes from the first to the last, or back", std::to_string(firstPlace));
  }
  for (std::int64_t i = 1; i < bytes; ++i)
  {
    const std::int64_t place = firstPlace == 1 ? i + 1 : bytes - i;
    scanner.integer("a byte's place", place, place);
  }
  for (int i = 0; i < 3; ++i)
  {
    scanner.expect(')');
  }
  CellBox grown = box;
  for (int axis = 0; axis < 3; ++axis)
  {
    grown.lo[axis] -= ghosts;
    grown.hi[axis] += ghosts;
  }
  if (!(readBox(scanner) == grown))
  {
    scanner.fail("the box that 'Cell_H' says is there", "another one");
  }
  scanner.integer("the number of variables", components, components);
  const std::uintmax_t begin = offset + line.size() + 1;
  // Each factor is below 2^60, 2^31 and 2^4: checked before they are multiplied.
  const double wanted = static_cast<double>(grown.cells()) * static_cast<double>(components) *
    static_cast<double>(bytes);
  if (offset >= size || wanted > static_cast<double>(size) ||
    begin + static_cast<std::uintmax_t>(grown.cells() * components * bytes) > size)
  {
    throw FileFault("expected " + std::to_string(wanted) + " bytes of values from byte " +
      std::to_string(begin) + " of '" + name + "' on, found a file of " + std::to_string(size) +
      " bytes");
  }
  return { offset, begin + static_cast<std::uintmax_t>(grown.cells() * components * bytes) };
}

void checkLevel(const fs::path& folder, const Header& header, std::size_t number)
{
  const Level& level = header.levels[number];
  const fs::path boxes = folder / (level.path + "_H");
  const std::string shown = "'" + level.path + "_H'";
  TextScanner scanner(shown, readText(boxes));
  scanner.integer("the version of the file", 1, 1);
  scanner.integer("how boxes are stored", 1, 1);
  const std::int64_t components =
    scanner.integer("the number of variables", header.components, header.components);
  const std::int64_t ghosts = scanner.integer("a number of ghost cells", 0, 1024);
  scanner.expect('(');
  const auto grids = static_cast<std::int64_t>(level.grids);
  scanner.integer("the number of boxes that 'Header' has", grids, grids);
  scanner.integer("a number without meaning", 0, 0);
  std::vector<CellBox> found;
  for (std::size_t i = 0; i < level.grids; ++i)
  {
    found.push_back(readBox(scanner));
    for (int axis = 0; axis < 3; ++axis)
    {
      const CellBox& box = found.back();
      if (box.lo[axis] < level.domain.lo[axis] || box.hi[axis] > level.domain.hi[axis])
      {
        scanner.fail("a box inside the domain of the level", "one that is not");
      }
      const double width = level.spacing[axis];
      const double origin = header.lower[axis] - width * static_cast<double>(level.domain.lo[axis]);
      if (std::abs(origin + width * static_cast<double>(box.lo[axis]) - level.bounds[i][2 * axis]) >
          0.1 * width ||
        std::abs(origin + width * static_cast<double>(box.hi[axis] + 1) -
          level.bounds[i][2 * axis + 1]) > 0.1 * width)
      {
        scanner.fail("a box where 'Header' has it", "another place");
      }
    }
  }
  scanner.expect(')');
  scanner.integer("the number of boxes", grids, grids);
  std::map<std::string, std::vector<Fab>> files;
  for (const CellBox& box : found)
  {
    const std::string mark = scanner.word("'FabOnDisk:'");
    if (mark != "FabOnDisk:")
    {
      scanner.fail("'FabOnDisk:'", "'" + mark.substr(0, 40) + "'");
    }
    const std::string name = scanner.word("the name of a file of boxes");
    if (name.find('/') != std::string::npos || name.find('\\') != std::string::npos)
    {
      scanner.fail("the name of a file beside this one", "'" + name.substr(0, 40) + "'");
    }
    const auto offset =
      static_cast<std::uintmax_t>(scanner.integer("a place in it", 0, INT64_MAX / 2));
    files[name].push_back(readFab(boxes.parent_path(), name, offset, box, components, ghosts));
  }
  // They lie one behind the other: what is longer or shorter than it ought to be was damaged.
  for (auto& [name, fabs] : files)
  {
    std::sort(
      fabs.begin(), fabs.end(), [](const Fab& a, const Fab& b) { return a.begin < b.begin; });
    std::uintmax_t end = 0;
    const auto expectEnd = [&, file = name](std::uintmax_t found)
    {
      if (found != end)
      {
        throw FileFault("expected a box up to byte " + std::to_string(end) + " of '" + file +
          "', found it to go to byte " + std::to_string(found));
      }
    };
    for (const Fab& fab : fabs)
    {
      expectEnd(fab.begin);
      end = fab.end;
    }
    expectEnd(fs::file_size(boxes.parent_path() / name));
  }
}
}

std::string findPlotfileFault(const fs::path& folder)
{
  try
  {
    const Header header = readHeader(folder);
    for (std::size_t i = 0; i < header.levels.size(); ++i)
    {
      checkLevel(folder, header, i);
    }
    return {};
  }
  catch (const std::exception& fault)
  {
    return fault.what();
  }
}
}
