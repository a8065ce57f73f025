// SPDX-License-Identifier: BSD-3-Clause
// Window and level of a picture's colours.
#ifndef ExaBricksAdaptersColorWindow_h
#define ExaBricksAdaptersColorWindow_h

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace exabricks
{
struct ColorWindow
{
  double window = 1.0; // not 0
  double level = 0.5;

  /// `picture`: premultiplied colours and opacity. Where a colour would become less than 0, it is
  /// 0.
  void apply(std::vector<glm::vec4>& picture) const
  {
    if (this->window == 1.0 && this->level == 0.5)
    {
      return;
    }
    const auto scale = static_cast<float>(1.0 / this->window);
    const auto bias = static_cast<float>(0.5 - this->level / this->window);
    for (glm::vec4& pixel : picture)
    {
      const glm::vec3 color = glm::vec3(pixel) * scale + bias * pixel.a;
      pixel = glm::vec4(glm::max(color, glm::vec3(0.0f)), pixel.a);
    }
  }
};
}

#endif
