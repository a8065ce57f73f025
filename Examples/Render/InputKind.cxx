// SPDX-License-Identifier: BSD-3-Clause

#include "InputKind.h"

#include "Failure.h"

#include <filesystem>
#include <fstream>

namespace render
{

namespace
{

namespace fs = std::filesystem;

[[noreturn]] void Refuse(const std::string& message)
{
  throw Failure(ExitCode::InputUnreadable, message);
}

// Of a folder that is no plotfile: what it may hold in its place.
std::string adviseFor(const std::string& folder)
{
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
  {
    const std::string ending = entry.path().extension().string();
    if (ending == ".hierarchy" || ending == ".vthb" || ending == ".vth")
    {
      return " Did you mean '" + entry.path().string() + "'?";
    }
  }
  return " Give the folder of an AMReX plotfile, such as plt00216.";
}

// An AMReX plotfile is a folder; its file Header begins with a line such as HyperCLaw-V1.1.
void checkPlotfile(const std::string& folder)
{
  const std::string advice = adviseFor(folder);
  std::ifstream header(fs::path(folder) / "Header");
  if (!header)
  {
    Refuse("The folder '" + folder + "' holds no readable file named Header." + advice);
  }
  std::string version;
  int arrays = 0;
  if (!std::getline(header, version) || version.find("-V") == std::string::npos ||
    !(header >> arrays) || arrays < 1)
  {
    Refuse("The file Header in '" + folder +
      "' is not that of a plotfile: it should begin with a " +
      "version, such as HyperCLaw-V1.1, and the number of arrays." + advice);
  }
}

void checkHDF(const std::string& path)
{
  char signature[8] = {};
  std::ifstream(path, std::ios::binary).read(signature, sizeof(signature));
  if (std::string(signature, sizeof(signature)) != "\x89HDF\r\n\x1a\n")
  {
    Refuse("'" + path + "' is not an HDF5 file: check that it was copied whole.");
  }
}

// Enzo: grids are listed in NAME.hierarchy, parameters are in NAME beside it.
void checkHierarchy(const std::string& path)
{
  std::ifstream file(path);
  std::string word;
  if (!(file >> word) || word != "Grid")
  {
    Refuse("'" + path + "' is not an Enzo hierarchy: it should begin with 'Grid = 1'.");
  }
  const fs::path parameters = fs::path(path).replace_extension();
  if (!std::ifstream(parameters))
  {
    Refuse("There is no readable file '" + parameters.string() +
      "', which holds the parameters of this Enzo data set: copy it there.");
  }
}

}

InputKind findInputKind(const std::string& path)
{
  std::error_code ignored;
  if (!fs::exists(path, ignored))
  {
    Refuse("There is no file or folder '" + path + "': check the path.");
  }
  if (fs::is_directory(path, ignored))
  {
    checkPlotfile(path);
    return InputKind::AMReX;
  }
  if (!std::ifstream(path))
  {
    Refuse("The file '" + path + "' may not be read: check its permissions.");
  }
  const std::string ending = fs::path(path).extension().string();
  if (ending == ".vthb" || ending == ".vth")
  {
    return InputKind::XML;
  }
  if (ending == ".hierarchy")
  {
    checkHierarchy(path);
    return InputKind::Enzo;
  }
  if (ending == ".hdf5" || ending == ".vtkhdf")
  {
    checkHDF(path);
    return ending == ".hdf5" ? InputKind::Flash : InputKind::VTKHDF;
  }
  Refuse("'" + path +
    "' is of no known kind. Expected a .vthb, .vth, .hierarchy, .hdf5 or .vtkhdf file, or the "
    "folder of an AMReX plotfile.");
}

}
