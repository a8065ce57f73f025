# SPDX-License-Identifier: BSD-3-Clause
"""Beside other things: opaque geometry inside the volume, several views with linked cameras, transparent background."""

from Support import *

load_plugin()
scene = make_scene()
view = make_view()
display = show(scene, view)
display.OpacityUnitDistance = 8.0
look_at(scene, view)
alone = picture(view, "alone")

# An opaque ball in the middle hides what is behind it, and the volume in front of it shows.
bounds = scene.GetDataInformation().GetBounds()
ball = simple.Sphere(Center=view.CameraFocalPoint, Radius=0.15 * (bounds[1] - bounds[0]))
ball.ThetaResolution = ball.PhiResolution = 64
ballDisplay = simple.Show(ball, view)
ballDisplay.ColorArrayName = ["POINTS", ""]
ballDisplay.AmbientColor = ballDisplay.DiffuseColor = [0.0, 1.0, 0.0]
both = picture(view, "both")
simple.Hide(scene, view)
bare = picture(view, "bare")
simple.Show(scene, view)
middle = bare[90, 120]
assert middle[1] > 0.5 and middle[0] < 0.1, middle
covered = bare[..., 1] > 0.3
expect_different(both[covered], bare[covered], 30.0, "the volume before the ball")
expect_different(both[covered], alone[covered], 30.0, "the ball in the volume")
expect_alike(both[~(bare.max(axis=-1) > 0.0)], alone[~(bare.max(axis=-1) > 0.0)], 60.0, "beside the ball")

# Between the camera and the volume it hides what is behind it.
ball.Center = [0.5 * (view.CameraPosition[i] + view.CameraFocalPoint[i]) for i in range(3)]
before = picture(view, "before")
simple.Hide(scene, view)
bare = picture(view, "bareBefore")
simple.Show(scene, view)
covered = bare[..., 1] > 0.3
expect_different(alone[covered], bare[covered], 20.0, "the volume where the ball will be")
expect_alike(before[covered], bare[covered], 60.0, "the ball before the volume")
ball.Center = view.CameraFocalPoint

# Translucent geometry: see DrawsBesideTranslucent.py.
simple.Delete(ball)
expect_alike(picture(view, "ballGone"), alone, 60.0, "without the ball")

# Transparent background: the colors over black are those of the opaque picture.
clear = picture(view, "clear", TransparentBackground=1)
assert clear.shape[-1] == 4
alpha = clear[..., 3]
assert alpha.min() == 0.0 and 0.3 < alpha.max() <= 1.0, (alpha.min(), alpha.max())
assert numpy.mean((alpha > 0.0) & (alpha < 0.9)) > 0.05, "see-through where the volume is thin"
inside = alpha > 0.2
expect_alike((clear[..., :3] * clear[..., 3:])[inside], alone[inside], 30.0, "transparent background over black")

# A second view of the same camera, and then of another one.
second = make_view()
show(scene, second).OpacityUnitDistance = 8.0
simple.AddCameraLink(view, second, "linked")
simple.SetActiveView(view)
look_at(scene, view)
simple.Render(view)
simple.Render(second)
expect_alike(picture(second, "second"), picture(view, "again"), 50.0, "linked views")
view.CameraPosition = [2.0 * view.CameraFocalPoint[i] - view.CameraPosition[i] for i in range(3)]
simple.Render(view)
behind = picture(view, "behind")
expect_different(behind, alone, 30.0, "from behind")
expect_alike(picture(second, "secondBehind"), behind, 50.0, "linked views from behind")
simple.RemoveCameraLink("linked")
look_at(scene, second)
expect_alike(picture(second, "unlinked"), alone, 50.0, "no longer linked")
