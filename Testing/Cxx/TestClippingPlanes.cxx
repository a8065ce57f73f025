// SPDX-License-Identifier: BSD-3-Clause
// Clipping planes, as of every VTK mapper: in world coordinates, what lies along their normals is
// left. In a block of one value, a ray is as opaque as the length that is left of it says.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkTransform.h"

#include <limits>

namespace
{
constexpr double Unit = 8.0; // all through the block: opacity 0.5
constexpr double Opacity = 0.5;

void addPlane(
  vtkVolumeMapper* mapper, const std::array<double, 3>& origin, const std::array<double, 3>& normal)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(origin[0], origin[1], origin[2]);
  plane->SetNormal(normal[0], normal[1], normal[2]);
  mapper->AddClippingPlane(plane);
}

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
  }

  // `length`: that is left at x, on a line through the middle of the picture.
  void Expect(const std::function<double(double x)>& length, const std::string& what)
  {
    const test::Picture picture(this->window);
    for (const int pixel : { 10, 30, 50, 70, 90 })
    {
      const double x = 8.0 * (pixel + 0.5) / 100.0;
      this->checks.Near(picture.At(pixel, 50)[0], test::opacityOf(Opacity, length(x), Unit),
        test::OneStep, what + ", at x = " + std::to_string(x));
    }
  }
};

void checkLengths(Block& block)
{
  vtkVolumeMapper* mapper = block.mapper;
  const auto all = [](double) { return 8.0; };
  block.Expect(all, "no plane");

  // Across the rays: what is above, what is below, and what is between two planes.
  addPlane(mapper, { 1.0, 2.0, 3.3 }, { 0.0, 0.0, 1.0 });
  block.Expect([](double) { return 4.7; }, "above z = 3.3");
  addPlane(mapper, { 0.0, 0.0, 5.05 }, { 0.0, 0.0, -20.0 }); // a normal may have any length
  block.Expect([](double) { return 1.75; }, "z from 3.3 to 5.05");

  // A plane that has moved counts as it is now.
  vtkPlane* plane = mapper->GetClippingPlanes()->GetItem(1);
  plane->SetOrigin(0.0, 0.0, 4.0);
  block.Expect([](double) { return 0.7; }, "z from 3.3 to 4");
  plane->SetOrigin(0.0, 0.0, 2.0);
  block.Expect([](double) { return 0.0; }, "nothing is left");
  mapper->RemoveAllClippingPlanes();
  block.Expect(all, "no plane any more");

  // Oblique: below it the ray at x has come from 8 to 8 - x.
  addPlane(mapper, { 4.0, 4.0, 4.0 }, { 1.0, 0.0, 1.0 });
  block.Expect([](double x) { return x; }, "z above 8 - x");
  // Along the rays.
  addPlane(mapper, { 4.0, 0.0, 0.0 }, { -1.0, 0.0, 0.0 });
  block.Expect([](double x) { return x < 4.0 ? x : 0.0; }, "and x below 4");
  mapper->RemoveAllClippingPlanes();

  // A box by six planes.
  for (int axis = 0; axis < 3; ++axis)
  {
    std::array<double, 3> normal{ 0.0, 0.0, 0.0 };
    normal[axis] = 1.0;
    addPlane(mapper, { 1.7, 1.7, 1.7 }, normal);
    normal[axis] = -1.0;
    addPlane(mapper, { 6.2, 6.2, 6.2 }, normal);
  }
  block.Expect([](double x) { return x > 1.7 && x < 6.2 ? 4.5 : 0.0; }, "a box");
  mapper->RemoveAllClippingPlanes();
}

// Planes stay where they are in the world, whatever the volume's matrix is. The unit distance
// counts in the data's own coordinates.
void checkMatrix(Block& block)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(8.0, 0.0, 0.0);
  transform->RotateY(-90.0); // the data's x is the world's z, its z goes along -x
  transform->Scale(0.5, 1.0, 1.0);
  block.volume->SetUserMatrix(transform->GetMatrix()); // 8, 8, 4 wide
  block.Expect([](double) { return 8.0; }, "turned and scaled");
  addPlane(block.mapper, { 0.0, 0.0, 3.0 }, { 0.0, 0.0, 1.0 });
  block.Expect([](double) { return 2.0; }, "above z = 3: a quarter");
  block.mapper->RemoveAllClippingPlanes();
  addPlane(block.mapper, { 0.0, 4.0, 2.0 }, { -0.5, 0.0, 1.0 });
  block.Expect([](double x) { return std::max(0.0, 4.0 - x); }, "z above 2 + x / 2");
  block.mapper->RemoveAllClippingPlanes();
  block.volume->SetUserMatrix(nullptr);
}

void checkFaults(Block& block)
{
  test::Checks& checks = block.checks;
  test::Messages messages;
  const auto refuses = [&](const std::vector<std::string>& words, const std::string& what)
  {
    for (int i = 0; i < 3; ++i)
    {
      checks.Equal(test::Picture(block.window).Coverage(), 0.0, what + " draws nothing");
    }
    checks.Equal(messages.Errors().size(), 1, "errors of " + what);
    checks.Says(messages.TakeErrors(), words, what);
    block.mapper->RemoveAllClippingPlanes();
    block.Expect([](double) { return 8.0; }, "after " + what);
  };
  addPlane(block.mapper, { 1.0, 2.0, 3.0 }, { 0.0, 0.0, 0.0 });
  refuses({ "normal (0, 0, 0)", "origin (1, 2, 3)", "SetNormal" }, "a normal of length 0");
  addPlane(block.mapper, { 1.0, 2.0, std::numeric_limits<double>::infinity() }, { 0.0, 0.0, 1.0 });
  refuses({ "origin (1, 2, inf)" }, "an origin at infinity");
  for (int i = 0; i < 33; ++i)
  {
    addPlane(block.mapper, { 4.0, 4.0, 4.0 }, { 0.0, 0.0, 1.0 });
  }
  refuses({ "at most 32 clipping planes", "found 33" }, "too many planes");
  checks.Silent(messages.TakeWarnings(), "no warnings");
}
}

int TestClippingPlanes(int, char*[])
{
  test::Checks checks;
  Block block(checks, {}, test::cornerRefined());
  checkLengths(block);
  checkMatrix(block);
  checkFaults(block);

  // Cells of another shape, far from the origin of their lattice.
  test::Lattice lattice;
  lattice.spacing = { 0.5, 1.0, 2.0 };
  lattice.origin = { -100.0, 0.0, 40.0 };
  Block anisotropic(checks, lattice, { { 0, { 200, 0, -20 }, { 16, 8, 4 } } });
  checkLengths(anisotropic);
  return checks.Status();
}
