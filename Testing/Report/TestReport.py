#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Utilities/report: tables and charts of small CSV files, and what it says to input that is wrong.

Usage: TestReport.py ROOT_OF_THE_PROJECT
"""

import csv
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path()
TARGET_SCENE = "rt_medium magvort, scene"
RESULTS = ("scene", "method", "role", "parameter", "rounds", "note", "value", "wall_ms", "cpu_ms", "psnr",
           "psnr_rgba_drawn", "rmse_own", "samples")
SCENES = ("scene", "group", "levels", "leaf_cells", "bricks", "regions", "active_regions", "structure_s", "gather_s",
          "ranges_s", "scalars_mib", "bricks_mib", "regions_device_mib", "regions_host_mib", "acceleration_mib",
          "surface_mib", "total_kd_tree_mib", "total_ray_query_mib", "host_mib", "frame_kd_tree_ms",
          "frame_ray_query_ms", "frame_by_tolerance_ms", "frame_of_all_levels_ms")


def result(method, role, value, wall_ms, psnr, scene="Wind", parameter="step scale", **more):
    return {"scene": scene, "method": method, "role": role, "parameter": parameter, "value": value, "wall_ms": wall_ms,
            "cpu_ms": wall_ms, "psnr": psnr, **more}


def peer(method, value, wall_ms, psnr, scene="Wind"):
    return result(method, "peer", value, wall_ms, psnr, scene, "" if value is None else "grid cells")


class ReportTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.measured = self.folder / "measured"
        self.measured.mkdir()

    def write(self, name, columns, rows):
        with open(self.measured / name, "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, columns)
            writer.writeheader()
            writer.writerows(rows)

    def write_scenes(self, *scenes, name="scenes.csv", **more):
        numbers = dict.fromkeys(SCENES[2:19], 1.0)
        self.write(name, SCENES, [{**numbers, "scene": scene, "group": "stand-in", **more} for scene in scenes])

    def run_report(self, *arguments):
        return subprocess.run([sys.executable, str(ROOT / "Utilities/report"), *map(str, arguments)],
                              capture_output=True, text=True, timeout=300, check=False)

    def report(self):
        """The page of everything there is."""
        done = self.run_report(self.measured)
        self.assertEqual(done.returncode, 0, done.stderr)
        return (self.measured / "report.md").read_text(encoding="utf-8")

    def refused(self, words, *arguments):
        done = self.run_report(*arguments)
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def derived(self, name):
        with open(self.measured / f"{name}.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def assert_chart(self, name, colors=()):
        """It is a picture with pixels of these colours."""
        from matplotlib import image
        pixels = (255 * image.imread(self.measured / f"{name}.png")[:, :, :3]).round().astype(int)
        self.assertGreater(pixels.shape[1], 600)
        for color in colors:
            rgb = [int(color[i:i + 2], 16) for i in (1, 3, 5)]
            self.assertGreater((abs(pixels - rgb).sum(axis=2) < 12).sum(), 100, f"{name}: {color}")

    # What exabricks-benchmark measured

    def test_peers_are_compared_at_no_less_accuracy(self):
        self.write_scenes("Wind")
        self.write("results.csv", RESULTS, [
            result("basis, k-d tree", "ours", 4, 100, 40), result("basis, k-d tree", "ours", 1, 200, 55),
            peer("resampled, vtkGPUVolumeRayCastMapper", 128, 1000, 45)])
        page = self.report()
        # 1 s against 0.2 s, and 10 dB short
        self.assertIn("| resampled, vtkGPUVolumeRayCastMapper | 128 | 1 | 5.0 | 5.0 | 45.0 | 10.0 |\n", page)
        row, = self.derived("peers")
        self.assertEqual((row["ours_value"], row["ours_frame_ms"], row["times_less"]), ("1", "200", "5"))
        self.assert_chart("peers", ["#D55E00"])
        self.assert_chart("main", ["#000000", "#D55E00", "#FFE28A"])
        self.assertIn("![main](main.png)", page)

    def test_ranks_have_what_they_cost(self):
        self.write_scenes("Wind")
        self.write("results.csv", RESULTS, [result("basis, k-d tree", "ours", 1, 200, 55)])
        columns = ("scene", "leaf_cells", "blocks", "ranks", "drawn_most", "drawn_mean", "held_most", "host_bytes_most",
                   "device_bytes_most", "received_bytes_most", "cut_s", "exchange_s", "structure_s", "picture_s",
                   "compositing_s")
        self.write("ranks.csv", columns, [
            dict(zip(columns, ("Wind", 8e6, 64, ranks, 8e6 / ranks, 8e6 / ranks, 9e6 / ranks, 2e8 / ranks, 4e7 / ranks,
                               3e7 / ranks, 0.5, 0.1, 0.2 / ranks, 4 / ranks, 0.01))) for ranks in (1, 2, 8)])
        page = self.report()
        # Eight of them, two not being told of: cells to draw, and how many are held for that.
        self.assertIn("| Wind | 8 | 1 | 1.12 |", page)
        self.assertNotIn("| Wind | 2 |", page)
        self.assert_chart("ranks", ["#000000", "#0072B2"])

    def test_peers_that_were_not_drawn_have_no_numbers(self):
        self.write_scenes("Wind")
        self.write("results.csv", RESULTS, [
            result("basis, k-d tree", "ours", 1, 200, 55),
            {**peer("vtkMultiBlockVolumeMapper, all blocks", None, "", ""), "note": "no picture: black"}])
        self.assertNotIn("vtkMultiBlockVolumeMapper", self.report())
        self.assertEqual(self.derived("peers")[0]["note"], "no picture: black")

    def test_source_is_beside_ours(self):
        self.write_scenes("Wind", scalars_mib=1000, regions_device_mib=5)
        self.write("results.csv", RESULTS, [
            result("cell location, k-d tree", "baseline", 1, 400, 50), result("basis, k-d tree", "ours", 1, 100, 50)])
        page = self.report()
        self.assertIn("| Wind | 151 | 75.8 | 2.0 | 400 | 100 | 4.0 | 3.0 | kept |\n", page)
        self.assertIn("| Wind | source | 1530 | 0.767 | | 36.3 | | | 2160 | 0.024 | | |\n", page)
        self.assertIn("| | ours | 1050 | 1.05 | 1.05 | 5.24 | 1.05 | 1.05 | 1.05 | 0.005 | 0.01 | kept |\n", page)

    def test_targets_are_judged(self):
        self.write_scenes(TARGET_SCENE)
        rows = [
            result("basis, k-d tree", "ours", 2, 100, 45), result("basis, k-d tree", "ours", 1.2, 200, 52),
            result("basis, k-d tree", "ours", 1, 300, 55), result("native march, k-d tree", "baseline", 1, 150, 55),
            peer("resampled, vtkFixedPointVolumeRayCastMapper", 128, 400, 40)]
        rows[2]["cpu_ms"] = 450
        self.write("results.csv", RESULTS, [{**row, "scene": TARGET_SCENE} for row in rows])
        page = self.report()
        # The fastest that is accurate enough, 0.2 s of 0.4 s; processor time 450 of 150.
        self.assertIn("| at most 0.8 | 0.50: 200 ms and 52.0 dB, it 400 ms and 40.0 dB | kept |\n", page)
        self.assertIn("| at most 2 | 3.00 | missed |\n", page)

    def test_tolerance_samples_and_levels(self):
        self.write_scenes("Wind")
        by, of_all, parameter = "basis, by tolerance", "by tolerance, all levels", "error tolerance"
        self.write("results.csv", RESULTS, [
            result("basis, k-d tree", "ours", 2, 300, 40, samples=10),
            result("basis, k-d tree", "ours", 1, 400, 60, samples=1000),
            result(by, "ours", 0.01, 200, 40, parameter=parameter, psnr_rgba_drawn=40, samples=10),
            result(of_all, "ours", 0.01, 500, 41, parameter=parameter, psnr_rgba_drawn=41, samples=30),
            # None are left out.
            result(by, "ours", 0.001, 600, 60, parameter=parameter, psnr_rgba_drawn=50, samples=40),
            result(of_all, "ours", 0.001, 600, 60, parameter=parameter, psnr_rgba_drawn=50, samples=40)])
        page = self.report()
        self.assertIn("| error got, of the one asked for | at most 2 | 1.00 to 3.16 | kept on 1 of 2 |\n", page)
        # 50 dB is half way between 40 and 60: the geometric means of 10 and 1000, of 10 and 40
        row = self.derived("samples")[0]
        self.assertEqual((row["db"], row["fixed_steps"], row["by_tolerance"], row["ratio"]), ("50", "100", "20", "0.2"))
        row, = self.derived("levels")
        self.assertEqual((row["value"], row["cpu_ratio"]), ("0.01", "0.4"))
        self.assert_chart("tolerance", ["#0072B2"])

    def test_orders_of_convergence_and_ablations(self):
        self.write_scenes("Wind")
        methods = ("basis, k-d tree", "midpoint", "left end", "no skipping")
        peers = [peer("resampled, vtkGPUVolumeRayCastMapper", 128, 1000, 45)]
        self.write("results.csv", RESULTS, peers + [
            result(method, "baseline" if method != methods[0] else "ours", step, 100 / step, 50 - 10 * step,
                   rmse_own=0.01 * step ** 2) for method in methods for step in (2, 1, 0.5)])
        self.report()
        self.assertEqual([row["order"] for row in self.derived("orders")], ["2"] * 4)
        self.assert_chart("ablations", ["#000000", "#E69F00", "#CC79A7"])
        self.assert_chart("Wind_ablations")

    def test_growth_and_changes(self):
        self.write_scenes("Wind")
        self.write("results.csv", RESULTS, [result("basis, k-d tree", "ours", 1, 200, 55)])
        self.write("growth.csv", SCENES, [
            {**dict.fromkeys(SCENES[2:], size / 1e5), "scene": "Cloud", "group": "stand-in", "leaf_cells": size}
            for size in (1e5, 1e6, 1e7)])
        self.write("changes.csv", ("scene", "change", "traversal", "total_ms", "kept"), [
            {"scene": scene, "change": "colours", "traversal": "k-d tree", "total_ms": time, "kept": "volume opacity"}
            for scene, time in (("a", 0.25), ("b", 2), ("c", 300))])
        self.assertIn("| colours | 2.0 | 0.250 to 300 | volume, opacity |\n", self.report())
        self.assert_chart("growth_time", ["#000000", "#0072B2"])
        self.assert_chart("growth_memory", ["#000000", "#E69F00"])

    # Pages

    def test_page_has_its_tables_and_charts_anew(self):
        self.test_peers_are_compared_at_no_less_accuracy()
        page = self.folder / "Page.md"
        page.write_text("Before\n\n<!-- table: peers -->\nold\n<!-- end -->\n\n![](Page/peers.png) after\n",
                        encoding="utf-8")
        (self.folder / "Page").mkdir()
        (self.folder / "Page" / "kept.csv").write_text("by hand\n", encoding="utf-8")
        texts = []
        for _ in range(2):
            done = self.run_report(self.measured, page)
            self.assertEqual(done.returncode, 0, done.stderr)
            texts.append((page.read_text(encoding="utf-8"), (self.folder / "Page" / "peers.png").read_bytes()))
        self.assertEqual(texts[0], texts[1], "the same numbers, the same bytes")
        text = texts[0][0]
        self.assertTrue(text.startswith("Before\n\n<!-- table: peers -->\n| peer |"), text)
        self.assertTrue(text.endswith("|\n\n<!-- end -->\n\n![](Page/peers.png) after\n"), text)
        self.assertNotIn("old", text)
        self.assertEqual(sorted(path.name for path in (self.folder / "Page").iterdir()),
                         ["kept.csv", "peers.csv", "peers.png", "results.csv", "scenes.csv", "source_memory.csv"])

    def test_page_is_left_as_it_was_where_something_was_not_measured(self):
        self.test_peers_are_compared_at_no_less_accuracy()
        page = self.folder / "Page.md"
        before = ("<!-- table: peers -->\n<!-- end -->\n![](Page/growth_time.png)\n"
                  "<!-- table: changes -->\n<!-- end -->\n")
        page.write_text(before, encoding="utf-8")
        self.refused(["changes, growth_time", "not measured", "left as it was"], self.measured, page)
        self.assertEqual(page.read_text(encoding="utf-8"), before)
        self.assertFalse((self.folder / "Page").exists())

    def test_pages_of_the_project_have_the_tables_of_their_files(self):
        for name in ("Evaluation", "Accuracy"):
            documentation = ROOT / "Documentation"
            page = self.folder / f"{name}.md"
            shutil.copy(documentation / page.name, page)
            done = self.run_report(documentation / name, page)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(page.read_text(encoding="utf-8"), (documentation / page.name).read_text(encoding="utf-8"))
            drawn = sorted(path.name for path in (self.folder / name).glob("*.png"))
            self.assertEqual(drawn, sorted(path.name for path in (documentation / name).glob("*.png")))

    # What the accuracy programs measured

    def test_accuracy(self):
        self.write("reconstruction_errors.csv", ("field", "ratio", "method", "zone", "coarse_width", "max", "rms"), [
            {"field": "Gaussian", "ratio": 2, "method": method, "zone": zone, "coarse_width": width,
             "max": width ** order, "rms": 0.1 * width ** (order + 0.5)}
            for method, order in (("nearest", 1), ("basis", 2), ("completed", 2))
            for zone in ("interior", "level boundary") for width in (0.125, 0.0625, 0.03125)])
        self.write("held_error.csv", ("data", "traversal", "step_scale", "psnr", "psnr_drawn"), [
            {"data": "rt, small", "traversal": traversal, "step_scale": step, "psnr": 50 - 10 * step,
             "psnr_drawn": 40 - 10 * step} for traversal in ("k-d tree", "ray query") for step in (1, 2)])
        self.write("stability.csv", ("theme", "case", "basis_kd_db", "basis_rq_db", "nearest_kd_db", "nearest_rq_db",
                                     "multiblock", "elsewhere"), [
            {"case": "NaNCells", "basis_kd_db": 73.5, "basis_rq_db": "equal", "nearest_kd_db": 125,
             "nearest_rq_db": 125.04, "multiblock": "timeout", "elsewhere": "drawn black, or nothing"}])
        page = self.report()
        self.assertIn("| data | 2 | 1 | 2 | 1 |\n| --- | --- | --- | --- | --- |\n"
                      "| rt, small | 30.0 | 40.0 | 20.0 | 30.0 |\n", page)
        self.assertIn("| NaNCells | drawn black, or nothing | 73.5 | equal | 125.0 | 125.0 | timeout |\n", page)
        orders = {(row["method"], row["zone"]): (row["order_max"], row["order_rms"])
                  for row in self.derived("reconstruction_orders")}
        self.assertEqual(orders["nearest", "interior"], ("1", "1.5"))
        self.assertEqual(orders["basis", "level boundary"], ("2", "2.5"))
        self.assert_chart("reconstruction_error", ["#000000", "#0072B2"])
        self.assert_chart("held_error", ["#000000"])

    # Wrong input

    def test_nothing_measured(self):
        self.refused(["results.csv", "exabricks-benchmark", "reconstruction_errors.csv"], self.measured)

    def test_column_missing(self):
        self.write("results.csv", RESULTS[:-1], [])
        self.refused(["results.csv", "no column samples", "measure anew"], self.measured)

    def test_no_table(self):
        (self.measured / "results.csv").write_text("", encoding="utf-8")
        self.refused(["results.csv", "no CSV"], self.measured)

    def test_usage(self):
        for arguments, code in ([], 1), (["a", "b", "c"], 1), (["--nonsense"], 1), (["--help"], 0):
            done = self.run_report(*arguments)
            self.assertEqual(done.returncode, code)
            self.assertIn("python3 Utilities/report <folder>", done.stderr if code else done.stdout)


if __name__ == "__main__":
    ROOT = pathlib.Path(sys.argv[1])
    try:
        import matplotlib  # noqa: F401
        import pandas  # noqa: F401
    except ImportError as missing:
        print(f"skipped: {missing}; Debian's python3-pandas and python3-matplotlib are what the report is drawn with")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1], verbosity=2)
