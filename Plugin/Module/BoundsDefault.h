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

  // Whether nobody has chosen a value, or at least none that differs from the default.
  bool isKept() const { return this->Kept; }

  // The default for the data that are read now.
  double value() const { return this->Default; }

  // Whether the last update() has changed the default, as the data were others before it.
  bool hasChanged() const { return this->Changed; }

private:
  bool Kept = true;
  bool Changed = false;
  bool Known = false; // whether it was updated before
  double Found = 0.0; // the property's value at the last update
  double Default = 0.0;
};
}

#endif
