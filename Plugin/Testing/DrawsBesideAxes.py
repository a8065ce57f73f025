# SPDX-License-Identifier: BSD-3-Clause
"""Axes around the view's or the data's bounds leave the volume as it is where they draw nothing."""

from Support import *

load_plugin()
scene = make_scene()
view = make_view()
display = show(scene, view)
display.OpacityUnitDistance = 8.0
look_at(scene, view)
alone = picture(view, "alone")
opacity = simple.GetOpacityTransferFunction("value")
points = list(opacity.Points)


def free_of(name):
    """Pixels that the axes do not touch: black without the volume, which is there, but transparent."""
    opacity.Points = [0.0, 0.0, 0.5, 0.0, 1.0, 0.0, 0.5, 0.0]
    brightness = picture(view, name)[..., :3].max(axis=-1)
    opacity.Points = points
    rows, columns = brightness.shape
    padded = numpy.pad(brightness, 1)
    around = numpy.stack([padded[i:i + rows, j:j + columns] for i in range(3) for j in range(3)])
    return around.max(axis=0) < 0.01


def check(name):
    free = free_of("bare" + name)
    share = float(numpy.mean(free))
    assert 0.5 < share < 0.99, (name, share)
    both = picture(view, name)
    expect_alike(both[free], alone[free], 45.0, name)
    expect_different(both[~free], alone[~free], 35.0, name + ": the axes")


faults = []
for name, grid, switch in (("view", view.AxesGrid, "Visibility"), ("data", display.DataAxesGrid, "GridAxesVisibility")):
    setattr(grid, switch, 1)
    try:
        check(name)
    except AssertionError as fault:
        faults.append((name, fault))
    setattr(grid, switch, 0)
    expect_alike(picture(view, "without"), alone, 60.0, f"without the axes of the {name}")
assert not faults, faults
