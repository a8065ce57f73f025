// SPDX-License-Identifier: BSD-3-Clause
// Links of k-d trees hold any index of 30 bits, and refuse others before they wrap.
#include "Core/KdLink.h"

#include <gtest/gtest.h>

using namespace exabricks;

namespace
{
constexpr std::size_t Most = layout::KD_NO_REGION - 1;

std::string refusal(std::size_t index)
{
  try
  {
    makeLink(index, layout::KD_LEAF);
  }
  catch (const std::length_error& error)
  {
    return error.what();
  }
  return {};
}
}

TEST(KdLink, HoldsIndexAndKind)
{
  for (const std::size_t index : { std::size_t(0), std::size_t(1), std::size_t(77777), Most })
  {
    for (const std::uint32_t kind : { 0u, 1u, 2u, layout::KD_LEAF })
    {
      EXPECT_EQ(makeLink(index, kind) >> 2, index);
      EXPECT_EQ(makeLink(index, kind) & 3u, kind);
    }
  }
}

TEST(KdLink, IsRefusedBeforeItWraps)
{
  EXPECT_EQ(refusal(Most), "");
  // The last index stands for a leaf with nothing to draw; the next ones would begin anew at 0.
  const std::size_t two30 = std::size_t(1) << 30;
  for (const std::size_t index : { Most + 1, two30, two30 + 1, 4 * two30, 4 * two30 + 5 })
  {
    const std::string said = refusal(index);
    EXPECT_NE(said.find("fewer than 2^30 nodes and entries of lists"), std::string::npos) << said;
    EXPECT_NE(said.find("found at least " + std::to_string(index)), std::string::npos) << said;
    EXPECT_NE(said.find("Read fewer levels"), std::string::npos) << said;
  }
}
