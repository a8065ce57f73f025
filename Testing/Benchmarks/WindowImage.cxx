// SPDX-License-Identifier: BSD-3-Clause
#include "WindowImage.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"

namespace exabricks
{
namespace benchmarks
{
reference::Image readWindow(vtkRenderWindow* window)
{
  const int* size = window->GetSize();
  reference::Image image{ size[0], size[1], {} };
  vtkNew<vtkUnsignedCharArray> bytes;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, bytes);
  for (vtkIdType i = 0; i < bytes->GetNumberOfTuples(); ++i)
  {
    const unsigned char* rgb = bytes->GetPointer(3 * i);
    image.pixels.emplace_back(rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0, 1.0);
  }
  return image;
}
}
}
