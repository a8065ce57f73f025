# SPDX-License-Identifier: BSD-3-Clause
"""Representations, arrays, components and transforms change, and change back."""

from Support import *

load_plugin()
scene = make_scene()
view = make_view()
display = show(scene, view)
look_at(scene, view)
assert "ExaBricks" in display.GetProperty("Representation").Available
first = picture(view, "first")
assert drawn(first) > 0.1, drawn(first)

# To ParaView's own and back.
for other in ("Outline", "Volume", "Surface"):
    display.SetRepresentationType(other)
    expect_different(picture(view, other), first, 40.0, other)
    display.SetRepresentationType("ExaBricks")
    expect_alike(picture(view, "after" + other), first, 60.0, "after " + other)

# Hidden, and taken out of the view.
simple.Hide(scene, view)
assert drawn(picture(view, "hidden")) == 0.0
simple.Show(scene, view)
expect_alike(picture(view, "shown"), first, 60.0, "shown again")

# Moved: the view's reset finds it where it is, and its picture is the same from there.
position = "Translation" if "Translation" in display.ListProperties() else "Position"  # from 5.13 on
setattr(display, position, [1000.0, 0.0, 0.0])
view.CameraPosition = [view.CameraPosition[0] + 1000.0, *view.CameraPosition[1:]]
view.CameraFocalPoint = [view.CameraFocalPoint[0] + 1000.0, *view.CameraFocalPoint[1:]]
expect_alike(picture(view, "moved"), first, 40.0, "moved with the camera")
setattr(display, position, [0.0, 0.0, 0.0])
look_at(scene, view)
display.Scale = [1.0, 1.0, 0.2]
expect_different(picture(view, "flat"), first, 30.0, "flattened")
# Twice as large, and seen from twice as far: the unit distance is one of the data's own coordinates.
display.Scale = [2.0, 2.0, 2.0]
near = view.CameraPosition[:], view.CameraFocalPoint[:]
view.CameraPosition, view.CameraFocalPoint = ([2.0 * x for x in place] for place in near)
expect_alike(picture(view, "double"), first, 60.0, "twice as large")
view.CameraPosition, view.CameraFocalPoint = near
display.Scale = [1.0, 1.0, 1.0]
display.UserTransform = [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1]
expect_different(picture(view, "half"), first, 30.0, "half the size")
display.UserTransform = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
expect_alike(picture(view, "back"), first, 60.0, "moved back")

# Another array, with components: the color map chooses.
calculator = simple.Calculator(Input=scene, AttributeType="Cell Data", ResultArrayName="pair")
calculator.Function = "value*iHat - value*jHat"
calculator.UpdatePipeline()
simple.Hide(scene, view)
pair = show(calculator, view, ("CELLS", "value"))
pair.OpacityUnitDistance = display.OpacityUnitDistance
expect_alike(picture(view, "sameArray"), first, 60.0, "the same array through a filter")
show(calculator, view, ("CELLS", "pair"))
color = simple.GetColorTransferFunction("pair")
color.VectorMode = "Component"
color.VectorComponent = 0
expect_alike(picture(view, "component0"), first, 60.0, "component 0")
color.VectorComponent = 1
component1 = picture(view, "component1")
expect_different(component1, first, 30.0, "component 1")
color.VectorMode = "Magnitude"
magnitude = picture(view, "magnitude")
expect_different(magnitude, component1, 30.0, "magnitude, and component 1")
expect_different(magnitude, first, 40.0, "magnitude, and component 0")
simple.ColorBy(pair, ("CELLS", "value"))
expect_alike(picture(view, "firstArray"), first, 60.0, "the first array again")

simple.Delete(pair)
simple.Delete(calculator)
assert drawn(picture(view, "deleted")) == 0.0
