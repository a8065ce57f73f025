# SPDX-License-Identifier: BSD-3-Clause
"""Exporters of scenes write surfaces: that they leave the volume out is said. A PDF has its picture."""

import re
import shutil

from Support import *

load_plugin()
collector = Collector()
scene = make_scene()
view = make_view()
display = show(scene, view)
display.OpacityUnitDistance = 8.0
look_at(scene, view)
simple.Render(view)


def export(extension):
    name = "scene." + extension
    # An earlier run's: a file, or a folder.
    if os.path.isdir(name):
        shutil.rmtree(name)
    elif os.path.exists(name):
        os.remove(name)
    simple.ExportView(os.path.abspath(name), view=view)
    assert os.path.getsize(name) > 0, name


for extension in ("gltf", "x3d", "x3db", "vrml", "pov", "vtkjs"):
    export(extension)
    collector.expect_said("writes surfaces, no volumes", "screenshot")

# An outline is lines, and a hidden volume is not missed.
display.SetRepresentationType("Outline")
export("gltf")
display.SetRepresentationType("ExaBricks")
simple.Hide(scene, view)
export("gltf")
collector.expect_silence()
simple.Show(scene, view)


# Vector formats are pictures of three-dimensional views.
shown = picture(view, "shown")
export("pdf")
found = re.search(rb"/Width 240\s*/Height 180.*?stream\r?\n(.{129600})", open("scene.pdf", "rb").read(), re.DOTALL)
assert found, "a picture of 240 x 180 pixels in the PDF"
pixels = numpy.frombuffer(found.group(1), numpy.uint8).reshape(180, 240, 3)[::-1] / 255.0
assert drawn(shown) > 0.05, drawn(shown)
expect_alike(pixels, shown, 40.0, "PDF")
collector.expect_silence()
