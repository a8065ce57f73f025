// SPDX-License-Identifier: BSD-3-Clause
// Our march by the processor itself (Native): what this machine can do, to measure Vulkan drivers
// that run on it by.
#include "Method.h"
#include "NativeMarcher.h"
#include "Timing.h"

#include <thread>

namespace exabricks
{
namespace benchmarks
{
namespace
{
class NativeMethod : public Method
{
public:
  explicit NativeMethod(const Scene& scene)
    : Subject(scene)
  {
  }

  SetUp setUp(double) override
  {
    SetUp result;
    if (this->Subject.values().absentCells > 0)
    {
      result.possible = false;
      result.note = "not drawn: it knows no absent cells";
      return result;
    }
    if (!this->Marcher)
    {
      Costs costs;
      costs.measure(
        [&]
        {
          this->Marcher = std::make_unique<NativeMarcher>(
            this->Subject.volume(Reconstruction::Basis), this->Subject.transfer());
        });
      this->Seconds = costs.wall.front();
    }
    result.seconds = this->Subject.buildTime(Reconstruction::Basis) + this->Seconds;
    return result;
  }

  void draw(const Size& size, double value) override
  {
    View view = this->Subject.view(size, Reconstruction::Basis);
    view.quality.stepScale = value;
    const int threads = std::max(static_cast<int>(std::thread::hardware_concurrency()), 1);
    this->Marcher->render(view, threads, this->Pixels);
    this->Drawn = size;
  }

  reference::Image picture() override
  {
    return { this->Drawn[0], this->Drawn[1], { this->Pixels.begin(), this->Pixels.end() } };
  }
  bool hasOpacity() const override { return true; }

private:
  const Scene& Subject;
  std::unique_ptr<NativeMarcher> Marcher;
  double Seconds = 0.0;
  Size Drawn{};
  std::vector<glm::vec4> Pixels;
};
}

std::vector<MethodKind> listNativeMethods()
{
  return { { "native march, k-d tree", Role::Baseline, StepScale, { 2.0, 1.0, 0.5 },
    { DefaultStepScale }, reference::Reconstruction::Basis,
    [](const Scene& scene) { return std::make_unique<NativeMethod>(scene); }, true } };
}
}
}
