# SPDX-License-Identifier: BSD-3-Clause
"""Properties that do nothing for ExaBricks are not in its panel, and setting one that one would expect to matter is said."""

from Support import *

load_plugin()
collector = Collector()
scene = make_scene()
view = make_view()
display = show(scene, view)
look_at(scene, view)
first = picture(view, "first")
assert drawn(first) > 0.1, drawn(first)
collector.expect_silence()


def is_shown(name, representation):
    """As the panel decides: by the decorators of a property and of its group."""
    proxy = display.SMProxy
    property = proxy.GetProperty(name)
    groups = [proxy.GetPropertyGroup(i) for i in range(proxy.GetNumberOfPropertyGroups())]
    owners = [property] + [
        group for group in groups
        if any(group.GetProperty(i) is property for i in range(group.GetNumberOfProperties()))]
    for owner in owners:
        hints = owner.GetHints()
        for i in range(hints.GetNumberOfNestedElements() if hints else 0):
            attribute = hints.GetNestedElement(i).GetAttribute
            if attribute("property") == "Representation" and attribute("mode") == "visibility":
                inverse = attribute("inverse") == "1"
                if (attribute("value") == representation) == inverse:
                    return False
    return True


unused = ["Opacity", "MapScalars", "InterpolateScalarsBeforeMapping", "PointSize", "LineWidth", "Interpolation",
          "EdgeColor", "BackfaceRepresentation", "Shade", "NumberOfSamples", "ResamplingMode",
          "VolumeRenderingMode", "ScalarOpacityUnitDistance", "OSPRayMaterial", "Triangulate"]
position = "Translation" if "Translation" in display.ListProperties() else "Position"  # from 5.13 on
used = ["ColorArrayName", "LookupTable", position, "Scale", "Orientation", "Origin", "Pickable", "OpacityUnitDistance",
        "Reconstruction", "BlendMode", "Shading", "ErrorTolerance", "StepScale", "DataAxesGrid", "PolarAxes",
        "Ambient", "Diffuse", "Specular", "SpecularPower", "LevelRange", "Cropping"]
for name in unused:
    assert not is_shown(name, "ExaBricks"), name
for name in used:
    assert is_shown(name, "ExaBricks"), name
for name in ("Opacity", "MapScalars", "PointSize", "Interpolation", "EdgeColor"):
    assert is_shown(name, "Surface"), name
for name in ("Shade", "NumberOfSamples"):
    assert is_shown(name, "Volume"), name

# From Python all can be set: one warning names those that would be expected to matter.
display.Opacity = 0.5
display.Shade = 1
picture(view, "set")
expect_alike(picture(view, "setAgain"), first, 60.0, "with properties that do nothing")
collector.expect_said("Opacity (lower", "Shade")
display.Shade = 0
display.Opacity = 1.0
picture(view, "reset")
collector.expect_silence()
display.ScalarOpacityUnitDistance = 3.0
picture(view, "otherUnit")
collector.expect_said("ScalarOpacityUnitDistance (set OpacityUnitDistance")

# Where they count nothing is said.
display.SetRepresentationType("Surface")
display.Opacity = 0.5
picture(view, "surface")
collector.expect_silence()
