# SPDX-License-Identifier: BSD-3-Clause
"""In stereo each eye sees the opaque volume where it sees the surface of the same data."""

from Support import *

load_plugin()
scene = make_scene()
view = make_view()
display = show(scene, view)
look_at(scene, view)
color = simple.GetColorTransferFunction("value")
color.RGBPoints = [0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0]
opacity = simple.GetOpacityTransferFunction("value")
opacity.Points = [0.0, 1.0, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0]
display.Ambient, display.Diffuse = 1.0, 0.0  # of the surface
simple.Render(view)
view.GetActiveCamera().SetEyeAngle(6.0)


def eye(kind):
    """The mask of what is drawn, of the volume and of the surface."""
    view.StereoRender = 1
    view.StereoType = kind
    masks = []
    for representation in ("ExaBricks", "Surface"):
        display.SetRepresentationType(representation)
        masks.append(picture(view, kind + representation)[..., 0] > 0.5)
    display.SetRepresentationType("ExaBricks")
    return masks


# VTK's surfaces have the last eye for one more picture when stereo begins with the left one.
eye("Right")
masks = {kind: eye(kind) for kind in ("Left", "Right")}
for kind, (volume, surface) in masks.items():
    assert 0.05 < surface.mean() < 0.9, (kind, surface.mean())
    off = float((volume != surface).mean())
    print(f"{kind}: {100 * off:.2f} % of the pixels differ from the surface's")
    assert off < 0.005, (kind, off)
apart = float((masks["Left"][0] != masks["Right"][0]).mean())
assert apart > 0.01, apart
