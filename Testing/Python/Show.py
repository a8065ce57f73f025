# SPDX-License-Identifier: BSD-3-Clause
"""A first look in one call: show() returns a picture where nobody sits before a screen."""

import os
import subprocess
import sys
import tempfile

try:
    import numpy
except ImportError:
    print("takes numpy (Debian: python3-numpy)")
    sys.exit(125)

import exabricks

DATA = os.path.join(sys.argv[sys.argv.index("-D") + 1], "rt_medium", "rt_medium.vthb")

# Colors, opacities and camera are chosen from the data.
picture = exabricks.show(DATA, "magvort", size=(160, 120), interactive=False)
assert picture.pixels.shape == (120, 160, 3) and picture.pixels.dtype == numpy.uint8
drawn = picture.pixels.max(axis=-1) > 25
assert 0.1 < drawn.mean() < 0.8, drawn.mean()
assert picture.pixels.max() > 120
columns = numpy.flatnonzero(drawn.any(axis=0))
assert abs(columns[0] + columns[-1] - 159) < 30, "what shows is in the middle"
assert picture._repr_png_()[:4] == b"\x89PNG", "a notebook shows it"
with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, "picture.png")
    picture.save(path)
    assert os.path.getsize(path) > 1000

# Of data that are there already; density is preferred, and the camera can be moved.
amr = exabricks.read(DATA)
scene = exabricks.VolumeScene(amr, size=(80, 60))
assert scene.array == "density" and not scene.log
whole = scene.picture().pixels.astype(int)
scene.camera.Azimuth(40.0)
assert numpy.abs(scene.picture().pixels.astype(int) - whole).max() > 30
assert exabricks.show(scene, interactive=False, size=(40, 30)).pixels.shape == (30, 40, 3)
coarse = exabricks.VolumeScene(DATA, "magvort", levels=1)
assert coarse.data.GetNumberOfLeafCells() == 24 * 24 * 48
assert exabricks.VolumeScene(DATA, "magvort", log=True).log

# Opacities that were chosen are chosen anew for another way of blending, and those that somebody set stay.
scene.blend_mode = "maximum"
low, high = scene.color_range
assert scene.opacity == [(low, 0.0), (high, 1.0)], scene.opacity
scene.opacity = [(low, 0.5), (high, 0.25)]
scene.blend_mode = "average"
assert scene.opacity == [(low, 0.5), (high, 0.25)], scene.opacity
scene.blend_mode = "composite"

# So it is in a scene that was kept.
chosen = coarse.opacity
coarse.blend_mode = "maximum"
again = exabricks.VolumeScene(DATA, "magvort", levels=1)
again.apply(coarse.to_dict())
assert again.blend_mode == "maximum" and again.opacity == coarse.opacity != chosen
again.blend_mode = "composite"
assert again.opacity == chosen

# What does not fit is said.
for wrong, words in (
    (lambda: exabricks.show("no-such.vthb"), (exabricks.ReadError, "no-such.vthb")),
    (lambda: exabricks.show(DATA, "pressure"), (ValueError, "'pressure'")),
    (lambda: exabricks.show(amr, "pressure"), (ValueError, "magvort")),
    (lambda: exabricks.show(amr, "density", component=1), (ValueError, "component")),
    (lambda: exabricks.show(amr, "density", color_map="rainbow"), (ValueError, "viridis")),
    (lambda: exabricks.show(amr, levels=1), (ValueError, "SetLevelRange")),
    (lambda: exabricks.show(scene, "density"), (ValueError, "set_array")),
    (lambda: setattr(scene, "blend_mode", "mip"), (ValueError, "maximum")),
):
    try:
        wrong()
        raise AssertionError(words)
    except words[0] as error:
        assert words[1] in str(error), error

# Without a display: VTK before 9.4 needs an X server, which is started unless there is none to start.
# The second picture is one too, and a viewer is refused.
script = f"""
import exabricks
for _ in range(2):
    picture = exabricks.show({DATA!r}, 'magvort', size=(40, 30))
try:
    exabricks.show({DATA!r}, 'magvort', interactive=True)
except RuntimeError as error:
    assert "display" in str(error)
    print(picture.pixels.max())
"""
environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
done = subprocess.run([sys.executable, "-c", script], env=environment, capture_output=True, text=True, check=False)
assert done.returncode == 0 and int(done.stdout) > 100, (done.stdout, done.stderr)
