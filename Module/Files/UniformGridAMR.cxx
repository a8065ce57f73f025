// SPDX-License-Identifier: BSD-3-Clause
#include "Files/UniformGridAMR.h"

#include "Files/TextScanner.h"
#include "Files/VTKFile.h"

#include <algorithm>
#include <cmath>

namespace exabricks
{
namespace
{
namespace fs = std::filesystem;

constexpr std::int64_t MostLevels = 64;
constexpr std::int64_t FarthestCell = std::int64_t(1) << 30; // VTK's indices are 32 bits wide
constexpr std::int64_t MostCells = std::int64_t(1) << 20;    // of a block, along an axis
// VTK sorts the boxes of a level into bins of their average size, all over the level.
constexpr double MostBins = 1 << 28;

struct CellBox
{
  std::array<std::int64_t, 3> lo{ 0, 0, 0 };
  std::array<std::int64_t, 3> hi{ -1, -1, -1 }; // the last cell

  bool empty() const
  {
    return this->hi[0] < this->lo[0] || this->hi[1] < this->lo[1] || this->hi[2] < this->lo[2];
  }
};

struct Block
{
  CellBox box;
  std::string file; // empty: there is none
  const XMLElement* element = nullptr;
};

struct Level
{
  const XMLElement* element = nullptr;
  std::array<double, 3> spacing{};
  std::vector<Block> blocks;
};

std::string triple(const std::vector<double>& v)
{
  return "(" + inDigits(v[0]) + ", " + inDigits(v[1]) + ", " + inDigits(v[2]) + ")";
}

// "1.1"
void checkVersion(const VTKFile& file, std::int64_t leastMajor, std::int64_t leastMinor)
{
  const std::string& version = file.text(file.root(), "version");
  const std::size_t point = std::min(version.find('.'), version.size());
  const auto part = [&](const std::string& text)
  {
    TextScanner scanner(file.name(), text, file.root().line);
    const std::int64_t number = scanner.integer("a version such as 1.1, a number", 0, 999);
    if (!scanner.isAtEnd())
    {
      scanner.fail("a version such as 1.1", inQuotes(version));
    }
    return number;
  };
  const std::int64_t major = part(version.substr(0, point));
  const std::int64_t minor = part(version.substr(std::min(point + 1, version.size())));
  readKind(
    [&]
    {
      if (major > 2 || major < leastMajor || (major == leastMajor && minor < leastMinor))
      {
        file.fail(file.root(),
          "a version from " + std::to_string(leastMajor) + "." + std::to_string(leastMinor) +
            " to 2",
          inQuotes(version));
      }
    });
}

class Checker
{
public:
  explicit Checker(const fs::path& path)
    : Path(path)
    , File(path, "'" + path.filename().string() + "'")
  {
  }

  void check()
  {
    const std::string& type = this->File.text(this->File.root(), "type");
    readKind(
      [&]
      {
        if (type != "vtkOverlappingAMR" && type != "vtkHierarchicalBoxDataSet")
        {
          this->File.fail(this->File.root(),
            "the type 'vtkOverlappingAMR' or 'vtkHierarchicalBoxDataSet'", inQuotes(type));
        }
      });
    checkVersion(this->File, 1, 1);
    const XMLElement& amr = this->File.child(this->File.root(), type);
    this->ReadOrigin(amr);
    this->ReadLevels(amr);
    this->File.checkFieldData(this->File.root());
    this->File.checkFieldData(amr);
    this->File.checkAppendedData();
    for (std::size_t level = 1; level < this->Levels.size(); ++level)
    {
      this->CheckNesting(level);
    }
    for (const Level& level : this->Levels)
    {
      for (const Block& block : level.blocks)
      {
        if (!block.file.empty())
        {
          this->CheckBlock(level, block);
        }
      }
    }
  }

private:
  void ReadOrigin(const XMLElement& amr)
  {
    if (amr.find("origin"))
    {
      this->Origin = this->File.numbers(amr, "origin", 3);
    }
    const std::string* description = amr.find("grid_description");
    readKind(
      [&]
      {
        if (description && *description != "XYZ")
        {
          this->File.fail(
            amr, "the grid_description 'XYZ', a 3-D AMR", "'" + description->substr(0, 40) + "'");
        }
      });
  }

  void ReadLevels(const XMLElement& amr)
  {
    for (const XMLElement& element : amr.children)
    {
      if (element.name == "FieldData")
      {
        continue;
      }
      if (element.name != "Block")
      {
        this->File.fail(element, "an element 'Block'", inQuotes(element.name));
      }
      const auto number = static_cast<std::int64_t>(this->Levels.size());
      this->File.integers(element, "level", 1, number, std::min(number, MostLevels - 1));
      this->Levels.emplace_back();
      this->ReadLevel(element, this->Levels.back());
    }
    if (this->Levels.empty())
    {
      this->File.fail(amr, "an element 'Block' for each level", "none");
    }
  }

  void ReadLevel(const XMLElement& element, Level& level)
  {
    level.element = &element;
    for (const XMLElement& child : element.children)
    {
      this->ReadDataSet(child, level);
    }
    const bool isEmpty = std::all_of(level.blocks.begin(), level.blocks.end(),
      [](const Block& block) { return block.box.empty(); });
    if (isEmpty)
    {
      return; // VTK reads that, if no other level follows
    }
    const std::vector<double> spacing = this->File.numbers(element, "spacing", 3);
    std::copy(spacing.begin(), spacing.end(), level.spacing.begin());
    if (!std::all_of(spacing.begin(), spacing.end(), [](double width) { return width > 0.0; }))
    {
      this->File.fail(element, "a spacing above zero", triple(spacing));
    }
  }

  // Indices go on from 0: a number that is missing would be a block that is lost.
  void ReadDataSet(const XMLElement& element, Level& level)
  {
    if (element.name != "DataSet")
    {
      this->File.fail(element, "an element 'DataSet'", inQuotes(element.name));
    }
    const auto number = static_cast<std::int64_t>(level.blocks.size());
    this->File.integers(element, "index", 1, number, number);
    Block block;
    block.element = &element;
    const std::vector<std::int64_t> numbers =
      this->File.integers(element, "amr_box", 6, -FarthestCell, FarthestCell);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      block.box.lo[axis] = numbers[2 * axis];
      block.box.hi[axis] = numbers[2 * axis + 1];
    }
    if (element.find("file"))
    {
      block.file = this->File.text(element, "file");
    }
    // Blocks of which there is no file are written so.
    else if (element.attributes.size() != 2)
    {
      this->File.fail(element, "a 'file', or 'index' and 'amr_box' alone", "neither");
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::int64_t size = block.box.hi[axis] - block.box.lo[axis] + 1;
      if (size > MostCells || (size < 1 && !block.file.empty()))
      {
        this->File.fail(element, "an amr_box of 1 to 2^20 cells along each axis",
          std::to_string(size) + " along one");
      }
    }
    level.blocks.push_back(std::move(block));
  }

  // A level against the coarser one: VTK looks for the boxes under each box in a table that
  // encloses those boxes.
  void CheckNesting(std::size_t number)
  {
    const Level& fine = this->Levels[number];
    const Level& coarse = this->Levels[number - 1];
    if (fine.blocks.empty())
    {
      return;
    }
    CellBox bounds;
    std::array<double, 3> sizes{};
    for (const Block& block : coarse.blocks)
    {
      for (std::size_t axis = 0; axis < 3 && !block.box.empty(); ++axis)
      {
        const bool isFirst = bounds.hi[axis] < bounds.lo[axis];
        bounds.lo[axis] =
          isFirst ? block.box.lo[axis] : std::min(bounds.lo[axis], block.box.lo[axis]);
        bounds.hi[axis] =
          isFirst ? block.box.hi[axis] : std::max(bounds.hi[axis], block.box.hi[axis]);
        sizes[axis] += static_cast<double>(block.box.hi[axis] - block.box.lo[axis] + 1);
      }
    }
    if (bounds.empty())
    {
      this->File.fail(*coarse.element,
        "a box in level " + std::to_string(number - 1) + ", below a finer level", "none");
    }
    const std::int64_t ratio = this->FindRatio(number);
    double bins = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (std::max(std::abs(bounds.lo[axis]), std::abs(bounds.hi[axis]) + 1) > FarthestCell / ratio)
      {
        this->File.fail(*fine.element, "cells that can be counted with 32 bits",
          "a refinement ratio of " + std::to_string(ratio));
      }
      const double average = sizes[axis] / static_cast<double>(coarse.blocks.size());
      bins *= static_cast<double>(bounds.hi[axis] - bounds.lo[axis]) / average + 1.0;
    }
    if (bins > MostBins)
    {
      this->File.fail(*coarse.element,
        "boxes of level " + std::to_string(number - 1) + " near each other",
        "room for " + inDigits(bins) + " of them between the outermost");
    }
    for (const Block& block : fine.blocks)
    {
      for (std::size_t axis = 0; axis < 3 && !block.box.empty(); ++axis)
      {
        if (block.box.lo[axis] < bounds.lo[axis] * ratio ||
          block.box.hi[axis] >= (bounds.hi[axis] + 1) * ratio)
        {
          this->File.fail(
            *block.element, "a box inside the bounds of the coarser level", "one that is not");
        }
      }
    }
  }

  std::int64_t FindRatio(std::size_t number) const
  {
    const Level& fine = this->Levels[number];
    const Level& coarse = this->Levels[number - 1];
    const double whole = std::round(coarse.spacing[0] / fine.spacing[0]);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double ratio = coarse.spacing[axis] / fine.spacing[axis];
      if (!(std::abs(ratio - whole) <= 1e-3 * whole) || !(whole >= 2.0) || !(whole <= 1024.0))
      {
        this->File.fail(*fine.element,
          "a whole refinement ratio from 2 to 1024, the same along all axes",
          inDigits(ratio) + " along one");
      }
    }
    return static_cast<std::int64_t>(whole);
  }

  void CheckBlock(const Level& level, const Block& block)
  {
    if (fs::path(block.file).extension() != ".vti" || block.file.find('\0') != std::string::npos)
    {
      this->File.fail(*block.element, "the name of a .vti file", inQuotes(block.file));
    }
    VTKFile file(this->Path.parent_path() / block.file, "'" + block.file + "'");
    const std::string& type = file.text(file.root(), "type");
    if (type != "ImageData")
    {
      file.fail(file.root(), "the type 'ImageData'", inQuotes(type));
    }
    checkVersion(file, 0, 1);
    const XMLElement& image = file.child(file.root(), "ImageData");
    const XMLElement& piece = file.child(image, "Piece");
    const auto extent = file.integers(image, "WholeExtent", 6, -FarthestCell, FarthestCell);
    if (file.integers(piece, "Extent", 6, -FarthestCell, FarthestCell) != extent)
    {
      file.fail(piece, "the Extent of all, '" + file.text(image, "WholeExtent").substr(0, 60) + "'",
        inQuotes(file.text(piece, "Extent")));
    }
    const bool hasGhosts = this->HasGhosts(piece);
    std::uint64_t points = 1;
    std::uint64_t cells = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::int64_t size = extent[2 * axis + 1] - extent[2 * axis];
      const std::int64_t wanted = block.box.hi[axis] - block.box.lo[axis] + 1;
      if (size > MostCells || (hasGhosts ? size < wanted : size != wanted))
      {
        file.fail(image, "the " + std::to_string(wanted) + " cells of the amr_box along each axis",
          std::to_string(size) + " along one");
      }
      cells *= static_cast<std::uint64_t>(size);
      points *= static_cast<std::uint64_t>(size) + 1;
    }
    this->CheckPlace(file, image, extent, level, block);
    for (const XMLElement& child : piece.children)
    {
      if (child.name == "PointData" || child.name == "CellData")
      {
        file.child(piece, child.name); // one alone
        file.checkArrays(child, child.name == "CellData" ? cells : points);
      }
    }
    file.checkFieldData(file.root());
    file.checkFieldData(image);
    file.checkAppendedData();
  }

  // A grid that is larger than its box has layers of ghost cells, which are marked.
  bool HasGhosts(const XMLElement& piece) const
  {
    for (const XMLElement& child : piece.children)
    {
      for (const XMLElement& array : child.children)
      {
        const std::string* name = array.find("Name");
        if (child.name == "CellData" && name && *name == "vtkGhostType")
        {
          return true;
        }
      }
    }
    return false;
  }

  void CheckPlace(const VTKFile& file, const XMLElement& image,
    const std::vector<std::int64_t>& extent, const Level& level, const Block& block) const
  {
    const std::vector<double> origin = file.numbers(image, "Origin", 3);
    const std::vector<double> spacing = file.numbers(image, "Spacing", 3);
    if (image.find("Direction") &&
      file.numbers(image, "Direction", 9) != std::vector<double>{ 1, 0, 0, 0, 1, 0, 0, 0, 1 })
    {
      readKind([&]
        { file.fail(image, "a grid along the axes", "'" + file.text(image, "Direction") + "'"); });
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double width = level.spacing[axis];
      // Old versions of VTK wrote six digits.
      if (!(std::abs(spacing[axis] - width) <= 1e-5 * width))
      {
        file.fail(image, "the spacing of the level, " + inDigits(width),
          inDigits(spacing[axis]) + " along one axis");
      }
      const double cells = static_cast<double>(block.box.lo[axis]) +
        (this->Origin[axis] - origin[axis]) / width - static_cast<double>(extent[2 * axis]);
      const double layers = std::round(cells);
      const auto room = static_cast<double>(
        (extent[2 * axis + 1] - extent[2 * axis]) - (block.box.hi[axis] - block.box.lo[axis] + 1));
      if (!(std::abs(cells - layers) < 0.1) || !(layers >= 0.0) || !(layers <= room))
      {
        file.fail(image, "an origin where the amr_box is", triple(origin));
      }
    }
  }

  const fs::path Path;
  VTKFile File;
  std::vector<double> Origin{ 0.0, 0.0, 0.0 };
  std::vector<Level> Levels;
};
}

std::string findUniformGridAMRFault(const fs::path& path)
{
  try
  {
    Checker(path).check();
    return {};
  }
  catch (const std::exception& fault)
  {
    return fault.what();
  }
}
}
