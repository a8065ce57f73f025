// SPDX-License-Identifier: BSD-3-Clause
// Mappers in windows: ours, and what VTK offers by itself.
#include "Method.h"
#include "Resampling.h"
#include "Timing.h"
#include "VTKScene.h"
#include "WindowImage.h"

#include "Display.h"

#include "vtkExaBricksVolumeMapper.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"

#include <map>

namespace exabricks
{
namespace benchmarks
{
namespace
{
// A mapper in a window, with the scene's camera and functions. The mapper is made by the first
// setUp(); `apply` gives it the parameter's value.
class WindowMethod : public Method
{
public:
  explicit WindowMethod(const Scene& scene)
    : Subject(scene)
    , Window(render::makeWindow())
  {
    vtkVolumeProperty* from = scene.vtk().property;
    vtkNew<vtkVolumeProperty> property;
    property->SetColor(from->GetRGBTransferFunction());
    property->SetScalarOpacity(from->GetScalarOpacity());
    property->SetScalarOpacityUnitDistance(from->GetScalarOpacityUnitDistance());
    property->SetInterpolationTypeToLinear();
    property->ShadeOff();
    this->Volume->SetProperty(property);
    vtkNew<vtkRenderer> renderer;
    renderer->AddVolume(this->Volume);
    if (const auto surface = makeSurfaceActor(scene.model().surface))
    {
      renderer->AddActor(surface);
    }
    renderer->SetBackground(0.0, 0.0, 0.0);
    renderer->SetActiveCamera(makeCamera(scene.model()));
    this->Window->AddRenderer(renderer);
    this->Window->SetDesiredUpdateRate(0.0001); // never coarser for the sake of speed
  }

  SetUp setUp(double value) override
  {
    SetUp result;
    this->share(value);
    Costs costs;
    costs.measure(
      [&]
      {
        this->prepare(value, result);
        if (result.possible)
        {
          this->draw({ 64, 64 }, value); // textures, programs
        }
      });
    result.seconds = result.possible ? costs.wall.front() : NotMeasured;
    this->complete(value, result);
    return result;
  }

  void draw(const Size& size, double value) override
  {
    this->apply(value);
    this->Window->SetSize(size[0], size[1]);
    this->Window->Render();
    this->Window->WaitForCompletion();
  }

  reference::Image picture() override { return readWindow(this->Window); }

protected:
  /// What other methods use too: its time is not this one's, but may be added in complete().
  virtual void share(double) {}
  virtual void prepare(double value, SetUp& result) = 0;
  virtual void complete(double, SetUp&) {}
  virtual void apply(double) {}

  const Scene& Subject;
  vtkNew<vtkVolume> Volume;

private:
  vtkSmartPointer<vtkRenderWindow> Window;
};

class OurMapper : public WindowMethod
{
public:
  using WindowMethod::WindowMethod;

  // The same for all values.
  SetUp setUp(double value) override
  {
    this->Ready = this->Volume->GetMapper() ? this->Ready : this->WindowMethod::setUp(value);
    return this->Ready;
  }

protected:
  void prepare(double, SetUp&) override
  {
    const VTKScene& vtk = this->Subject.vtk();
    this->Mapper->SetInputDataObject(vtk.amr);
    this->Mapper->SetScalarModeToUseCellFieldData();
    this->Mapper->SelectScalarArray(vtk.array.c_str());
    if (vtk.component >= 0)
    {
      this->Mapper->SetVectorModeToComponent();
      this->Mapper->SetVectorComponent(vtk.component);
    }
    this->Volume->SetMapper(this->Mapper);
  }
  void apply(double value) override { this->Mapper->SetStepScale(value); }

private:
  vtkNew<vtkExaBricksVolumeMapper> Mapper;
  SetUp Ready;
};

// More blocks than this use up OpenGL's texture units: the picture is black.
constexpr int MostBlocks = 183;

class MultiBlock : public WindowMethod
{
public:
  MultiBlock(const Scene& scene, bool blanked)
    : WindowMethod(scene)
    , Blanked(blanked)
  {
  }

protected:
  void prepare(double, SetUp& result) override
  {
    const std::size_t blocks = this->Subject.structure().hierarchy.blocks.size();
    if (blocks > MostBlocks)
    {
      result.possible = false;
      result.note = "no picture: more blocks (" + std::to_string(blocks) + ") than texture units";
      return;
    }
    this->Volume->SetMapper(makeMultiBlockMapper(makePeerData(this->Subject), this->Blanked));
  }

private:
  const bool Blanked;
};

// The parameter is the number of cells along each axis.
class Resampled : public WindowMethod
{
public:
  Resampled(const Scene& scene, bool onGPU)
    : WindowMethod(scene)
    , OnGPU(onGPU)
  {
  }

protected:
  void share(double value) override { resampled(this->Subject, static_cast<int>(value)); }

  void prepare(double value, SetUp&) override
  {
    this->Mappers[value] = this->makeMapper(resampled(this->Subject, static_cast<int>(value)));
  }

  void complete(double value, SetUp& result) override
  {
    const ResampledGrid& grid = resampled(this->Subject, static_cast<int>(value));
    result.resampling = grid.seconds;
    result.seconds += grid.seconds;
    result.hostBytes = grid.bytes;
    result.note = grid.estimated ? "time of resampling estimated" : "";
  }

  void apply(double value) override
  {
    if (this->Volume->GetMapper() != this->Mappers.at(value))
    {
      this->Volume->SetMapper(this->Mappers.at(value));
    }
  }

private:
  // Samples half a grid cell apart, which is VTK's own rule.
  template <typename Mapper>
  static vtkSmartPointer<vtkVolumeMapper> Make(vtkImageData* image)
  {
    auto mapper = vtkSmartPointer<Mapper>::New();
    mapper->SetInputData(image);
    mapper->SetScalarModeToUsePointData();
    mapper->AutoAdjustSampleDistancesOff();
    mapper->LockSampleDistanceToInputSpacingOff();
    const double* spacing = image->GetSpacing();
    mapper->SetSampleDistance(
      static_cast<float>(0.5 * std::min({ spacing[0], spacing[1], spacing[2] })));
    return mapper;
  }

  vtkSmartPointer<vtkVolumeMapper> makeMapper(const ResampledGrid& grid) const
  {
    return this->OnGPU ? Make<vtkGPUVolumeRayCastMapper>(grid.image)
                       : Make<vtkFixedPointVolumeRayCastMapper>(grid.image);
  }

  const bool OnGPU;
  std::map<double, vtkSmartPointer<vtkVolumeMapper>> Mappers;
};

#ifdef EXABRICKS_VTK_HAS_AMR_MAPPER
class AMRMapper : public WindowMethod
{
public:
  using WindowMethod::WindowMethod;

protected:
  void prepare(double, SetUp&) override
  {
    this->Volume->SetMapper(makeAMRMapper(makePeerData(this->Subject)));
  }
};
#endif

template <typename Class, typename... Arguments>
std::function<std::unique_ptr<Method>(const Scene&)> maker(Arguments... arguments)
{
  return [=](const Scene& scene) { return std::make_unique<Class>(scene, arguments...); };
}
}

std::vector<MethodKind> listWindowMethods()
{
  const char* const grid = "grid cells";
  const std::vector<double> once{ 0.0 };
  return {
    { "vtkExaBricksVolumeMapper", Role::Ours, StepScale, { 4.0, 2.0, 1.2, 1.0, 0.5 }, { 1.0 },
      std::nullopt, maker<OurMapper>() },
    { "vtkMultiBlockVolumeMapper, all blocks", Role::Peer, "", once, {}, std::nullopt,
      maker<MultiBlock>(false) },
    { "vtkMultiBlockVolumeMapper, covered cells blanked", Role::Peer, "", once, {}, std::nullopt,
      maker<MultiBlock>(true) },
    { "resampled, vtkGPUVolumeRayCastMapper", Role::Peer, grid, { 128.0, 256.0, 512.0 }, {},
      std::nullopt, maker<Resampled>(true) },
    { "resampled, vtkFixedPointVolumeRayCastMapper", Role::Peer, grid, { 128.0, 256.0, 512.0 },
      { 128.0 }, std::nullopt, maker<Resampled>(false) },
#ifdef EXABRICKS_VTK_HAS_AMR_MAPPER
    { "vtkAMRVolumeMapper", Role::Peer, "", once, {}, std::nullopt, maker<AMRMapper>() },
#endif
  };
}
}
}
