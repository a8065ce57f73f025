#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""exabricks-benchmark: what it writes, and what it says to input that is wrong.

Usage: TestBenchmarkProgram.py PROGRAM FOLDER_OF_DATA   (with a display, or under xvfb-run)
"""

import csv
import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM, DATA = "", ""

FINE, FAILED, BAD_ARGUMENTS, INPUT_UNREADABLE, OUTPUT_UNWRITABLE = range(5)
# As fast as can be: whether it measures and writes is what is tested.
SMALL = ["--size", "32x32", "--accuracy-size", "32x32", "--rounds", "1"]


class BenchmarkProgramTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.results = os.path.join(self.folder.name, "results")

    def tearDown(self):
        self.folder.cleanup()

    def run_program(self, *arguments):
        return subprocess.run(
            [PROGRAM, *arguments], capture_output=True, text=True, timeout=300, check=False
        )

    def refused(self, code, words, *arguments):
        """The run ends with the code and a message that has the words in it; nothing is written."""
        done = self.run_program(*arguments)
        self.assertEqual(done.returncode, code, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertEqual(os.listdir(self.folder.name), [])

    def test_nothing_given(self):
        self.refused(BAD_ARGUMENTS, ["Nothing to measure", "--help"])

    def test_unknown_option(self):
        self.refused(BAD_ARGUMENTS, ["--colour", "--help"], "--colour", "x")

    def test_two_extents(self):
        self.refused(BAD_ARGUMENTS, ["--quick", "--full"], "--quick", "--full", "-o", self.results)

    def test_no_output(self):
        self.refused(BAD_ARGUMENTS, ["--output"], "--quick")

    def test_unknown_method(self):
        self.refused(
            BAD_ARGUMENTS, ["method", "--list"], "--quick", "-o", self.results, "--methods", "magic")

    def test_no_such_folder_of_data(self):
        self.refused(
            INPUT_UNREADABLE, ["--data", "nowhere"], "--quick", "-o", self.results,
            "--data", os.path.join(self.folder.name, "nowhere"))

    def test_size_that_is_none(self):
        self.refused(
            BAD_ARGUMENTS, ["--size", "big"], "--quick", "-o", self.results, "--size", "big")

    def test_unknown_scene(self):
        self.refused(BAD_ARGUMENTS, ["atlantis", "--list"], "--scenes", "atlantis", "-o", self.results)

    def test_list(self):
        done = self.run_program("--list", "--data", DATA)
        self.assertEqual(done.returncode, FINE, done.stderr)
        for word in ("small shell", "rt_medium", "basis, k-d tree", "vtkMultiBlockVolumeMapper", "cell location",
                     "native march"):
            self.assertIn(word, done.stdout)

    def test_all_methods_of_ours_draw_about_the_same(self):
        done = self.run_program(
            "--scenes", "small shell", "--no-peers", "--step-scales", "0.25", "-o", self.results, *SMALL)
        self.assertEqual(done.returncode, FINE, done.stderr)
        with open(os.path.join(self.results, "results.csv"), newline="", encoding="utf-8") as file:
            rows = {row["method"]: row for row in csv.DictReader(file)}
        for method in ("basis, k-d tree", "basis, ray query", "cell location", "naive walk", "midpoint",
                       "no skipping", "finest steps", "native march, k-d tree"):
            self.assertGreater(float(rows[method]["psnr"]), 45.0, method)
        for method in ("basis, k-d tree", "basis, ray query", "completed, k-d tree"):
            self.assertGreater(float(rows[method]["samples"]), 0.0, method)

    def test_finer_steps_are_nearer(self):
        done = self.run_program(
            "--scenes", "small shell", "--methods", "basis, k-d tree", "--step-scales", "2,1,0.5",
            "-o", self.results, "--changes", "1", *SMALL)
        self.assertEqual(done.returncode, FINE, done.stderr)
        with open(os.path.join(self.results, "results.csv"), newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["value"] for row in rows], ["2", "1", "0.5"])
        errors = [float(row["rmse"]) for row in rows]
        self.assertEqual(errors, sorted(errors, reverse=True))
        self.assertTrue(all(float(row["wall_ms"]) > 0 for row in rows))
        samples = [float(row["samples"]) for row in rows]
        self.assertEqual(samples, sorted(samples), "finer steps take more")
        self.assertGreater(samples[0], 0.0)
        for name in ("scenes.csv", "changes.csv", "machine.csv"):
            self.assertTrue(os.path.exists(os.path.join(self.results, name)), name)
        hidden = [name for name in os.listdir(self.results) if name.startswith(".")]
        self.assertEqual(hidden, [], "left over from writing")


if __name__ == "__main__":
    PROGRAM, DATA = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1], verbosity=2)
