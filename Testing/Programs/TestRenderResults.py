#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What exabricks-render makes beside one picture in bytes: pictures in floats, and one of each of several arrays.

Usage: TestRenderResults.py PROGRAM rt_medium.vthb   (with a display, or under xvfb-run)
"""

import json
import os
import struct
import subprocess
import sys
import tempfile
import unittest

import numpy

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

PROGRAM, DATA = "", ""

FINE, BAD_ARGUMENTS = 0, 2


def pixels(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())


def floats_of(path):
    """The pixels of a TIFF without compression, from the lowest row on. VTK 9.1 and Pillow read no four floats."""
    with open(path, "rb") as file:
        data = file.read()
    assert data[:4] == b"II*\0", data[:4]
    directory, = struct.unpack_from("<I", data, 4)
    tags = {}
    for i in range(struct.unpack_from("<H", data, directory)[0]):
        tag, kind, count, value = struct.unpack_from("<HHII", data, directory + 2 + 12 * i)
        code, size = {3: ("H", 2), 4: ("I", 4), 5: ("Q", 8)}[kind]
        place = value if count * size > 4 else directory + 10 + 12 * i
        tags[tag] = struct.unpack_from("<%d%s" % (count, code), data, place)
    width, height, samples = tags[256][0], tags[257][0], tags[277][0]
    assert tags[258] == (32,) * 4 and tags[339] == (3,) * 4, "floats of 32 bits"
    assert tags[259] == (1,) and tags[338] == (1,), "as they are, and premultiplied"
    strips = b"".join(data[at:at + size] for at, size in zip(tags[273], tags[279]))
    return numpy.frombuffer(strips, "<f4").reshape(height, width, samples)[::-1].reshape(-1, samples)


class RenderResultsTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        self.folder.cleanup()

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def files(self):
        return sorted(os.listdir(self.folder.name))

    def draw(self, *arguments, status=FINE):
        done = subprocess.run(
            [PROGRAM, DATA, *arguments, "--levels", "2", "--size", "64x48", "--quiet"],
            stderr=subprocess.PIPE, text=True, timeout=300, check=False)
        self.assertEqual(done.returncode, status, done.stderr)
        return done.stderr

    # Floats

    def test_floats_are_those_of_the_bytes(self):
        self.draw(self.path("a.png"))
        self.draw(self.path("a.tif"))
        bytes_of_png = pixels(self.path("a.png"))
        floats = floats_of(self.path("a.tif"))
        self.assertEqual(floats.shape, (64 * 48, 4))
        self.assertLess(abs(255.0 * floats[:, :3] - bytes_of_png[:, :3]).max(), 0.51)
        self.assertGreater(floats[:, 3].max(), 0.5)
        self.assertLessEqual(floats[:, 3].max(), 1.0)
        between = abs(255.0 * floats - (255.0 * floats).round()) > 0.01
        self.assertGreater(between.sum(), 500, "they are no bytes")
        self.assertEqual(self.files(), ["a.png", "a.tif"])

    def test_turntable_of_floats(self):
        self.draw(self.path("a.tiff"), "--turntable", "2")
        self.assertEqual(self.files(), ["a-0000.tiff", "a-0001.tiff"])

    def test_floats_are_of_the_volume_alone(self):
        for option, word in ((["--annotate"], "--annotate"), (["--background", "white"], "--background")):
            said = self.draw(self.path("a.tif"), *option, status=BAD_ARGUMENTS)
            self.assertIn(word, said)
            self.assertIn("alone", said)
        self.assertEqual(self.files(), [])

    # What nobody asks for

    def test_looks_fit_the_blend_mode(self):
        for asked, shaded, opacities in (
            (["maximum"], False, [0.0, 1.0]),
            (["average"], False, [1.0, 1.0]),
            (["isosurface", "--iso", "1.5"], True, [1.0, 1.0]),
            (["isosurface", "--iso", "1.2,1.8"], True, [0.5, 0.5]),  # those behind show through
            (["isosurface", "--iso", "1.5", "--no-shade"], False, [1.0, 1.0]),
        ):
            with self.subTest(asked):
                self.draw(self.path("a.png"), "--stats", self.path("s.json"), "-a", "density", "--blend-mode", *asked)
                with open(self.path("s.json"), encoding="utf-8") as file:
                    drawn = json.load(file)
                self.assertEqual(drawn["view"]["shaded"], shaded)
                self.assertEqual([opacity for _, opacity in drawn["picture"]["look"]["opacity"]], opacities)
                self.assertGreater(pixels(self.path("a.png"))[:, :3].max(), 50)

    def test_labels_of_axes_have_room(self):
        distances = []
        for options in ([], ["--annotate"]):
            self.draw(self.path("a.png"), "--stats", self.path("s.json"), *options)
            with open(self.path("s.json"), encoding="utf-8") as file:
                camera = json.load(file)["picture"]["camera"]
            distances.append(numpy.linalg.norm(numpy.subtract(camera["position"], camera["focal"])))
        self.assertAlmostEqual(distances[1] / distances[0], 1.3, delta=0.02)

    # Scenes

    def test_scene_keeps_shadows(self):
        self.draw(self.path("a.png"), "--shade", "--stats", self.path("s.json"))
        with open(self.path("s.json"), encoding="utf-8") as file:
            scene = json.load(file)
        scene["view"].update(scattering=2.0, shadow_reach=1.0)
        with open(self.path("s.json"), "w", encoding="utf-8") as file:
            json.dump(scene, file)
        self.draw(self.path("b.png"), "--scene", self.path("s.json"))
        self.assertGreater(abs(pixels(self.path("a.png")).astype(int) - pixels(self.path("b.png"))).max(), 30)

    # Several arrays

    def test_each_array_has_its_own_files(self):
        self.draw(self.path("a.png"), "-a", "magvort", "-a", "density", "--stats", self.path("s.json"))
        self.assertEqual(self.files(), ["a-density.png", "a-magvort.png", "s-density.json", "s-magvort.json"])
        with open(self.path("s-density.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["input"]["array"], "density")
        self.draw(self.path("alone.png"), "-a", "density")
        self.assertTrue((pixels(self.path("alone.png")) == pixels(self.path("a-density.png"))).all())
        self.assertFalse((pixels(self.path("alone.png")) == pixels(self.path("a-magvort.png"))).all())

    def test_nothing_is_drawn_if_one_is_not_there(self):
        said = self.draw(self.path("a.png"), "-a", "density", "-a", "magvrt", status=BAD_ARGUMENTS)
        self.assertIn("Did you mean 'magvort'", said)
        self.assertEqual(self.files(), [])

    def test_what_is_of_one_array_is_refused(self):
        said = self.draw(self.path("a.png"), "-a", "density", "-a", "magvort", "--component", "0", status=BAD_ARGUMENTS)
        self.assertIn("--component", said)
        said = self.draw(self.path("a.png"), "-a", "density", "-a", "density", status=BAD_ARGUMENTS)
        self.assertIn("a-density.png", said)


if __name__ == "__main__":
    PROGRAM, DATA = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1], verbosity=2)
