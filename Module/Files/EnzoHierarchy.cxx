// SPDX-License-Identifier: BSD-3-Clause
#include "Files/EnzoHierarchy.h"

#include "Files/HDF5File.h"
#include "Files/TextScanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>

namespace exabricks
{
namespace
{
namespace fs = std::filesystem;

constexpr std::int64_t MostCells = std::int64_t(1) << 20; // of a grid, along an axis
constexpr std::int64_t MostFields = 1000;
constexpr std::int64_t NotSaid = -1;

using Triple = std::array<double, 3>;

struct Grid
{
  std::array<std::int64_t, 3> cells{};
  Triple left{};
  Triple right{};
  std::size_t level = 0;
  std::size_t parent = 0; // 0: none
  std::int64_t fields = 0;
  std::string file;
  std::int64_t nextThisLevel = NotSaid;
  std::int64_t nextNextLevel = NotSaid;

  double width(std::size_t axis) const
  {
    return (this->right[axis] - this->left[axis]) / static_cast<double>(this->cells[axis]);
  }
};

struct Parameters
{
  std::array<std::int64_t, 3> cells{}; // of level 0
  Triple left{};
  Triple right{};
  std::int64_t ratio = 0;
  std::set<std::int64_t> labelled; // numbers of fields that have a name
  std::set<std::string> labels;
};

bool isWhole(double number) { return std::abs(number - std::round(number)) < 0.1; }

[[noreturn]] void fail(std::size_t grid, const std::string& expected, const std::string& found)
{
  throw FileFault(
    "expected grid " + std::to_string(grid) + " to have " + expected + ", found " + found);
}

// ---------------------------------------------------------------------------------------------
// The parameters

Triple readTriple(TextScanner& scanner, const std::string& what)
{
  Triple numbers{};
  for (double& number : numbers)
  {
    number = scanner.number(what);
  }
  return numbers;
}

// A word of its own: the reader takes the next word for it, whatever it is.
void expectEquals(TextScanner& scanner)
{
  const std::string word = scanner.word("'='");
  if (word != "=")
  {
    scanner.fail("'=' between blanks", inQuotes(word));
  }
}

// "DataLabel[0] = Density": the number in brackets.
std::int64_t readFieldNumber(TextScanner& scanner)
{
  scanner.expect('[');
  const std::int64_t number = scanner.integer("the number of a field", 0, MostFields);
  scanner.expect(']');
  expectEquals(scanner);
  return number;
}

Parameters readParameters(const fs::path& path)
{
  Parameters parameters;
  const std::string shown = "'" + path.filename().string() + "'";
  std::set<std::string> missing{ "TopGridRank", "TopGridDimensions", "DomainLeftEdge",
    "DomainRightEdge", "RefineBy" };
  std::istringstream text(readText(path));
  std::string line;
  for (std::size_t number = 1; std::getline(text, line); ++number)
  {
    const std::string key = line.substr(0, std::min(line.find_first_of(" \t=["), line.size()));
    TextScanner scanner(shown, line.substr(key.size()), number);
    if (key == "DataLabel")
    {
      if (!parameters.labelled.insert(readFieldNumber(scanner)).second)
      {
        scanner.fail("another number of a field", "one that has a name already");
      }
      parameters.labels.insert(scanner.line("the name of a field"));
    }
    else if (key == "#DataCGSConversionFactor")
    {
      readFieldNumber(scanner);
      if (!(scanner.number("a factor") > 0.0))
      {
        scanner.fail("a factor above zero", "another");
      }
      scanner.endLine();
    }
    else if (missing.erase(key) > 0)
    {
      expectEquals(scanner);
      if (key == "TopGridRank")
      {
        readKind([&] { scanner.integer("the number of dimensions (TopGridRank)", 3, 3); });
      }
      else if (key == "TopGridDimensions")
      {
        for (std::int64_t& cells : parameters.cells)
        {
          cells = scanner.integer("a number of cells (TopGridDimensions)", 1, MostCells);
        }
      }
      else if (key == "RefineBy")
      {
        parameters.ratio = scanner.integer("a refinement ratio (RefineBy)", 2, 1024);
      }
      else
      {
        (key == "DomainLeftEdge" ? parameters.left : parameters.right) = readTriple(scanner, key);
      }
      scanner.endLine();
    }
    else if (key == "InitialCycleNumber" || key == "InitialTime") // the reader stops at others
    {
      expectEquals(scanner);
      if (key == "InitialTime")
      {
        scanner.number("a time (InitialTime)");
      }
      else
      {
        scanner.integer("a number of a cycle", INT32_MIN, INT32_MAX);
      }
      scanner.endLine();
    }
    else if (key == "TopGridRank")
    {
      scanner.fail("one '" + key + "'", "a second one");
    }
  }
  if (!missing.empty())
  {
    throw FileFault("expected '" + *missing.begin() + " = ' in " + shown + ", found none");
  }
  return parameters;
}

// ---------------------------------------------------------------------------------------------
// The hierarchy

class HierarchyReader
{
public:
  explicit HierarchyReader(const fs::path& path)
    : Scanner("'" + path.filename().string() + "'", readText(path))
  {
  }

  std::vector<Grid> read()
  {
    while (!this->Scanner.isAtEnd())
    {
      const std::string key = this->Scanner.word("'Grid = '");
      if (key == "Pointer:")
      {
        this->ReadPointer();
      }
      else if (key == "Grid")
      {
        this->ReadGrid();
      }
      else if (key == "Time")
      {
        expectEquals(this->Scanner);
        this->Scanner.number("a time");
        this->Scanner.endLine();
      }
      else if (!this->Grids.empty() && this->Scanner.isNext('='))
      {
        this->Scanner.skipLine(); // what newer versions of Enzo may say of a grid
      }
      else
      {
        this->Scanner.fail("'Grid = ' or 'Pointer: '", inQuotes(key));
      }
    }
    if (this->Grids.empty())
    {
      this->Scanner.fail("a grid", "none");
    }
    this->CheckPointers();
    return std::move(this->Grids);
  }

private:
  // The reader looks for keys in this order, and passes those between them.
  void SkipTo(const std::string& wanted)
  {
    static const std::set<std::string> known{ "Grid", "GridRank", "GridDimension", "GridStartIndex",
      "GridEndIndex", "GridLeftEdge", "GridRightEdge", "NumberOfBaryonFields", "BaryonFileName",
      "NumberOfParticles", "ParticleFileName", "Pointer:" };
    while (true)
    {
      const std::string key = this->Scanner.word("'" + wanted + " = '");
      if ((key != wanted && known.count(key) > 0) || !this->Scanner.isNext('='))
      {
        this->Scanner.fail("'" + wanted + " = '", inQuotes(key));
      }
      expectEquals(this->Scanner);
      if (key == wanted)
      {
        return;
      }
      this->Scanner.skipLine();
    }
  }

  std::array<std::int64_t, 3> ReadNumbers(const std::string& key)
  {
    this->SkipTo(key);
    std::array<std::int64_t, 3> numbers{};
    for (std::int64_t& number : numbers)
    {
      number = this->Scanner.integer("a number of cells (" + key + ")", 0, MostCells);
    }
    this->Scanner.endLine();
    return numbers;
  }

  void ReadGrid()
  {
    const auto number = static_cast<std::int64_t>(this->Grids.size()) + 1;
    expectEquals(this->Scanner);
    this->Scanner.integer("the number of the next grid", number, number);
    Grid grid;
    grid.level = this->Level;
    grid.parent = this->Parent;
    this->SkipTo("GridRank");
    readKind([&] { this->Scanner.integer("the number of dimensions (GridRank)", 3, 3); });
    const std::array<std::int64_t, 3> dimensions = this->ReadNumbers("GridDimension");
    const std::array<std::int64_t, 3> start = this->ReadNumbers("GridStartIndex");
    const std::array<std::int64_t, 3> end = this->ReadNumbers("GridEndIndex");
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      grid.cells[axis] = end[axis] - start[axis] + 1;
      if (grid.cells[axis] < 1 || dimensions[axis] != start[axis] + end[axis] + 1)
      {
        this->Scanner.fail("as many ghost cells on both sides of the grid's cells",
          "cells from " + std::to_string(start[axis]) + " to " + std::to_string(end[axis]) +
            " of " + std::to_string(dimensions[axis]) + " along an axis");
      }
    }
    this->SkipTo("GridLeftEdge");
    grid.left = readTriple(this->Scanner, "an edge of the grid");
    this->Scanner.endLine();
    this->SkipTo("GridRightEdge");
    grid.right = readTriple(this->Scanner, "an edge of the grid");
    this->Scanner.endLine();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (!(grid.width(axis) > 0.0) || !std::isfinite(grid.width(axis)))
      {
        this->Scanner.fail("a right edge beyond the left one",
          inDigits(grid.right[axis]) + " after " + inDigits(grid.left[axis]));
      }
    }
    this->SkipTo("NumberOfBaryonFields");
    // Without, no file is named, and the reader takes the next grid's.
    readKind(
      [&] { grid.fields = this->Scanner.integer("a number of baryon fields", 1, MostFields); });
    this->SkipTo("BaryonFileName");
    grid.file = this->Scanner.word("the name of a file");
    this->Scanner.endLine();
    this->SkipTo("NumberOfParticles");
    if (this->Scanner.integer("a number of particles", 0, INT32_MAX) > 0)
    {
      this->SkipTo("ParticleFileName");
      this->Scanner.word("the name of a file");
    }
    this->Scanner.endLine();
    this->Grids.push_back(std::move(grid));
  }

  // "Pointer: Grid[1]->NextGridThisLevel = 2"
  void ReadPointer()
  {
    for (const char character : { 'G', 'r', 'i', 'd', '[' })
    {
      this->Scanner.expect(character);
    }
    const auto count = static_cast<std::int64_t>(this->Grids.size());
    const auto number =
      static_cast<std::size_t>(this->Scanner.integer("the number of a grid before", 1, count));
    Grid& grid = this->Grids[number - 1];
    const std::string name = this->Scanner.word("']->NextGridThisLevel'");
    if (name != "]->NextGridThisLevel" && name != "]->NextGridNextLevel")
    {
      this->Scanner.fail("']->NextGridThisLevel' or ']->NextGridNextLevel'", inQuotes(name));
    }
    const bool isThisLevel = name == "]->NextGridThisLevel";
    std::int64_t& next = isThisLevel ? grid.nextThisLevel : grid.nextNextLevel;
    if (next != NotSaid)
    {
      this->Scanner.fail("one next grid of this level, and one of the next", "a second one");
    }
    expectEquals(this->Scanner);
    next = this->Scanner.integer("the number of a grid behind, or none,", 0, INT32_MAX);
    this->Scanner.endLine();
    if (!isThisLevel && next != 0)
    {
      this->Level = grid.level + 1;
      this->Parent = number;
    }
  }

  // The reader gives grids the level of the last pointer to a next one: they have to be listed
  // where that is the level which pointers lead to.
  void CheckPointers() const
  {
    const auto count = static_cast<std::int64_t>(this->Grids.size());
    std::vector<bool> isReached(this->Grids.size(), false);
    for (std::size_t i = 0; i < this->Grids.size(); ++i)
    {
      const Grid& grid = this->Grids[i];
      for (const bool isThisLevel : { true, false })
      {
        const std::int64_t next = isThisLevel ? grid.nextThisLevel : grid.nextNextLevel;
        if (next == NotSaid)
        {
          fail(i + 1, "pointers to the next grid of this level and of the next one", "none");
        }
        if (next == 0)
        {
          continue;
        }
        if (next > count || next <= static_cast<std::int64_t>(i) + 1 ||
          isReached[static_cast<std::size_t>(next - 1)])
        {
          fail(i + 1, "a pointer to a grid behind it that no other one points to",
            "one to grid " + std::to_string(next) + " of " + std::to_string(count));
        }
        isReached[static_cast<std::size_t>(next - 1)] = true;
        const Grid& other = this->Grids[static_cast<std::size_t>(next - 1)];
        if (other.level != grid.level + (isThisLevel ? 0 : 1) ||
          other.parent != (isThisLevel ? grid.parent : i + 1))
        {
          fail(i + 1, "a pointer to a grid of that level", "one to grid " + std::to_string(next));
        }
      }
    }
    const auto lost = std::find(isReached.begin() + 1, isReached.end(), false);
    if (lost != isReached.end())
    {
      fail(static_cast<std::size_t>(lost - isReached.begin()) + 1, "a pointer to it", "none");
    }
  }

  TextScanner Scanner;
  std::vector<Grid> Grids;
  std::size_t Level = 0;
  std::size_t Parent = 0;
};

// ---------------------------------------------------------------------------------------------
// Both, and the HDF5 files

// Level 0 fills the domain; finer grids lie inside cells of their parent, which they divide.
void checkPlaces(const std::vector<Grid>& grids, const Parameters& parameters)
{
  double cells = 0.0;
  for (std::size_t i = 0; i < grids.size(); ++i)
  {
    const Grid& grid = grids[i];
    const Grid* parent = grid.parent > 0 ? &grids[grid.parent - 1] : nullptr;
    double product = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double left = parent ? parent->left[axis] : parameters.left[axis];
      const double right = parent ? parent->right[axis] : parameters.right[axis];
      const double width =
        parent ? parent->width(axis) : (right - left) / static_cast<double>(parameters.cells[axis]);
      const double ratio = parent ? static_cast<double>(parameters.ratio) : 1.0;
      if (!(width > 0.0) || !(std::abs(width / grid.width(axis) - ratio) <= 1e-3 * ratio))
      {
        fail(i + 1, "cells of width " + inDigits(width / ratio), inDigits(grid.width(axis)));
      }
      const double first = (grid.left[axis] - left) / width;
      const double last = (grid.right[axis] - left) / width;
      if (!isWhole(first) || !isWhole(last) || first < -0.1 ||
        last > std::round((right - left) / width) + 0.1)
      {
        fail(i + 1,
          "edges on whole cells of " +
            (parent ? "grid " + std::to_string(grid.parent) : std::string("the domain")),
          "them after " + inDigits(first) + " and " + inDigits(last) + " cells along an axis");
      }
      product *= static_cast<double>(grid.cells[axis]);
    }
    cells += parent ? 0.0 : product;
  }
  const double wanted = static_cast<double>(parameters.cells[0]) *
    static_cast<double>(parameters.cells[1]) * static_cast<double>(parameters.cells[2]);
  if (cells != wanted)
  {
    throw FileFault("expected grids of level 0 with " + inDigits(wanted) +
      " cells (TopGridDimensions), found " + inDigits(cells));
  }
}

// The names of a grid's data sets that have a value for each cell; none, if any is not of a kind
// that is read. Some have other shapes: particles, and what lies on the faces of cells.
std::set<std::string> checkFields(HDF5File& file, const HDF5File::Object& group, const Grid& grid,
  std::size_t number, const std::set<std::string>& labels)
{
  std::set<std::string> names;
  bool areKnown = true;
  for (const auto& [name, place] : file.readMembers(group))
  {
    const HDF5File::Object object = file.readObject(place);
    areKnown = areKnown && object.isKnown;
    if (!object.isKnown || object.isGroup || object.shape.size() != 3)
    {
      continue;
    }
    const bool isField = labels.count(name) > 0;
    bool hasShape = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::uint64_t found = object.shape[2 - axis];
      hasShape = hasShape && found == static_cast<std::uint64_t>(grid.cells[axis]);
      if (isField && !hasShape)
      {
        fail(number, std::to_string(grid.cells[axis]) + " values of '" + name + "' along an axis",
          std::to_string(found));
      }
    }
    const bool isFloat = object.valueClass == 1;
    if (isField &&
      ((!isFloat && object.valueClass != 0) || object.valueBytes > 8 ||
        (isFloat && object.valueBytes < 4)))
    {
      fail(number, "numbers of up to 8 bytes in '" + name + "'", "another type");
    }
    if (hasShape)
    {
      names.insert(name);
    }
  }
  if (areKnown && names.size() < static_cast<std::size_t>(grid.fields))
  {
    fail(number, std::to_string(grid.fields) + " data sets with its cells",
      std::to_string(names.size()));
  }
  return areKnown ? names : std::set<std::string>();
}

// Grids are groups of a file, or each file is one grid.
void checkFile(const fs::path& path, const std::vector<Grid>& grids,
  const std::vector<std::size_t>& numbers, const std::set<std::string>& labels,
  std::vector<std::set<std::string>>& fields)
{
  HDF5File file(path, "'" + path.filename().string() + "'");
  const HDF5File::Object root = file.root() > 0 ? file.readObject(file.root()) : HDF5File::Object();
  if (!root.isGroup)
  {
    return; // of a newer kind
  }
  std::map<std::int64_t, std::uint64_t> groups;
  for (const auto& [name, place] : file.readMembers(root))
  {
    if (name.compare(0, 4, "Grid") == 0 && name.size() > 4 && name.size() < 20 &&
      name.find_first_not_of("0123456789", 4) == std::string::npos)
    {
      groups[std::stoll(name.substr(4))] = place;
    }
  }
  for (const std::size_t number : numbers)
  {
    const auto group = groups.find(static_cast<std::int64_t>(number));
    if (groups.empty() ? numbers.size() > 1 : group == groups.end())
    {
      fail(number, "a group in '" + path.filename().string() + "'", "none");
    }
    const HDF5File::Object object = groups.empty() ? root : file.readObject(group->second);
    if (object.isGroup)
    {
      fields[number - 1] = checkFields(file, object, grids[number - 1], number, labels);
    }
  }
}

void checkFiles(
  const fs::path& folder, const std::vector<Grid>& grids, const Parameters& parameters)
{
  std::map<std::string, std::vector<std::size_t>> files; // the reader leaves their folders out
  for (std::size_t i = 0; i < grids.size(); ++i)
  {
    const std::string& file = grids[i].file;
    const std::size_t slash = file.rfind('/');
    files[slash == std::string::npos ? file : file.substr(slash + 1)].push_back(i + 1);
    if (grids[i].fields > static_cast<std::int64_t>(parameters.labelled.size()))
    {
      fail(i + 1, "a 'DataLabel' for each of its " + std::to_string(grids[i].fields) + " fields",
        std::to_string(parameters.labelled.size()));
    }
  }
  std::vector<std::set<std::string>> fields(grids.size());
  for (const auto& [name, numbers] : files)
  {
    checkFile(folder / name, grids, numbers, parameters.labels, fields);
  }
  // What one grid has and another has not, the reader crashes on, if it has a factor.
  for (const std::string& label : parameters.labels)
  {
    const auto has = [&](const std::set<std::string>& names) { return names.count(label) > 0; };
    const auto without = std::find_if(fields.begin(), fields.end(),
      [&](const std::set<std::string>& names) { return !names.empty() && !has(names); });
    if (without != fields.end() && std::any_of(fields.begin(), fields.end(), has))
    {
      fail(static_cast<std::size_t>(without - fields.begin()) + 1,
        "a data set '" + label + "', as other grids do", "none");
    }
  }
}
}

std::string findEnzoFault(const fs::path& hierarchy)
{
  try
  {
    const Parameters parameters = readParameters(fs::path(hierarchy).replace_extension());
    const std::vector<Grid> grids = HierarchyReader(hierarchy).read();
    checkPlaces(grids, parameters);
    checkFiles(hierarchy.parent_path(), grids, parameters);
    return {};
  }
  catch (const std::exception& fault)
  {
    return fault.what();
  }
}
}
