// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/VolumeRendererInternals.h"

namespace exabricks
{
VolumeRenderer::VolumeRenderer()
  : Data(new Internals)
{
}

VolumeRenderer::~VolumeRenderer() = default;

void VolumeRenderer::selectDevice(const std::string& requested)
{
  if (this->Data->Session.select(requested))
  {
    this->Data->Session.forget();
    this->Data->Release();
  }
}

void VolumeRenderer::selectTraversal(Traversal traversal)
{
  if (traversal != this->Data->RequestedTraversal)
  {
    this->Data->Session.forget();
    this->Data->RequestedTraversal = traversal;
  }
}

void VolumeRenderer::setVolume(const Volume& volume)
{
  this->Data->Session.forget();
  this->Data->ForgetChoice();
  this->Data->SceneFailed = false;
  this->Data->Levels.setVolume(volume);
  if (volume && this->Data->Appearance.setComponents(volume.components()))
  {
    this->Data->Colors.reset();
    this->Data->UpdateVisibility();
  }
}

std::vector<double> VolumeRenderer::finestCells() const
{
  if (this->Data->Levels.empty())
  {
    return {};
  }
  const Hierarchy& hierarchy = this->Data->Levels.volume().structure->hierarchy;
  std::vector<double> widths;
  for (auto width = hierarchy.cellWidth.rbegin();
       width != hierarchy.cellWidth.rend() && (widths.empty() || !hierarchy.whole); ++width)
  {
    widths.push_back(2.0 * static_cast<double>(*width));
  }
  return widths;
}

int VolumeRenderer::makeCoarserAhead(int levelsLeftOut)
{
  this->Data->Levels.makeAhead(levelsLeftOut);
  return this->Data->Levels.ready();
}

double VolumeRenderer::secondsToUpdate(int levelsLeftOut) const
{
  return this->Data->Levels.secondsToUpdate(levelsLeftOut);
}

void VolumeRenderer::setTransferFunction(const TransferFunction& transfer)
{
  this->Data->Session.forget();
  this->Data->Colors.reset();
  this->Data->ForgetChoice();
  if (this->Data->Appearance.isMixed() ||
    !transfer.isAsOpaqueAs(this->Data->Appearance.transferFunction()))
  {
    this->Data->Levels.dropShadows();
  }
  this->Data->Appearance.setTransferFunction(transfer);
  this->Data->UpdateVisibility();
  if (this->Data->Weights)
  {
    this->Data->Weights.emplace(TransferTable(transfer));
  }
}

void VolumeRenderer::setMedium(const Medium& medium)
{
  this->Data->Session.forget();
  this->Data->Colors.reset();
  this->Data->ForgetChoice();
  if (!this->Data->Appearance.isMixed() || !areAsOpaque(medium, this->Data->Appearance.medium()))
  {
    this->Data->Levels.dropShadows();
  }
  this->Data->Appearance.setMedium(medium);
  this->Data->UpdateVisibility();
}

void VolumeRenderer::setGradientOpacity(const std::vector<float>& table)
{
  if (table != this->Data->GradientOpacity)
  {
    this->Data->Session.forget();
    this->Data->Colors.reset();
    this->Data->ForgetChoice();
    this->Data->GradientOpacity = table;
    this->Data->Levels.dropShadows();
  }
}

std::string VolumeRenderer::findDevice()
{
  return this->Data->Run([&] { this->Data->UpdateDevice(); });
}

std::string VolumeRenderer::prepare()
{
  const std::string unmixed = this->Data->CheckMedium();
  return unmixed.empty() ? this->Data->Run([&] { this->Data->Update(); }) : unmixed;
}

std::string VolumeRenderer::render(
  const View& view, std::vector<glm::vec4>& picture, const Progress& progress)
{
  const vulkan::LevelsOfDetail& levels = this->Data->Levels;
  if (!levels.empty() &&
    (view.quality.reconstruction == Reconstruction::Completed) !=
      (levels.volume().values->layer == 1))
  {
    return "the volume's values do not fit the reconstruction: completed ones, with a layer around "
           "each brick, are for Completed alone";
  }
  const std::string unfit = this->Data->Check(view);
  if (!unfit.empty())
  {
    return unfit;
  }
  if (view.cutaway.clippingPlanes.size() > Cutaway::MostClippingPlanes)
  {
    return "expected at most " + std::to_string(Cutaway::MostClippingPlanes) +
      " clipping planes, found " + std::to_string(view.cutaway.clippingPlanes.size());
  }
  vulkan::DeviceSession& session = this->Data->Session;
  if (session.lostTwice() && !samePicture(view, this->Data->LostView))
  {
    session.forget();
  }
  const std::string fault = this->Data->Run([&] { this->Data->Draw(view, picture, progress); });
  if (session.lostTwice())
  {
    this->Data->LostView = view;
  }
  return fault;
}

void VolumeRenderer::release()
{
  this->Data->Session.forget();
  this->Data->Release();
}

const VolumeRenderer::Statistics& VolumeRenderer::statistics() const
{
  return this->Data->Measured;
}

std::vector<std::string> VolumeRenderer::listDevices()
{
  try
  {
    return vulkan::Device::list();
  }
  catch (const std::exception&)
  {
    return {};
  }
}
}
