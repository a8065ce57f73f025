// SPDX-License-Identifier: BSD-3-Clause
#ifndef ExaBricksPluginBoundsDefault_h
#define ExaBricksPluginBoundsDefault_h

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
  bool isKept() const { return this->Kept; }

  // For the data that are read now.
  double value() const { return this->Default; }

  // The default was that of other data before the last update().
  bool hasChanged() const { return this->Changed; }

private:
  bool Kept = true;
  bool Changed = false;
  bool Known = false; // updated once
  double Found = 0.0; // the property's value at the last update
  double Default = 0.0;
};
}

#endif
