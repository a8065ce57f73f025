// SPDX-License-Identifier: BSD-3-Clause
// Draws every case of stability with ours and with what VTK has, and writes how far each picture is
// from what it ought to be: stability.csv, and what the peers said to peers.log.
//
//   xvfb-run -a StabilityTable <folder> [<case>...]
//
// Numbers are PSNR in dB over the pixels that something is drawn in. Ours: red, green, blue,
// opacity in float. Those of VTK: red, green, blue of a window, 8 bits, against the oracle of the
// better fitting reconstruction, so that about 59 is as good as it gets.
#include "Measure.h"
#include "PeerProcess.h"

#include "Cxx/Stage.h"

#include <cstdio>
#include <fstream>
#include <iostream>
#include <set>

namespace
{
using namespace exabricks;
using namespace exabricks::stability;

struct Row
{
  std::string theme;
  const Case* test;
  std::vector<std::string> ours; // basis k-d, basis ray query, nearest k-d, nearest ray query
  std::vector<double> greatest;  // difference, of the same
  std::vector<std::string> peers;
};

std::string decibel(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return std::isinf(value) && value > 0.0 ? "equal" : text;
}

bool isBlack(const reference::Image& image)
{
  for (const glm::dvec4& pixel : image.pixels)
  {
    if (pixel.r > 0.0 || pixel.g > 0.0 || pixel.b > 0.0)
    {
      return false;
    }
  }
  return true;
}

std::string judgePeer(const PeerResult& result, const std::vector<reference::Image> truths[2])
{
  if (!result.failure.empty())
  {
    return result.failure;
  }
  const Errors basis = compare(result.picture, truths[0], 3);
  const Errors nearest = compare(result.picture, truths[1], 3);
  const bool nothing = isBlack(result.picture) && basis.coverage > 0.0;
  return nothing ? "nothing drawn" : decibel(std::max(basis.drawn, nearest.drawn));
}

Row measure(Renderers& renderers, const std::string& theme, const Case& test,
  const std::string& self, const std::string& folder)
{
  Row row{ theme, &test, {}, {}, {} };
  const Setting setting = test.make();
  std::vector<reference::Image> truths[2];
  {
    const Subject subject(setting);
    for (const Reconstruction reconstruction : { Reconstruction::Basis, Reconstruction::Nearest })
    {
      auto& truth = truths[reconstruction == Reconstruction::Nearest];
      truth = subject.truths(reconstruction);
      for (const Traversal traversal : { Traversal::KdTree, Traversal::RayQuery })
      {
        const Errors errors = compare(subject.draw(renderers, reconstruction, traversal), truth);
        row.ours.push_back(decibel(errors.drawn));
        row.greatest.push_back(errors.greatest);
      }
    }
  }
  for (const Peer& peer : listPeers())
  {
    row.peers.push_back(
      setting.amr ? judgePeer(runPeer(self, peer, test.name, folder), truths) : "no AMR");
  }
  return row;
}

void writeCSV(const std::vector<Row>& rows, const std::string& path)
{
  std::ofstream out(path);
  const char* const ways[] = { "basis_kd", "basis_rq", "nearest_kd", "nearest_rq" };
  out << "theme,case";
  for (const char* way : ways)
  {
    out << "," << way << "_db";
  }
  for (const char* way : ways)
  {
    out << "," << way << "_greatest";
  }
  out << ",basis_bound,nearest_bound";
  for (const Peer& peer : listPeers())
  {
    out << "," << peer.name;
  }
  out << ",elsewhere,reason\n";
  for (const Row& row : rows)
  {
    out << row.theme << "," << row.test->name;
    for (const std::string& cell : row.ours)
    {
      out << "," << cell;
    }
    for (const double greatest : row.greatest)
    {
      out << "," << greatest;
    }
    out << "," << row.test->basis << "," << row.test->nearest;
    for (const std::string& cell : row.peers)
    {
      out << "," << cell;
    }
    out << ",\"" << row.test->elsewhere << "\",\"" << row.test->reason << "\"\n";
  }
}

int runAsPeer(const std::string& peer, const std::string& caseName, const std::string& file)
{
  for (const Theme& theme : allThemes())
  {
    for (const Case& test : theme.cases)
    {
      if (test.name == caseName)
      {
        drawAsPeer(peer, test.make(), file);
        return EXIT_SUCCESS;
      }
    }
  }
  return EXIT_FAILURE;
}
}

int main(int argc, char** argv)
{
  try
  {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() == 4 && words[0] == "--peer")
    {
      return runAsPeer(words[1], words[2], words[3]);
    }
    if (words.empty() || words[0].front() == '-')
    {
      std::cerr << "Usage: xvfb-run -a StabilityTable <folder> [<case>...]\n";
      return EXIT_FAILURE;
    }
    const std::set<std::string> wanted(words.begin() + 1, words.end());
    const test::KeepDisplay display;
    const std::vector<Theme> themes = allThemes();
    Renderers renderers;
    std::vector<Row> rows;
    for (const Theme& theme : themes)
    {
      for (const Case& test : theme.cases)
      {
        if (!wanted.empty() && wanted.count(test.name) == 0)
        {
          continue;
        }
        rows.push_back(measure(renderers, theme.name, test, "/proc/self/exe", words[0]));
        std::cout << test.name << std::flush;
        for (const auto& cells : { rows.back().ours, rows.back().peers })
        {
          for (const std::string& cell : cells)
          {
            std::cout << " | " << cell;
          }
        }
        std::cout << std::endl;
        // After each case, for those who stop it.
        writeCSV(rows, words[0] + "/stability.csv");
      }
    }
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "StabilityTable: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
