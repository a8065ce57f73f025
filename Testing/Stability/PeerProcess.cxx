// SPDX-License-Identifier: BSD-3-Clause
#include "PeerProcess.h"

#include "Measure.h"

#include "Benchmarks/PeerMappers.h"
#include "Benchmarks/WindowImage.h"
#include "Reference/Scenes.h"

#include "Display.h" // of Examples/Render

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <chrono>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace exabricks
{
namespace stability
{
namespace
{
constexpr int ResampledCells = 128; // along each axis, as vtkAMRVolumeMapper does
constexpr std::chrono::seconds TimeLimit(60);
constexpr rlim_t MemoryLimit = rlim_t(12) << 30; // bytes: a runaway must not take the machine along

vtkSmartPointer<vtkVolumeMapper> makeMapper(const std::string& peer, const Setting& setting)
{
  const Hierarchy& hierarchy = setting.hierarchy;
  const Box bounds = reference::boundsOf(hierarchy);
  const glm::dvec3& spacing = hierarchy.spacing;
  const benchmarks::PeerData data{ setting.amr, "value", -1,
    hierarchy.origin + spacing * glm::dvec3(bounds.lo),
    hierarchy.origin + spacing * glm::dvec3(bounds.hi),
    setting.scale * std::min({ spacing.x, spacing.y, spacing.z }) };
  return peer == "multiblock" ? benchmarks::makeMultiBlockMapper(data, true)
    : peer == "resampled"     ? benchmarks::makeResampledMapper(data, ResampledCells)
                              : benchmarks::makeAMRMapper(data);
}

[[noreturn]] void becomePeer(const std::vector<std::string>& command, const std::string& log)
{
  const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
  dup2(out, STDOUT_FILENO);
  dup2(out, STDERR_FILENO);
  const rlimit memory{ MemoryLimit, MemoryLimit };
  setrlimit(RLIMIT_AS, &memory);
  const rlimit noCore{ 0, 0 };
  setrlimit(RLIMIT_CORE, &noCore);
  std::vector<char*> words;
  for (const std::string& word : command)
  {
    words.push_back(const_cast<char*>(word.c_str()));
  }
  words.push_back(nullptr);
  execv(words[0], words.data());
  _exit(127);
}

// "" for an end without fault.
std::string awaitEnd(pid_t child)
{
  const auto end = std::chrono::steady_clock::now() + TimeLimit;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0)
  {
    if (std::chrono::steady_clock::now() > end)
    {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      return "timeout";
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return WIFSIGNALED(status) ? "crash" : WEXITSTATUS(status) != 0 ? "error" : "";
}
}

std::vector<Peer> listPeers()
{
  std::vector<Peer> peers{ { "multiblock", "VTK MultiBlock" }, { "resampled", "VTK resampled" } };
#ifdef EXABRICKS_VTK_HAS_AMR_MAPPER
  peers.push_back({ "amr", "vtkAMRVolumeMapper" });
#endif
  return peers;
}

PeerResult runPeer(
  const std::string& self, const Peer& peer, const std::string& caseName, const std::string& folder)
{
  const std::string file = folder + "/peer.bytes";
  const std::string log = folder + "/peers.log";
  std::remove(file.c_str());
  std::ofstream(log, std::ios::app) << "== " << caseName << ", " << peer.header << "\n";
  const std::vector<std::string> command{ self, "--peer", peer.name, caseName, file };
  const pid_t child = fork();
  if (child == 0)
  {
    becomePeer(command, log);
  }
  PeerResult result;
  result.failure = child < 0 ? "error" : awaitEnd(child);
  if (!result.failure.empty())
  {
    return result;
  }
  std::ifstream in(file, std::ios::binary);
  in.read(reinterpret_cast<char*>(&result.picture.width), sizeof(int));
  in.read(reinterpret_cast<char*>(&result.picture.height), sizeof(int));
  result.picture.pixels.resize(
    in ? static_cast<std::size_t>(result.picture.width) * result.picture.height : 0);
  in.read(reinterpret_cast<char*>(result.picture.pixels.data()),
    static_cast<std::streamsize>(result.picture.pixels.size() * sizeof(glm::dvec4)));
  if (!in)
  {
    result.failure = "error";
  }
  std::remove(file.c_str());
  return result;
}

void drawAsPeer(const std::string& peer, const Setting& setting, const std::string& file)
{
  vtkNew<vtkVolumeProperty> property;
  setProperty(setting, property);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(makeMapper(peer, setting));
  volume->SetProperty(property);
  setMatrix(setting, volume);
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  renderer->SetBackground(0.0, 0.0, 0.0);
  setCamera(setting, renderer->GetActiveCamera());
  auto window = render::makeWindow();
  window->AddRenderer(renderer);
  window->SetDesiredUpdateRate(0.0001); // never coarser for the sake of speed
  window->SetSize(setting.width, setting.height);
  window->Render();
  window->WaitForCompletion();
  const reference::Image picture = benchmarks::readWindow(window);
  if (picture.width != setting.width || picture.height != setting.height)
  {
    throw std::runtime_error("the window has another size");
  }
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(&picture.width), sizeof(int));
  out.write(reinterpret_cast<const char*>(&picture.height), sizeof(int));
  out.write(reinterpret_cast<const char*>(picture.pixels.data()),
    static_cast<std::streamsize>(picture.pixels.size() * sizeof(glm::dvec4)));
  out.close();
  _exit(out ? 0 : 1); // before VTK takes its objects down: that they can be drawn is what counts
}
}
}
