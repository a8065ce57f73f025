# SPDX-License-Identifier: BSD-3-Clause
"""What cannot be drawn is said once, in words, and the outline is drawn; nothing at all is no fault."""

from Support import *

collector = Collector()
expect_said = collector.expect_said
said = collector.said


def near(lines):
    """The pixels that touch one of these."""
    padded = numpy.pad(lines, 1)
    rows, columns = lines.shape
    return numpy.any([padded[i:i + rows, j:j + columns] for i in range(3) for j in range(3)], axis=0)


def expect_outline(name):
    """The lines of a box as large as the data, give or take smoothing, and nothing else."""
    found, expected = picture(view, name).max(axis=-1), outline.max(axis=-1)
    assert not numpy.any((found > 0.02) & ~near(expected > 0.02)), name + ": there is something beside the outline"
    assert not numpy.any((expected > 0.5) & ~near(found > 0.5)), name + ": a part of the outline is missing"


load_plugin()
view = make_view()

# No device.
scene = make_scene()
display = show(scene, view)
look_at(scene, view)
first = picture(view, "first")
simple.Hide(scene, view)
bounds = scene.GetDataInformation().GetBounds()
box = simple.Box(Center=[0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)])
box.XLength, box.YLength, box.ZLength = (bounds[2 * i + 1] - bounds[2 * i] for i in range(3))
boxDisplay = simple.Show(box, view)
boxDisplay.SetRepresentationType("Outline")
boxDisplay.AmbientColor = boxDisplay.DiffuseColor = [1.0, 1.0, 1.0]
outline = picture(view, "outline")
assert 0.003 < drawn(outline) < 0.08, drawn(outline)
simple.Delete(box)
simple.Show(scene, view)
assert not said, said
display.VulkanDevice = "abacus"
expect_outline("noDevice")
expect_outline("noDeviceAgain")
expect_said("abacus")
assert "nothing drawn" in statistics(display), statistics(display)
# The same where depth is peeled: translucent and black, the ball does not show.
ball = simple.Sphere(Center=view.CameraFocalPoint, Radius=0.02 * (bounds[1] - bounds[0]))
ballDisplay = simple.Show(ball, view)
ballDisplay.ColorArrayName = ["POINTS", ""]
ballDisplay.AmbientColor = ballDisplay.DiffuseColor = [0.0, 0.0, 0.0]
ballDisplay.Specular, ballDisplay.Opacity = 0.0, 0.5
expect_outline("noDevicePeeled")
simple.Delete(ball)
display.VulkanDevice = ""
expect_alike(picture(view, "device"), first, 60.0, "with a device")
assert not said, said

# No array, and one that is gone.
display.ColorArrayName = ["CELLS", ""]
expect_outline("noArray")
expect_outline("noArrayAgain")
expect_said("Choose one to color by")
display.ColorArrayName = ["CELLS", "pressure"]
expect_outline("wrongArray")
expect_outline("wrongArrayAgain")
expect_said("'pressure'", "'value'")
display.ColorArrayName = ["CELLS", "value"]
expect_alike(picture(view, "array"), first, 60.0, "with an array")
assert not said, said

# A volume in the same place without an array is an outline, and no part of the first one's picture.
other = make_scene()
show(other, view).ColorArrayName = ["CELLS", ""]
picture(view, "withOutline")
expect_said("Choose one to color by")
simple.Delete(other)
expect_alike(picture(view, "withoutOutline"), first, 60.0, "alone again")
assert not said, said

# No data.
simple.Delete(display)
simple.Delete(scene)
empty = make_empty()
display = simple.Show(empty, view, "AMRRepresentation")
display.SetRepresentationType("ExaBricks")
assert drawn(picture(view, "noData")) == 0.0
assert not [text for text in said if "ExaBricks" in text], said
assert statistics(display) == "nothing drawn"
