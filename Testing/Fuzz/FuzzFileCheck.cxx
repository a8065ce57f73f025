// SPDX-License-Identifier: BSD-3-Clause
// The checks of files under libFuzzer: whatever is in the files, they end, and soon. An input is a
// letter for the kind of data set, and its files one behind the other, with a line between them.
// Utilities/fuzz checks builds and runs it; FuzzCorpus.py makes inputs to begin with.
#include "Files/EnzoHierarchy.h"
#include "Files/Plotfile.h"
#include "Files/UniformGridAMR.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace
{
namespace fs = std::filesystem;

const std::string Separator = "\n=====\n";

struct Kind
{
  std::vector<std::string> files;
  std::string (*findFault)(const fs::path&);
  std::string path; // what a user would open
};

const Kind& kindOf(char letter)
{
  static const Kind plotfile{ { "Header", "Level_0/Cell_H", "Level_0/Cell_D_00000",
                                "Level_1/Cell_H", "Level_1/Cell_D_00000" },
    exabricks::findPlotfileFault, "" };
  static const Kind enzo{ { "data0003.hierarchy", "data0003", "data0003.cpu0000",
                            "data0003.cpu0001" },
    exabricks::findEnzoFault, "data0003.hierarchy" };
  static const Kind vthb{ { "data.vthb", "data/data_0.vti", "data/data_1.vti", "data/data_2.vti" },
    exabricks::findUniformGridAMRFault, "data.vthb" };
  return letter == 'p' ? plotfile : letter == 'e' ? enzo : vthb;
}

struct Folder
{
  Folder()
  {
    std::string name = (fs::temp_directory_path() / "fuzz-XXXXXX").string();
    this->path = mkdtemp(name.data());
    for (const char* part : { "Level_0", "Level_1", "data" })
    {
      fs::create_directory(this->path / part);
    }
  }
  ~Folder() { fs::remove_all(this->path); }

  fs::path path;
};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const Folder folder;
  const std::string input(reinterpret_cast<const char*>(data), size);
  const Kind& kind = kindOf(input.empty() ? '\0' : input[0]);
  std::size_t begin = input.empty() ? 0 : 1;
  for (const std::string& file : kind.files)
  {
    const std::size_t end = std::min(input.find(Separator, begin), input.size());
    std::ofstream(folder.path / file, std::ios::binary)
      .write(input.data() + begin, static_cast<std::streamsize>(end - begin));
    begin = std::min(end + Separator.size(), input.size());
  }
  kind.findFault(folder.path / kind.path);
  return 0;
}
