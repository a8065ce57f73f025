// SPDX-License-Identifier: BSD-3-Clause
#pragma once

class vtkSMProperty;

namespace exabricks
{

// Tells whether a property with a vtkSMBoundsDomain has the value that ParaView gave it, or one
// that somebody chose. ParaView sets such a default when the representation is made, from the data
// as they are then, and leaves it.
class BoundsDefault
{
public:
  // Looks at the property's value, and at its default for the data that are read now.
  void update(vtkSMProperty* property);

  // Nobody has chosen a value; at least none that differs from the default.
  bool isKept() const { return this->kept_; }

  // For the data that are read now.
  double value() const { return this->default_; }

  // The default was that of other data before the last update().
  bool hasChanged() const { return this->changed_; }

private:
  bool kept_ = true;
  bool changed_ = false;
  bool known_ = false; // updated once
  double found_ = 0.0; // the property's value at the last update
  double default_ = 0.0;
};

}
