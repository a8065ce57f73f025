// SPDX-License-Identifier: BSD-3-Clause
#include "Machine.h"

#include "Vulkan/VolumeRenderer.h"

#include "vtkVersion.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace exabricks
{
namespace benchmarks
{
namespace
{
// What follows "<name> :" in a file of Linux's; empty elsewhere.
std::string lookUp(const char* file, const std::string& name)
{
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line))
  {
    const std::size_t colon = line.find(':');
    if (colon != std::string::npos && line.compare(0, name.size(), name) == 0)
    {
      const std::size_t begin = line.find_first_not_of(" \t", colon + 1);
      return begin == std::string::npos ? std::string() : line.substr(begin);
    }
  }
  return {};
}

double kibibytes(const std::string& name)
{
  return std::atof(lookUp("/proc/meminfo", name).c_str());
}
}

double loadAverage()
{
  double average = -1.0;
#ifndef _WIN32
  getloadavg(&average, 1);
#endif
  return average;
}

double availableMemory() { return 1024.0 * kibibytes("MemAvailable"); }

std::vector<std::pair<std::string, std::string>> describeMachine()
{
  std::vector<std::pair<std::string, std::string>> lines;
  const std::string model = lookUp("/proc/cpuinfo", "model name");
  lines.emplace_back("processor", model.empty() ? "unknown" : model);
  lines.emplace_back("processors", std::to_string(std::thread::hardware_concurrency()));
  char memory[32];
  std::snprintf(memory, sizeof memory, "%.1f GiB", kibibytes("MemTotal") / 1048576.0);
  lines.emplace_back("memory", memory);
  lines.emplace_back("VTK", vtkVersion::GetVTKVersion());
  for (const std::string& device : VolumeRenderer::listDevices())
  {
    lines.emplace_back("Vulkan device", device);
  }
  return lines;
}
}
}
