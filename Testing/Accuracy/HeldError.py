#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What error the pictures of real data hold, against the length of the step.

    xvfb-run -a HeldError.py <exabricks-benchmark> <folder of results> [<folder of data>]

Draws the shipped data set, and those of the folder of data whose names the program knows, with its
default camera and transfer function (rt_medium also with those of its scene file) at step scales
4 to 1/4, and compares with the reference. Writes held_error.csv: PSNR in dB over all pixels and
over drawn ones, by data set, traversal and step scale.
"""

import csv
import pathlib
import subprocess
import sys
import tempfile

STEPS = (4, 2, 1, 0.5, 0.25)
SHIPPED = pathlib.Path(__file__).resolve().parent.parent / "Data"
APART = 0.5  # dB: so much the traversals may differ, where pictures are not exact but for rounding
ROUNDING = 90


def measure(program, data):
    """(PSNR over all pixels, over drawn ones), by (data set, traversal, step scale)."""
    with tempfile.TemporaryDirectory() as folder:
        folders = [argument for path in [SHIPPED, *data] for argument in ("--data", str(path))]
        subprocess.run(
            [program, *folders, "--scenes", "data", "--methods", "basis, k-d tree;basis, ray query",
             "--step-scales", ",".join(str(step) for step in STEPS), "--size", "32x32",
             "--accuracy-size", "256x256", "--rounds", "1", "--output", folder],
            check=True)
        with open(pathlib.Path(folder) / "results.csv", newline="", encoding="utf-8") as file:
            return {(row["scene"], row["method"].split(", ")[1], float(row["value"])):
                    (float(row["psnr_rgba"]), float(row["psnr_rgba_drawn"])) for row in csv.DictReader(file)}


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    errors = measure(sys.argv[1], sys.argv[3:])
    with open(pathlib.Path(sys.argv[2]) / "held_error.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["data", "traversal", "step_scale", "psnr", "psnr_drawn"])
        for (name, traversal, step), (of_all, of_drawn) in errors.items():
            writer.writerow([name, traversal, f"{step:g}", f"{of_all:.6g}", f"{of_drawn:.6g}"])
            apart = abs(of_drawn - errors[name, "k-d tree", step][1])
            if apart > APART and of_drawn < ROUNDING:
                sys.exit(f"HeldError: the traversals differ by {apart:.1f} dB on {name} at step {step:g}")


if __name__ == "__main__":
    main()
