// SPDX-License-Identifier: BSD-3-Clause
#include "SceneTable.h"

#include <filesystem>

namespace exabricks
{
namespace benchmarks
{
std::vector<SceneKind> listScenes(const std::vector<std::string>& folders, const InputScene& input,
  std::vector<std::string>& missing)
{
  std::vector<SceneKind> scenes;
  const auto append = [&](const std::vector<SceneKind>& group)
  { scenes.insert(scenes.end(), group.begin(), group.end()); };
  append(listMadeScenes());
  append(listStandInScenes());
  append(listDataScenes(folders, missing));
  append(listFieldScenes());
  if (!input.draw.Input.empty())
  {
    const std::filesystem::path path(input.draw.Input);
    const std::string name =
      path.filename().empty() ? path.parent_path().filename().string() : path.filename().string();
    scenes.push_back(
      { name, "input", false, false, [=](double) { return makeDataModel(name, input); } });
  }
  return scenes;
}
}
}
