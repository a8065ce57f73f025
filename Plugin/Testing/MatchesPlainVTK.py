# SPDX-License-Identifier: BSD-3-Clause
"""The picture through ParaView is that of the same view through plain VTK."""

from Support import *

load_plugin()
scene = make_scene()
view = make_view()
display = show(scene, view)
look_at(scene, view)
display.OpacityUnitDistance = 8.0


def plain_picture(name, width, height, reconstruction):
    return plain_vtk_picture(view, name, width, height, display.OpacityUnitDistance, reconstruction)


for number, reconstruction in enumerate(("Basis", "Nearest", "Completed")):
    display.Reconstruction = reconstruction
    found = picture(view, reconstruction)
    assert drawn(found) > 0.1, drawn(found)
    expect_alike(found, plain_picture("plain" + reconstruction, 240, 180, number), 55.0, reconstruction)

# A picture of a multiple of the window's size is drawn in tiles, or in a larger buffer.
display.Reconstruction = "Basis"
found = picture(view, "large", ImageResolution=[720, 540])
expect_alike(found, plain_picture("plainLarge", 720, 540, 0), 55.0, "three times the window's size")

# Long opacity unit distances are transparent, and a tolerance is held.
display.OpacityUnitDistance = 80.0
thin = picture(view, "thin")
expect_alike(thin, plain_picture("plainThin", 240, 180, 0), 55.0, "ten times the unit distance")
display.ErrorTolerance = 0.01
expect_alike(picture(view, "tolerant"), thin, 40.0, "error tolerance 0.01")

# The information line.
line = statistics(display)
print(line)
for words in ("4 levels", "leaf cells", "bricks", "regions", "active", "MB", " s"):
    assert words in line, words
