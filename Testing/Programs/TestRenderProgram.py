#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""exabricks-render: what it writes, and what it says to input that is wrong.

Usage: TestRenderProgram.py PROGRAM rt_medium.vthb   (with a display, or under xvfb-run)
"""

import base64
import json
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

import AMRFiles

PROGRAM, DATA = "", ""

FINE, RENDERING_FAILED, BAD_ARGUMENTS, INPUT_UNREADABLE, OUTPUT_UNWRITABLE = range(5)


def png_size(path):
    with open(path, "rb") as file:
        head = file.read(24)
    assert head[:8] == b"\x89PNG\r\n\x1a\n", "not a PNG: %r" % head
    return struct.unpack(">II", head[16:24])


def write(folder, name, text):
    path = os.path.join(folder, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="ascii") as file:
        file.write(text)
    return path


def write_vthb(folder, cells):
    """A .vthb with one block of so many cells along each axis, all in a few bytes: what it says fits together."""
    data = base64.b64encode(struct.pack("<4Q", 1, 4 * cells**3, 0, 8)) + base64.b64encode(bytes(8))
    write(folder, "block.vti", """<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64"
        compressor="vtkZLibDataCompressor"><ImageData WholeExtent="0 {0} 0 {0} 0 {0}" Origin="0 0 0" Spacing="1 1 1">
        <Piece Extent="0 {0} 0 {0} 0 {0}"><PointData></PointData><CellData>
        <DataArray type="Float32" Name="density" format="binary">{1}</DataArray>
        </CellData></Piece></ImageData></VTKFile>""".format(cells, data.decode()))
    return write(folder, "data.vthb", """<VTKFile type="vtkOverlappingAMR" version="1.1" byte_order="LittleEndian">
        <vtkOverlappingAMR origin="0 0 0" grid_description="XYZ"><Block level="0" spacing="1 1 1">
        <DataSet index="0" amr_box="0 {0} 0 {0} 0 {0}" file="block.vti"/>
        </Block></vtkOverlappingAMR></VTKFile>""".format(cells - 1))


def write_plotfile(folder, blocks):
    """The header of an AMReX plotfile of one level of 4^3 cells, which says so many blocks."""
    write(folder, "Header", """HyperCLaw-V1.1
        1
        density
        3 0 0
        0 0 0 1 1 1
        ((0,0,0) (3,3,3) (0,0,0))
        0 0.25 0.25 0.25 0 0
        0 {0} 0 0 0 1 0 1 0 1
        Level_0/Cell""".format(blocks))
    return folder


class RenderProgramTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.png = os.path.join(self.folder.name, "picture.png")

    def tearDown(self):
        self.folder.cleanup()

    def run_program(self, *arguments, **keywords):
        return subprocess.run(
            [PROGRAM, *arguments], capture_output=True, text=True, timeout=300, check=False, **keywords
        )

    def refused(self, code, words, *arguments, **keywords):
        """The run ends with the code and one message that has the words in it; nothing is left behind."""
        done = self.run_program(*arguments, **keywords)
        self.assertEqual(done.returncode, code, done.stderr)
        message = done.stderr[done.stderr.index("exabricks-render: "):]
        for word in words:
            self.assertIn(word, message)
        self.assertEqual(os.listdir(self.folder.name), [])

    # Arguments

    def test_nothing_given(self):
        self.refused(BAD_ARGUMENTS, ["input", "--help"])

    def test_unknown_option(self):
        self.refused(BAD_ARGUMENTS, ["--colour", "--help"], DATA, self.png, "--colour", "x")

    def test_no_output(self):
        self.refused(BAD_ARGUMENTS, ["No output", "picture.png"], DATA)

    def test_output_of_another_kind(self):
        self.refused(BAD_ARGUMENTS, [".png", "a.gif"], DATA, "a.gif")

    def test_opacity_points(self):
        for points in ("1", "1:x", "0:0,1:2", "1:0,0:1", "0:0,", "0:nan", "0:0:0"):
            with self.subTest(points):
                self.refused(BAD_ARGUMENTS, ["--opacity takes"], DATA, self.png, "--opacity", points)

    def test_values_of_other_options(self):
        for option, value in (
            ("--size", "800"),
            ("--size", "0x600"),
            ("--size", "800x600x3"),
            ("--background", "no such colour"),
            ("--background", "0,0,2"),
            ("--position", "1,2"),
            ("--view", "left"),
            ("--color-map", "rainbow"),
            ("--component", "-1"),
            ("--component", "x"),
            ("--levels", "0"),
            ("--zoom", "0"),
            ("--zoom", "nan"),
            ("--view-angle", "nan"),
            ("--step-scale", "nan"),
            ("--step-scale", "1e9"),
            ("--error-tolerance", "nan"),
            ("--opacity-unit", "inf"),
            ("--frames", "many"),
            ("--traversal", "fast"),
            ("--iso", "1,x"),
        ):
            with self.subTest(option=option, value=value):
                self.refused(BAD_ARGUMENTS, [option], DATA, self.png, option, value)

    def test_range(self):
        self.refused(BAD_ARGUMENTS, ["--range"], DATA, self.png, "--range", "2", "1")
        self.refused(BAD_ARGUMENTS, ["above zero"], DATA, self.png, "--log", "--range", "0", "1")

    def test_two_ways_to_place_the_camera(self):
        self.refused(BAD_ARGUMENTS, ["--view", "--position"],
            DATA, self.png, "--view", "+x", "--position", "1,2,3")

    def test_two_ways_to_choose_steps(self):
        self.refused(BAD_ARGUMENTS, ["--step-scale", "--error-tolerance"],
            DATA, self.png, "--step-scale", "0.5", "--error-tolerance", "0.01")

    def test_unknown_array_lists_those_there_are(self):
        self.refused(BAD_ARGUMENTS, ["'nothing'", "density", "magvort"],
            DATA, self.png, "--array", "nothing")
        self.refused(BAD_ARGUMENTS, ["Did you mean 'density'?"], DATA, self.png, "--array", "Densty")
        self.refused(BAD_ARGUMENTS, ["Did you mean 'viridis'?"], DATA, self.png, "--color-map", "virdis")

    def test_component_of_a_scalar(self):
        self.refused(BAD_ARGUMENTS, ["--component 1", "density"],
            DATA, self.png, "--array", "density", "--component", "1")

    # Input

    def test_missing_input(self):
        self.refused(INPUT_UNREADABLE, ["no_such.vthb"], "no_such.vthb", self.png)

    def test_folder_that_is_no_plotfile(self):
        self.refused(INPUT_UNREADABLE, ["Header", "Did you mean", "rt_medium.vthb"], os.path.dirname(DATA), self.png)

    def test_file_of_unknown_kind(self):
        self.refused(INPUT_UNREADABLE, [".vthb", ".hierarchy"], __file__, self.png)

    def test_broken_file(self):
        for name, text in (
            ("broken.vthb", "<VTKFile type='vtkOverlappingAMR' version='1.1'><vtkOverl"),
            ("broken.hierarchy", "hello"),
            ("broken.hdf5", "hello"),
            ("broken.vtkhdf", "hello"),
            ("Header", "hello"),
        ):
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, name)
                with open(path, "w", encoding="ascii") as file:
                    file.write(text)
                self.refused(INPUT_UNREADABLE, [name],
                    folder if name == "Header" else path, self.png)

    def test_missing_block(self):
        with tempfile.TemporaryDirectory() as folder:
            copy = os.path.join(folder, "rt")
            shutil.copytree(os.path.dirname(DATA), copy)
            os.remove(os.path.join(copy, "rt_medium", "rt_medium_7.vti"))
            path = os.path.join(copy, os.path.basename(DATA))
            self.refused(INPUT_UNREADABLE, ["rt_medium_7.vti"], path, self.png)

    def test_damaged_files(self):
        for name, write_whole, file, old, new, words in (
            ("an AMReX plotfile", AMRFiles.write_plotfile, "Level_1/Cell_H", "(11,11,11)", "(11,99,11)", ["is damaged: "]),
            ("a 2-D one", AMRFiles.write_plotfile, "Header", "\n3\n0.5", "\n2\n0.5", ["is damaged, or of a kind that is not read: "]),
            ("Enzo", AMRFiles.write_enzo, "data0003.hierarchy", "= 10 10 10", "= 10 10 1", ["is damaged: ", "'data0003.hierarchy'"]),
            (".vthb", AMRFiles.write_vthb, "data/data_1.vti", "0 4 0 8", "0 4 0 9", ["is damaged: ", "'data/data_1.vti'"]),
        ):
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                path = write_whole(os.path.join(folder, "whole"))
                damaged = os.path.join(folder, "whole", file)
                with open(damaged, encoding="latin-1", newline="") as text:
                    whole = text.read()
                self.assertIn(old, whole)
                with open(damaged, "w", encoding="latin-1", newline="") as text:
                    text.write(whole.replace(old, new, 1))
                self.refused(INPUT_UNREADABLE, [str(path), "expected", "Copy it anew", *words], path, self.png)

    def test_header_that_says_more_than_fits_into_memory(self):
        # The sanitizers would end the program where memory runs out; VTK's readers lose what they had when they throw.
        options = os.environ.get("ASAN_OPTIONS", "") + ":allocator_may_return_null=1:detect_leaks=0"
        env = dict(os.environ, ASAN_OPTIONS=options)
        for name, make, words in (
            ("2^60 cells", lambda folder: write_vthb(folder, 2**20), ["memory", "header", "copied whole", "--levels"]),
            ("-1 blocks", lambda folder: write_plotfile(folder, -1), ["is damaged", "number of boxes", "-1", "'Header'"]),
        ):
            for option in ([], ["--list-arrays"]):
                with self.subTest(name, option=option), tempfile.TemporaryDirectory() as folder:
                    path = make(folder)
                    self.refused(INPUT_UNREADABLE, [path, *words], path, self.png, *option, env=env)

    # Output

    def test_output_in_a_folder_that_is_not_there(self):
        for option in ([], ["--stats", os.path.join(self.folder.name, "none", "a.json")]):
            with self.subTest(option):
                png = self.png if option else os.path.join(self.folder.name, "none", "a.png")
                self.refused(OUTPUT_UNWRITABLE, ["none"], DATA, png, *option)

    @unittest.skipIf(hasattr(os, "geteuid") and os.geteuid() == 0, "root may write everywhere")
    def test_output_in_a_folder_that_may_not_be_written_in(self):
        os.chmod(self.folder.name, 0o500)
        self.refused(OUTPUT_UNWRITABLE, [self.png], DATA, self.png)

    @unittest.skipUnless(sys.platform.startswith("linux"), "asks for an X server that is not there")
    def test_no_display(self):
        done = self.run_program(DATA, self.png, env=dict(os.environ, DISPLAY=":987654"))
        # VTK from 9.4 on draws without one.
        self.assertIn(done.returncode, (FINE, RENDERING_FAILED), done.stderr)
        if done.returncode == RENDERING_FAILED:
            self.assertIn("xvfb-run", done.stderr)
            self.assertEqual(os.listdir(self.folder.name), [])

    @unittest.skipUnless(shutil.which("Xvfb"), "asks for an X server without GLX")
    def test_display_without_glx(self):
        number, number_end = os.pipe()
        server = subprocess.Popen(
            ["Xvfb", "-extension", "GLX", "-displayfd", str(number_end)],
            pass_fds=[number_end], stderr=subprocess.DEVNULL
        )
        try:
            os.close(number_end)
            with open(number, encoding="ascii") as file:
                display = ":" + file.readline().strip()
            done = self.run_program(DATA, self.png, "--levels", "1", env=dict(os.environ, DISPLAY=display))
        finally:
            server.terminate()
            server.wait()
        self.assertIn(done.returncode, (FINE, RENDERING_FAILED), done.stderr)
        if done.returncode == RENDERING_FAILED:
            self.assertIn("GLX", done.stderr)
            self.assertIn("xvfb-run", done.stderr)
            self.assertEqual(os.listdir(self.folder.name), [])

    def test_unknown_device(self):
        self.refused(RENDERING_FAILED, ["no such device"],
            DATA, self.png, "--device", "no such device")

    # Good runs

    def test_help_and_version(self):
        done = self.run_program("--help")
        self.assertEqual(done.returncode, FINE)
        for word in ("--opacity", "--array", "Examples", "Exit codes"):
            self.assertIn(word, done.stdout)
        done = self.run_program("--version")
        self.assertEqual(done.returncode, FINE)
        self.assertRegex(done.stdout, r"^exabricks-render \d+\.\d+\.\d+ \(VTK \d+\.\d+")

    def test_list_arrays(self):
        done = self.run_program(DATA, "--list-arrays")
        self.assertEqual(done.returncode, FINE, done.stderr)
        self.assertEqual([line.split()[0] for line in done.stdout.splitlines()], ["density", "magvort"])
        for line in done.stdout.splitlines():
            self.assertRegex(line, r"^\S+  \S+ to \S+ on the coarsest level$")

    def draw(self, *arguments):
        stats = os.path.join(self.folder.name, "stats.json")
        done = self.run_program(DATA, self.png, "--size", "96x64", "--stats", stats, *arguments)
        self.assertEqual(done.returncode, FINE, done.stderr)
        self.assertEqual(png_size(self.png), (96, 64))
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["picture.png", "stats.json"])
        with open(stats, encoding="utf-8") as file:
            return done, json.load(file)

    def test_picture_and_statistics(self):
        done, stats = self.draw("--array", "magvort", "--frames", "3")
        for line in ("Input", "Array", "Bricks", "Device", "Set-up", "Frame", "Memory", "Picture"):
            self.assertRegex(done.stdout, "(?m)^%s +" % line)

        data = stats["data"]
        self.assertEqual(data["levels"], 3)
        self.assertEqual(data["blocks"], 25)
        self.assertEqual(data["leaf_cells"], 549120)
        self.assertEqual(data["absent_cells"], 0)
        self.assertGreater(data["bricks"], 0)
        self.assertGreater(data["regions"], 0)
        for value, expected in zip(data["bounds"], (0, 0.5, 0, 0.5, 0, 1)):
            self.assertAlmostEqual(value, expected, 9)
        for value in data["finest_spacing"]:
            self.assertAlmostEqual(value, 1 / 192, 9)

        self.assertEqual(stats["input"]["array"], "magvort")
        self.assertEqual(stats["input"]["other_arrays"], ["density"])
        self.assertEqual(stats["picture"]["size"], [96, 64])
        look = stats["picture"]["look"]
        self.assertEqual(look["color_range"], data["range"])
        self.assertEqual(look["opacity"][0], [data["range"][0], 0.0])
        # Of the rings alone, which lie in the middle of the data's height.
        self.assertLess(look["opacity_unit"], 0.8 * 1.5**0.5 / 100)
        self.assertGreater(look["opacity_unit"], 0.4 * 1.5**0.5 / 100)
        self.assertAlmostEqual(stats["picture"]["camera"]["focal"][2], 0.44, 1)
        self.assertTrue(stats["method"]["device"])
        self.assertGreater(stats["method"]["active_regions"], 0)
        self.assertEqual(len(stats["seconds"]["frames"]), 3)
        self.assertEqual(stats["seconds"]["frame_median"], sorted(stats["seconds"]["frames"])[1])
        self.assertGreater(stats["bytes"]["host"], 0)

    def test_enzo_in_the_current_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            path = AMRFiles.write_enzo(os.path.join(folder, "whole"))
            done = self.run_program(path.name, "--list-arrays", cwd=path.parent)
        self.assertEqual(done.returncode, FINE, done.stderr)
        self.assertEqual(done.stdout.split()[0], "Density")

    def test_first_array_is_taken(self):
        done, stats = self.draw()
        self.assertEqual(stats["input"]["array"], "density")
        self.assertIn("others: magvort", done.stdout)
        self.assertIsNone(stats["seconds"]["frame_median"])

    def test_levels(self):
        _, stats = self.draw("--levels", "1")
        self.assertEqual(stats["data"]["blocks"], 1)
        self.assertEqual(stats["data"]["leaf_cells"], 24 * 24 * 48)

    def test_logarithm(self):
        _, stats = self.draw("-a", "magvort", "--log", "--range", "0.01", "10",
            "--opacity", "0.1:0,10:0.5")
        self.assertEqual(stats["picture"]["look"]["color_range"], [-2.0, 1.0])
        self.assertEqual(stats["picture"]["look"]["opacity"], [[-1.0, 0.0], [1.0, 0.5]])
        self.assertLess(stats["data"]["range"][0], -4.0)
        self.assertGreater(stats["data"]["range"][1], 1.0)

    def test_logarithm_where_it_shows_more(self):
        """Nine of ten cells have less than a hundredth of the greatest value."""
        with tempfile.TemporaryDirectory() as folder:
            values = [10.0 ** (6.0 * (i / 63.0) ** 6) for i in range(64)]
            path = write_vthb(folder, 4)
            write(folder, "block.vti", """<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian">
                <ImageData WholeExtent="0 4 0 4 0 4" Origin="0 0 0" Spacing="1 1 1">
                <Piece Extent="0 4 0 4 0 4"><CellData>
                <DataArray type="Float64" Name="density" format="ascii">%s</DataArray>
                </CellData></Piece></ImageData></VTKFile>""" % " ".join(map(str, values)))
            stats = os.path.join(folder, "stats.json")
            for options, log in (([], True), (["--linear"], False), (["--range", "1", "10"], False)):
                with self.subTest(options):
                    done = self.run_program(path, self.png, "--size", "32x32", "--stats", stats, *options)
                    self.assertEqual(done.returncode, FINE, done.stderr)
                    self.assertEqual("--linear draws" in done.stdout, log)
                    with open(stats, encoding="utf-8") as file:
                        self.assertEqual(json.load(file)["input"]["log10"], log)
            os.remove(self.png)
            self.refused(BAD_ARGUMENTS, ["--log", "--linear"], path, self.png, "--log", "--linear")

    def test_array_that_varies_is_preferred_and_covered_cells_are_hidden(self):
        with tempfile.TemporaryDirectory() as folder:
            path = write_vthb(folder, 2)
            arrays = {"constant": [7.0] * 8, "flow": [1, 2, 3, 4, 5, 6, 7, 0], "vfrac": [1] * 7 + [0]}
            text = "".join('<DataArray type="Float32" Name="%s" format="ascii">%s</DataArray>'
                % (name, " ".join(map(str, values))) for name, values in arrays.items())
            write(folder, "block.vti", """<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian">
                <ImageData WholeExtent="0 2 0 2 0 2" Origin="0 0 0" Spacing="1 1 1">
                <Piece Extent="0 2 0 2 0 2"><CellData>%s</CellData></Piece></ImageData></VTKFile>""" % text)
            stats = os.path.join(folder, "stats.json")
            done = self.run_program(path, self.png, "--size", "32x32", "--stats", stats)
            self.assertEqual(done.returncode, FINE, done.stderr)
            with open(stats, encoding="utf-8") as file:
                found = json.load(file)
            self.assertEqual(found["input"]["array"], "flow")
            self.assertEqual(found["data"]["range"], [1.0, 7.0])
            self.assertEqual(found["data"]["absent_cells"], 1)

    def test_camera(self):
        _, stats = self.draw("--position", "0.25,-2,0.5", "--focal", "0.25,0.25,0.5", "--parallel",
            "--opacity", "1:0,2:0.1")
        camera = stats["picture"]["camera"]
        self.assertEqual(camera["position"], [0.25, -2.0, 0.5])
        self.assertEqual(camera["up"], [0.0, 0.0, 1.0])
        self.assertTrue(camera["parallel"])
        self.assertAlmostEqual(camera["parallel_scale"], 0.5 * 1.05, 9)

    def test_views_that_begin_with_a_dash(self):
        _, stats = self.draw("--view", "-x")
        self.assertLess(stats["picture"]["camera"]["position"][0], 0.0)

    def test_error_tolerance(self):
        done, stats = self.draw("--array", "magvort", "--error-tolerance", "0.05")
        self.assertEqual(stats["method"]["error_tolerance"], 0.05)
        self.assertGreater(stats["method"]["levels_left_out"], 0)
        self.assertRegex(done.stdout, "(?m)^Left out +")
        _, stats = self.draw("--array", "magvort", "--error-tolerance", "0.0001")
        self.assertEqual(stats["method"]["levels_left_out"], 0)

    def test_rays(self):
        """Of a picture that is large enough, a tolerance lets pixels be predicted; nothing else does."""
        rays = "(?m)^Rays +[0-9]+ of 90000 pixels"
        for asked, said in ((["--error-tolerance", "0.02"], True), ([], False),
                            (["--opacity", "0:0,20:0"], False)):  # nothing shows, and no ray is marched
            stats = os.path.join(self.folder.name, "stats.json")
            done = self.run_program(DATA, self.png, "--size", "300x300", "--array", "magvort", "--stats", stats, *asked)
            self.assertEqual(done.returncode, FINE, done.stderr)
            (self.assertRegex if said else self.assertNotRegex)(done.stdout, rays)
            with open(stats, encoding="utf-8") as file:
                self.assertEqual(json.load(file)["method"]["rays"] < 90000, bool(asked))

    def test_scene(self):
        """What --stats writes draws the same picture again, and what is asked for counts before it."""
        for asked in (
            ["--array", "magvort", "--view", "+y", "--color-map", "inferno", "--shade", "--levels", "2"],
            ["--array", "magvort", "--log", "--parallel", "--zoom", "1.5", "--step-scale", "2"],
            ["--blend-mode", "isosurface", "--iso", "1.2,1.8"],
            ["--blend-mode", "isosurface", "--iso", "1.5", "--no-shade"],
            ["--blend-mode", "maximum", "--error-tolerance", "0.02"],
            ["--blend-mode", "slice", "--slice", "0.5,0.5,0.9", "0,0.2,1"],
        ):
            with self.subTest(asked), tempfile.TemporaryDirectory() as folder:
                _, stats = self.draw(*asked)
                scene = os.path.join(folder, "scene.json")
                shutil.move(os.path.join(self.folder.name, "stats.json"), scene)
                with open(self.png, "rb") as file:
                    first = file.read()
                again = os.path.join(folder, "again.png")
                done = self.run_program("--scene", scene, DATA, again, "--stats", os.path.join(folder, "again.json"))
                self.assertEqual(done.returncode, FINE, done.stderr)
                with open(again, "rb") as file:
                    self.assertEqual(file.read(), first)
                with open(os.path.join(folder, "again.json"), encoding="utf-8") as file:
                    found = json.load(file)
                for part in ("input", "view", "method"):
                    self.assertEqual(found[part], stats[part])
                # As the viewer writes it: without iso-values that do not show; and a single name is the output's.
                with open(scene, encoding="utf-8") as file:
                    other = json.load(file)
                if other["view"]["blend_mode"] != "isosurface":
                    other["view"]["iso_values"] = [0.0]
                other["input"]["file"] = DATA
                other["picture"]["look"].update(color_map="mine", colors=[[0.0, 1, 0, 0], [2.0, 0, 0, 1]])
                with open(scene, "w", encoding="utf-8") as file:
                    json.dump(other, file)
                done = self.run_program("--scene=" + scene, again, "--size", "40x30", "--quiet")
                self.assertEqual(done.returncode, FINE, done.stderr)
                self.assertEqual(png_size(again), (40, 30))

    def test_options_with_a_scene_hold_together(self):
        """As they have to without one."""
        with tempfile.TemporaryDirectory() as folder:
            self.draw("--array", "magvort")
            scene = shutil.move(os.path.join(self.folder.name, "stats.json"), folder)
            os.remove(self.png)
            for asked in (["--step-scale", "2", "--error-tolerance", "0.01"], ["--view", "+x", "--position", "9,9,9"]):
                with self.subTest(asked):
                    self.refused(BAD_ARGUMENTS, asked[::2], "--scene", scene, DATA, self.png, *asked)

    def test_wrong_scenes(self):
        with tempfile.TemporaryDirectory() as folder:
            self.refused(BAD_ARGUMENTS, ["no_such.json"], "--scene", "no_such.json", DATA, self.png)
            for text, words in (("hello", ["not a scene"]), ("{}", ["not a scene", "input"])):
                with self.subTest(text):
                    scene = write(folder, "scene.json", text)
                    self.refused(BAD_ARGUMENTS, words, "--scene", scene, DATA, self.png)

    def test_blend_modes_that_do_not_fit(self):
        self.refused(BAD_ARGUMENTS, ["--iso"], DATA, self.png, "--blend-mode", "isosurface")
        self.refused(BAD_ARGUMENTS, ["--blend-mode isosurface"], DATA, self.png, "--iso", "1")
        self.refused(BAD_ARGUMENTS, ["--iso"], DATA, self.png, "--blend-mode", "isosurface", "--iso", "-1", "--log")
        self.refused(BAD_ARGUMENTS, ["--slice"], DATA, self.png, "--blend-mode", "slice")
        self.refused(BAD_ARGUMENTS, ["--blend-mode slice"], DATA, self.png, "--slice", "0,0,1", "0,0,1")
        self.refused(BAD_ARGUMENTS, ["--slice", "normal"], DATA, self.png, "--blend-mode", "slice", "--slice",
                     "0,0,1", "0,0,0")

    def test_turntable(self):
        done = self.run_program(DATA, self.png, "--size", "48x32", "--turntable", "3", "--array", "magvort")
        self.assertEqual(done.returncode, FINE, done.stderr)
        names = ["picture-%04d.png" % i for i in range(3)]
        self.assertEqual(sorted(os.listdir(self.folder.name)), names)
        pictures = set()
        for name in names:
            with open(os.path.join(self.folder.name, name), "rb") as file:
                pictures.add(file.read())
        self.assertEqual(len(pictures), 3)

    def write_time_steps(self, folder):
        """Three of them, in which more and more cells have a value that shows."""
        steps = []
        for i in range(3):
            step = os.path.join(folder, "step%d" % i)
            os.mkdir(step)
            depth = 40 if i == 0 else 4  # far beyond the last one's
            values = " ".join("1" if cell < 16 * (i + 1) else "0" for cell in range(16 * depth))
            write(step, "block.vti", """<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">
                <ImageData WholeExtent="0 4 0 4 0 {1}" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="0 4 0 4 0 {1}">
                <CellData><DataArray type="Float32" Name="density" format="ascii">{0}</DataArray></CellData>
                </Piece></ImageData></VTKFile>""".format(values, depth))
            steps.append(write(step, "data.vthb", """<VTKFile type="vtkOverlappingAMR" version="1.1"
                byte_order="LittleEndian"><vtkOverlappingAMR origin="0 0 0" grid_description="XYZ">
                <Block level="0" spacing="1 1 1"><DataSet index="0" amr_box="0 3 0 3 0 {0}" file="block.vti"/></Block>
                </vtkOverlappingAMR></VTKFile>""".format(depth - 1)))
        return steps

    def test_time_series(self):
        """Numbered pictures, colours and opacities of all as they are for the last one."""
        with tempfile.TemporaryDirectory() as folder:
            steps = self.write_time_steps(folder)
            asked = ["--size", "48x32", "--view", "+z", "--stats", os.path.join(folder, "stats.json")]
            done = self.run_program(*steps, self.png, *asked)
            self.assertEqual(done.returncode, FINE, done.stderr)
            names = ["picture-%04d.png" % i for i in range(3)]
            self.assertEqual(sorted(os.listdir(self.folder.name)), names)
            self.assertIn("3 of them, numbered", done.stdout)
            with open(os.path.join(folder, "stats.json"), encoding="utf-8") as file:
                stats = json.load(file)
            self.assertEqual(stats["input"]["series"], steps)
            self.assertEqual(stats["input"]["file"], steps[2])
            pictures = []
            for name in names:
                with open(os.path.join(self.folder.name, name), "rb") as file:
                    pictures.append(file.read())
            self.assertEqual(len(set(pictures)), 3)
            # The scene names them all.
            again = os.path.join(folder, "again.png")
            done = self.run_program("--scene", os.path.join(folder, "stats.json"), again, "--quiet")
            self.assertEqual(done.returncode, FINE, done.stderr)
            with open(os.path.join(folder, "again-0001.png"), "rb") as file:
                self.assertEqual(file.read(), pictures[1])
            # Each is what the last one's scene shows of it.
            for step, picture in zip(steps, pictures):
                single = os.path.join(folder, "single.png")
                done = self.run_program("--scene", os.path.join(folder, "stats.json"), step, single)
                self.assertEqual(done.returncode, FINE, done.stderr)
                with open(single, "rb") as file:
                    self.assertEqual(file.read(), picture)

    def test_time_series_that_does_not_hold_together(self):
        with tempfile.TemporaryDirectory() as folder:
            steps = self.write_time_steps(folder)
            self.refused(BAD_ARGUMENTS, ["--turntable"], *steps, self.png, "--turntable", "3")
            self.refused(INPUT_UNREADABLE, ["no cell array 'magvort'", "time series"], steps[0], DATA, self.png,
                         "--array", "magvort", "--size", "48x32")
            self.refused(BAD_ARGUMENTS, ["--list-arrays", "one"], *steps, "--list-arrays")

    def test_video(self):
        """Pictures go to ffmpeg, row by row; here to a script in its place, which keeps what it gets."""
        with tempfile.TemporaryDirectory() as folder:
            steps = self.write_time_steps(folder)
            video = os.path.join(self.folder.name, "film.MP4")
            script = write(folder, "ffmpeg", """#!/bin/sh
                echo "$@" > {0}/arguments
                for part; do true; done
                cat > "$part"
                test ! -e {0}/fails""".format(folder))
            os.chmod(script, 0o755)
            there = dict(os.environ, PATH=folder + ":" + os.environ["PATH"])
            done = self.run_program(*steps, video, "--size", "48x32", "--fps", "5", env=there)
            self.assertEqual(done.returncode, FINE, done.stderr)
            self.assertEqual(os.listdir(self.folder.name), ["film.MP4"])
            self.assertEqual(os.path.getsize(video), 3 * 48 * 32 * 3)
            with open(os.path.join(folder, "arguments"), encoding="utf-8") as file:
                self.assertIn("-video_size 48x32 -framerate 5", file.read())
            done = self.run_program(DATA, video, "--turntable", "4", "--size", "48x32", "--levels", "1", env=there)
            self.assertEqual(done.returncode, FINE, done.stderr)
            self.assertEqual(os.path.getsize(video), 4 * 48 * 32 * 3)
            os.remove(video)
            os.symlink("/dev/null", video)
            done = self.run_program(*steps, video, "--size", "48x32", env=there)
            self.assertEqual(done.returncode, OUTPUT_UNWRITABLE, done.stderr)
            os.remove(video)
            done = self.run_program(*steps, "12:30.mkv", "--size", "48x32", env=there, cwd=self.folder.name)
            self.assertEqual(done.returncode, FINE, done.stderr)
            with open(os.path.join(folder, "arguments"), encoding="utf-8") as file:
                self.assertIn(" " + self.folder.name + "/", file.read())
            os.remove(os.path.join(self.folder.name, "12:30.mkv"))
            write(folder, "fails", "")
            self.refused(OUTPUT_UNWRITABLE, ["ffmpeg"], *steps, video, "--size", "48x32", env=there)
            without = dict(os.environ, PATH=os.path.join(folder, "nowhere"))
            self.refused(OUTPUT_UNWRITABLE, ["ffmpeg", "Install"], *steps, video, env=without)
            self.refused(BAD_ARGUMENTS, ["several pictures"], DATA, video, env=there)
            self.refused(BAD_ARGUMENTS, ["--fps"], DATA, self.png, "--fps", "5")

    def test_other_endings(self):
        for name, magic in (("a.PNG", b"\x89PNG"), ("a.jpg", b"\xff\xd8"), ("a.JPEG", b"\xff\xd8")):
            with self.subTest(name):
                path = os.path.join(self.folder.name, name)
                done = self.run_program(DATA, path, "--size", "48x32", "--levels", "1")
                self.assertEqual(done.returncode, FINE, done.stderr)
                with open(path, "rb") as file:
                    self.assertTrue(file.read().startswith(magic))

    def test_annotation(self):
        """Axes and a scalar bar are drawn on the background."""
        paths = []
        for options in ([], ["--annotate"]):
            self.draw("--background", "white", *options)
            with open(self.png, "rb") as file:
                paths.append(file.read())
        self.assertNotEqual(*paths)

    def test_quiet(self):
        done, _ = self.draw("--quiet")
        self.assertEqual(done.stdout + done.stderr, "")


if __name__ == "__main__":
    PROGRAM, DATA = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
