// SPDX-License-Identifier: BSD-3-Clause

#include "Adapters/ColorMaps.h"

#include "vtkColorTransferFunction.h"

#include <cstdlib>
#include <cstring>

namespace exabricks
{

namespace
{

struct Table
{
  const char* Name;
  const char* Colors; // equally spaced, rrggbb in hexadecimal
};

// Viridis to cividis are by S. van der Walt, N. Smith and others (CC0), turbo by A. Mikhailov
// (Apache-2.0): 33 of their 256 colours; the others are within 4 of 255 of the straight line
// between these (6 in cividis).
const Table Tables[] = {
  { "viridis",
    "440154470d6048186a482374472d7b4536814240863f49893b528b375a8d33638d2f6a8e2c728e297a8e"
    "26818e23898e21908c1f988b1f9f8821a68528ae8031b57b3ebc744cc26c5dc9636ece5882d34c96d83f"
    "abdc32c0df24d5e21aeae51afde725" },
  { "plasma",
    "0d08872206903105963f049c4c02a15901a56600a77201a87e03a88909a69511a29f1a9ca92396b22c8e"
    "bb3587c33e80cb4778d25071d9596ae06263e66c5ceb7555f07f4ff48a48f89441fb9f3afdab33feb72d"
    "fdc328fcd025f9dd25f5eb27f0f921" },
  { "inferno",
    "0000040403120b0724150b37210c4a2e0a5a3c09654a0c6b57106d63146e70196e7d1e6d89226a962766"
    "a32b61af315cbb3755c63e4dd14644db4f3be35932eb6528f1711ef67f14f98d0afb9c06fcab0ffbba1f"
    "f9ca32f5d949f2e865f3f586fcffa4" },
  { "magma",
    "0000040303110a0822130d331d114628115a36106a430f7650127c5d177f691c817621818226818f2a81"
    "9c2e7fa9327db63779c33b75cf4170db486ae65163ee5c5ef5695cf9785dfb8761fd9668fea571feb47b"
    "fec387fed194fde0a2fceeb0fcfdbf" },
  { "cividis",
    "00224e00285b002e6a0433711a386f273e6e32436d3b496c434e6c4b546c52596d5a5f6e61656f686a71"
    "6f70737576767c7b788481798b8778938d789b9376a39a75aba072b3a670bbad6cc3b469ccba64d4c15f"
    "ddc958e6d051efd748f8df3cfee838" },
  { "turbo",
    "30123b392a734040a14456c7466be3467ff64293ff37a7fa29bbec1dcdd818dcc31ee8b031f2994cf97e"
    "6bfd648aff4da3fd3cb8f735cced34dee037edd03af8c03afdae35fe982cfb8022f56817ec520fe04009"
    "d23105c02302ac1701950d017a0403" },
  { "gray", "000000ffffff" },
  // Two ends for a diverging colour space, K. Moreland, "Diverging Color Maps for Scientific
  // Visualization".
  { "cool-warm", "3b4cc0b40426" },
};

const Table* findTable(const std::string& name)
{
  for (const Table& table : Tables)
  {
    if (name == table.Name)
    {
      return &table;
    }
  }
  return nullptr;
}

}

std::string colorMapNames()
{
  std::string names;
  for (const Table& table : Tables)
  {
    names += (names.empty() ? "" : ", ") + std::string(table.Name);
  }
  return names;
}

bool hasColorMap(const std::string& name) { return findTable(name) != nullptr; }

void fillColorMap(const std::string& name, const double range[2], vtkColorTransferFunction* colors)
{
  const Table* table = findTable(name);
  if (!table)
  {
    return;
  }
  colors->RemoveAllPoints();
  if (name == "cool-warm")
  {
    colors->SetColorSpaceToDiverging();
  }
  else
  {
    colors->SetColorSpaceToRGB();
  }
  const int count = static_cast<int>(std::strlen(table->Colors) / 6);
  for (int i = 0; i < count; ++i)
  {
    const std::string hex(table->Colors + 6 * i, 6);
    const unsigned long rgb = std::strtoul(hex.c_str(), nullptr, 16);
    const double t = i / (count - 1.0);
    colors->AddRGBPoint(range[0] + t * (range[1] - range[0]), (rgb >> 16 & 255) / 255.0,
      (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0);
  }
}

}
