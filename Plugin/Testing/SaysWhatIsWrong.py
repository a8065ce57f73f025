# SPDX-License-Identifier: BSD-3-Clause
"""What cannot be drawn is said once, in words, and the outline is drawn; nothing at all is no fault."""

from Support import *

collector = Collector()
expect_said = collector.expect_said
said = collector.said


def expect_outline(name):
    """Thin lines around the data."""
    pixels = picture(view, name)
    share = drawn(pixels)
    assert 0.003 < share < 0.08, (name, share)


load_plugin()
view = make_view()

# No device.
scene = make_scene()
display = show(scene, view)
look_at(scene, view)
display.VulkanDevice = "abacus"
expect_outline("noDevice")
expect_outline("noDeviceAgain")
expect_said("abacus")
assert "nothing drawn" in statistics(display), statistics(display)
display.VulkanDevice = ""
assert drawn(picture(view, "device")) > 0.1
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
assert drawn(picture(view, "array")) > 0.1
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
