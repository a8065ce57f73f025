# SPDX-License-Identifier: BSD-3-Clause
"""Translucent geometry before, inside and behind the volume is blended with it in the order of depth.

ParaView peels the depth of translucent geometry, and of volumes with it.
"""

import subprocess
import sys

from Support import *

load_plugin()
scene = make_scene()
view = make_view()
display = show(scene, view)
display.OpacityUnitDistance = 8.0
look_at(scene, view)
alone = picture(view, "alone")
alpha = picture(view, "alpha", TransparentBackground=1)[..., 3:]

# A ball of one color, of which only the front is drawn: a single layer.
bounds = scene.GetDataInformation().GetBounds()
size = max(bounds[2 * i + 1] - bounds[2 * i] for i in range(3))
half_diagonal = 0.5 * math.sqrt(sum((bounds[2 * i + 1] - bounds[2 * i]) ** 2 for i in range(3)))
focus = numpy.array(view.CameraFocalPoint)
forth = focus - numpy.array(view.CameraPosition)
forth /= numpy.linalg.norm(forth)
ball = simple.Sphere(ThetaResolution=64, PhiResolution=64)
ballDisplay = simple.Show(ball, view)
ballDisplay.ColorArrayName = ["POINTS", ""]
ballDisplay.AmbientColor = ballDisplay.DiffuseColor = [0.0, 1.0, 0.0]
ballDisplay.Ambient, ballDisplay.Diffuse, ballDisplay.Specular = 1.0, 0.0, 0.0
ballDisplay.BackfaceRepresentation = "Cull Backface"
GREEN = numpy.array([0.0, 1.0, 0.0])


def place(depth, radius):
    """`depth` is along the line of sight, from the middle of the data."""
    ball.Center = [float(x) for x in focus + depth * forth]
    ball.Radius = radius


def masks(name):
    """Pixels that the ball covers wholly, and pixels that it does not touch."""
    simple.Hide(scene, view)
    ballDisplay.Opacity = 1.0
    green = picture(view, name)[..., 1]
    simple.Show(scene, view)
    ballDisplay.Opacity = 0.5
    rows, columns = green.shape
    padded = numpy.pad(green, 1, mode="edge")
    around = numpy.stack([padded[i:i + rows, j:j + columns] for i in range(3) for j in range(3)])
    return around.min(axis=0) > 0.99, around.max(axis=0) < 0.01


radius = 0.08 * size
cases = {
    "before": (-half_diagonal - 1.1 * radius, radius),
    "near": (0.0, 0.15 * size),
    "inside": (0.1 * size, 0.15 * size),
    "far": (0.2 * size, 0.15 * size),
    "behind": (half_diagonal + 0.33 * size, 0.3 * size),
}
second_run = "second" in sys.argv
found = {}
covers = {}
for name, (depth, radius) in cases.items():
    place(depth, radius)
    # In both runs, as the near plane, and with it the precision of depth, depends on the picture before.
    covers[name] = masks("bare" + name + "Second" * second_run)
    found[name] = picture(view, name + "Second" * second_run)
if second_run:
    # pvpython may end with errors of its own.
    sys.stdout.flush()
    os._exit(0)

faults = []


def check(condition, what):
    """Collects what is wrong, to tell all of it."""
    print(("" if condition else "WRONG: ") + what)
    if not condition:
        faults.append(what)


subprocess.run([os.environ["EXABRICKS_PVPYTHON"], os.path.abspath(__file__), "second"], check=True)
for name in cases:
    again = read_picture(name + "Second.png")
    check(numpy.array_equal(found[name], again), f"{name}: two runs, {decibel(found[name], again):.1f} dB, expected the same")

for name, (covered, free) in covers.items():
    assert covered.sum() > 400 and free.sum() > 400, (name, covered.sum(), free.sum())
    likeness = decibel(found[name][free], alone[free])
    check(likeness >= 45.0, f"{name}: where the ball is not, {likeness:.1f} dB, at least 45")

covered = covers["before"][0]
likeness = decibel(found["before"][covered], (0.5 * GREEN + 0.5 * alone)[covered])
check(likeness >= 35.0, f"the ball over the volume: {likeness:.1f} dB, at least 35")
covered = covers["behind"][0]
likeness = decibel(found["behind"][covered], (alone + (1.0 - alpha) * 0.5 * GREEN)[covered])
check(likeness >= 35.0, f"the volume over the ball: {likeness:.1f} dB, at least 35")

# Inside, the ball takes half of the red of what is behind it, and no more: the deeper it is, the less.
covered = covers["near"][0] & covers["inside"][0] & covers["far"][0] & (alone[..., 0] > 0.2)
assert covered.sum() > 200, covered.sum()
red = {name: found[name][covered][:, 0] for name in ("near", "inside", "far")}
whole = alone[covered][:, 0]
for name in red:
    between = numpy.mean((red[name] >= 0.5 * whole - 0.02) & (red[name] <= whole + 0.02))
    check(between > 0.99, f"{name}: {100 * between:.1f} % between the ball over the volume and under it, at least 99")
means = [float(numpy.mean(0.5 * whole)), *(float(numpy.mean(red[name])) for name in ("near", "inside", "far")),
         float(numpy.mean(whole))]
check(all(a + 0.005 < b for a, b in zip(means, means[1:])), f"less red is lost with depth: {means}")

# The same picture as before when the ball is gone.
simple.Delete(ball)
likeness = decibel(picture(view, "ballGone"), alone)
check(likeness >= 60.0, f"without the ball: {likeness:.1f} dB, at least 60")
assert not faults, faults
