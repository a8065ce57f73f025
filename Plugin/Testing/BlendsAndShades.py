# SPDX-License-Identifier: BSD-3-Clause
"""Blend modes are those of plain VTK, and shading follows the view's lights."""

from Support import *

load_plugin()
collector = Collector()
scene = make_scene()
view = make_view()
display = show(scene, view)
look_at(scene, view)
display.OpacityUnitDistance = 8.0
flat = picture(view, "flat")

modes = ["Composite", "Maximum Intensity", "Minimum Intensity", "Average Intensity", "Additive"]
pictures = {}
for number, mode in enumerate(modes):
    display.BlendMode = mode
    pictures[mode] = picture(view, f"mode{number}")
    plain = plain_vtk_picture(view, f"plain{number}", 240, 180, display.OpacityUnitDistance, 0, number)
    expect_alike(pictures[mode], plain, 50.0, mode)
for mode in modes[1:]:
    assert decibel(pictures[mode], flat) < 35.0, mode

display.BlendMode = "Composite"
display.Shading = 1
shaded = picture(view, "shaded")
assert decibel(shaded, flat) < 35.0, decibel(shaded, flat)

# Of a medium, with shadows that it casts on itself: the headlight's are behind what is seen.
display.Diffuse = 1.0
display.VolumetricScatteringBlending = 2.0
scattered = picture(view, "scattered")
expect_different(scattered, shaded, 40.0, "scattered by a medium")
display.GlobalIlluminationReach = 1.0
shadowed = picture(view, "shadowed")
expect_different(shadowed, scattered, 40.0, "with shadows")
display.VolumeAnisotropy = 0.6
expect_different(picture(view, "onwards"), shadowed, 40.0, "scattered onwards")
display.VolumeAnisotropy = 0.0
expect_alike(picture(view, "shadowedAgain"), shadowed, 60.0, "shadows again")
display.GlobalIlluminationReach = 0.0
display.VolumetricScatteringBlending = 0.0
display.Shading = 0
expect_alike(picture(view, "flatAgain"), flat, 60.0, "without shading again")
collector.expect_silence()
