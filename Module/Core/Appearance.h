// SPDX-License-Identifier: BSD-3-Clause
// What the values of a volume look like in a picture: what is looked up along its rays, and which
// values matter.
#ifndef ExaBricksCoreAppearance_h
#define ExaBricksCoreAppearance_h

#include "Core/ActiveRegions.h"
#include "Core/Medium.h"
#include "Core/TransferTable.h"
#include "Core/View.h"

#include <optional>
#include <utility>

namespace exabricks
{
/// [component]: a function that is visible where the component's values matter to the picture;
/// none: they do not.
using Visibility = std::vector<std::optional<TransferFunction>>;

bool showTheSame(const Visibility& a, const Visibility& b);

class Appearance
{
public:
  /// Of one component.
  void setTransferFunction(const TransferFunction& transfer)
  {
    this->Transfer = transfer;
    if (this->Mixed.mixing == Mixing::Planar)
    {
      this->Mixed = {};
    }
  }
  const TransferFunction& transferFunction() const { return this->Transfer; }
  /// Of several, or a planar one of one, in its place.
  void setMedium(const Medium& medium) { this->Mixed = medium; }
  const Medium& medium() const { return this->Mixed; }

  /// Of each cell. False: it has had so many.
  bool setComponents(std::size_t components)
  {
    return std::exchange(this->Components, components) != components;
  }
  /// Whether the medium counts, in place of a function of one component.
  bool isMixed() const { return this->Components > 1 || this->Mixed.mixing == Mixing::Planar; }
  /// Why the medium does not fit so many components; empty: it does.
  std::string checkMedium() const;

  /// Takes what of the view matters. False: nothing has changed.
  bool setView(const View& view);
  Blending blending() const { return this->Blended; }

  /// Of one component, or of each function of the medium.
  std::vector<TransferTable> makeTables() const;
  Visibility findVisibility() const;
  /// By which regions are passed.
  Extreme extreme() const;
  /// Whether cells show whose value is undefined.
  bool showsUndefined() const { return this->Undefined && !this->isMixed(); }

private:
  TransferFunction Transfer;
  Medium Mixed;
  std::size_t Components = 1;
  Blending Blended = Blending::Composite;
  AverageRanges Averaged = wholeAverageRanges();
  std::vector<double> IsoValues;
  bool SurfacesOfCells = false;
  bool Undefined = false;
};
}

#endif
