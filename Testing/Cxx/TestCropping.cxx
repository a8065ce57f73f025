// SPDX-License-Identifier: BSD-3-Clause
// Cropping, as of every VTK volume mapper: two planes across each axis, in the data's own
// coordinates, divide space into 27 regions; bit x + 3 y + 9 z of the flags shows one. In a block
// of one value, a ray is as opaque as the length of it that lies in regions shown.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkTransform.h"

#include <functional>
#include <limits>

namespace
{
constexpr double Unit = 8.0; // all through the block: opacity 0.5
constexpr double Opacity = 0.5;
constexpr double Low = 1.7; // the planes of all axes
constexpr double High = 6.2;
constexpr double Infinity = std::numeric_limits<double>::infinity();

// The lengths of a ray below, between and behind two planes.
constexpr double Lengths[3] = { Low, High - Low, 8.0 - High };

// A block from 0 to 8, seen along -z.
struct Block : test::Stage
{
  test::Checks& checks;

  Block(test::Checks& c, const test::Lattice& lattice, const std::vector<test::Block>& blocks)
    : Stage(test::makeAMR(blocks, test::constant(1.0), lattice))
    , checks(c)
  {
    test::setConstantColor(this->Property(), Opacity);
    this->Property()->SetScalarOpacityUnitDistance(Unit);
    test::lookAlongZ(this->renderer, 4.0, 4.0, 4.0, 8.0);
    this->mapper->SetCroppingRegionPlanes(Low, High, Low, High, Low, High);
  }

  // `length`: that is left of rays through region x, y of the plane.
  void Expect(const std::function<double(int x, int y)>& length, const std::string& what)
  {
    const test::Picture picture(this->window);
    const int pixels[3] = { 10, 50, 90 };
    for (int y = 0; y < 3; ++y)
    {
      for (int x = 0; x < 3; ++x)
      {
        this->checks.Near(picture.At(pixels[x], pixels[y])[0],
          test::opacityOf(Opacity, length(x, y), Unit), test::OneStep,
          what + ", in region " + std::to_string(x) + ", " + std::to_string(y));
      }
    }
  }
  void ExpectWhole(const std::string& what)
  {
    this->Expect([](int, int) { return 8.0; }, what);
  }
  void ExpectRegions(int flags, const std::string& what)
  {
    this->mapper->SetCroppingRegionFlags(flags);
    this->Expect(
      [flags](int x, int y)
      {
        double sum = 0.0;
        for (int z = 0; z < 3; ++z)
        {
          sum += (flags >> (x + 3 * y + 9 * z) & 1) * Lengths[z];
        }
        return sum;
      },
      what);
  }
};

void checkRegions(Block& block)
{
  vtkVolumeMapper* mapper = block.mapper;
  block.ExpectWhole("off");
  mapper->CroppingOn();
  mapper->SetCroppingRegionFlagsToSubVolume();
  block.Expect([](int x, int y) { return x == 1 && y == 1 ? High - Low : 0.0; }, "subvolume");
  mapper->SetCroppingRegionFlagsToCross();
  block.Expect([](int x, int y)
    { return x == 1 && y == 1 ? 8.0
        : x == 1 || y == 1    ? High - Low
                              : 0.0; },
    "cross");
  mapper->SetCroppingRegionFlagsToInvertedFence();
  block.ExpectRegions(mapper->GetCroppingRegionFlags(), "inverted fence");
  for (const int flags : { VTK_CROP_FENCE, VTK_CROP_INVERTED_CROSS, 0, 1, 1 << 26, 0x5555555,
         0x2aaaaaa, 0x7ffdfff, 0x1234567 & 0x7ffffff })
  {
    block.ExpectRegions(flags, "flags " + std::to_string(flags));
  }
  block.ExpectRegions(0x7ffffff, "all regions");
  mapper->CroppingOff();
}

void checkPlanes(Block& block)
{
  vtkVolumeMapper* mapper = block.mapper;
  mapper->CroppingOn();
  mapper->SetCroppingRegionFlagsToSubVolume();
  mapper->SetCroppingRegionPlanes(-Infinity, Infinity, -100.0, 1e30, 0.0, 8.0);
  block.ExpectWhole("planes at infinity, far away, and at the bounds");
  mapper->SetCroppingRegionPlanes(-100.0, 100.0, -100.0, 100.0, 3.0, 2.0);
  block.Expect([](int, int) { return 0.0; }, "nothing is between planes in the wrong order");
  mapper->SetCroppingRegionFlags(0x7ffffff & ~VTK_CROP_SUBVOLUME);
  block.ExpectWhole("but all is around them");

  test::Messages messages;
  mapper->SetCroppingRegionPlanes(0.0, 1.0, 0.0, std::nan(""), 0.0, 1.0);
  for (int i = 0; i < 3; ++i)
  {
    block.checks.Equal(test::Picture(block.window).Coverage(), 0.0, "NaN draws nothing");
  }
  block.checks.Equal(messages.Errors().size(), 1, "errors of NaN");
  block.checks.Says(messages.TakeErrors(), { "CroppingRegionPlanes", "nan" }, "NaN");
  mapper->CroppingOff(); // then nobody minds the planes
  block.ExpectWhole("off again");
  block.checks.Silent(messages.TakeWarnings(), "no warnings");
  block.checks.Silent(messages.TakeErrors(), "no errors");
  mapper->SetCroppingRegionPlanes(Low, High, Low, High, Low, High);
}

// The planes move with the volume.
void checkMatrix(Block& block)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(8.0, 0.0, 0.0);
  transform->RotateY(-90.0); // the data's x is the world's z, its z goes along -x
  transform->Scale(0.5, 1.0, 1.0);
  block.volume->SetUserMatrix(transform->GetMatrix());
  block.mapper->CroppingOn();
  block.mapper->SetCroppingRegionFlags(1 << (0 + 3 * 1 + 9 * 2)); // low x, middle y, high z
  block.Expect([](int x, int y) { return x == 0 && y == 1 ? Low : 0.0; }, "turned and scaled");
  block.mapper->CroppingOff();
  block.volume->SetUserMatrix(nullptr);
}
}

int TestCropping(int, char*[])
{
  test::Checks checks;
  Block block(checks, {}, test::cornerRefined());
  checkRegions(block);
  checkPlanes(block);
  checkMatrix(block);

  // Cells of another shape, far from the origin of their lattice.
  test::Lattice lattice;
  lattice.spacing = { 0.5, 1.0, 2.0 };
  lattice.origin = { -100.0, 0.0, 40.0 };
  Block anisotropic(checks, lattice, { { 0, { 200, 0, -20 }, { 16, 8, 4 } } });
  checkRegions(anisotropic);
  return checks.Status();
}
