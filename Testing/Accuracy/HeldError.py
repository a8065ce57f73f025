#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What error the pictures of real data hold, against the length of the step.

    xvfb-run -a HeldError.py <exabricks-benchmark> <folder of results> [<folder of data>]

Draws the shipped data set, and those of the folder of data whose names the program knows, with its
default camera and transfer function (rt_medium also with those of its scene file) at step scales
4 to 1/4, and compares with the reference. Writes held_error.md and held_error.csv.
"""

import csv
import pathlib
import subprocess
import sys
import tempfile

STEPS = (4, 2, 1, 0.5, 0.25)
SHIPPED = pathlib.Path(__file__).resolve().parent.parent / "Data"


def measure(program, data):
    """PSNR in dB over all pixels and over drawn ones: by data set, traversal and step scale."""
    table = {}
    with tempfile.TemporaryDirectory() as folder:
        folders = [argument for path in [SHIPPED, *data] for argument in ("--data", str(path))]
        subprocess.run(
            [program, *folders, "--scenes", "data", "--methods", "basis", "--step-scales",
             ",".join(str(step) for step in STEPS), "--size", "32x32", "--accuracy-size", "256x256",
             "--rounds", "1", "--output", folder],
            check=True)
        with open(pathlib.Path(folder) / "results.csv", newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                traversal = row["method"].split(", ")[1]
                table.setdefault(row["scene"], {})[traversal, float(row["value"])] = (
                    float(row["psnr_rgba"]), float(row["psnr_rgba_drawn"]))
    return table


def cells(values):
    return " | ".join(f"{value:.1f}" for value in values)


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    program, results = sys.argv[1], pathlib.Path(sys.argv[2])
    subjects = measure(program, sys.argv[3:])

    header = " | ".join(f"{step:g}" for step in STEPS)
    lines = [f"| data | {header} | {header} |", "| --- " * (1 + 2 * len(STEPS)) + "|"]
    with open(results / "held_error.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["chart", "series", "x", "y"])
        for name, table in subjects.items():
            kd_tree = [table["k-d tree", step] for step in STEPS]
            lines.append(f"| {name} | {cells(all_ for all_, _ in kd_tree)} | "
                         f"{cells(drawn for _, drawn in kd_tree)} |")
            for step in STEPS:
                apart = abs(table["k-d tree", step][1] - table["ray query", step][1])
                if apart > 0.5 and table["k-d tree", step][1] < 90:
                    sys.exit(f"HeldError: the traversals differ by {apart:.1f} dB on {name}")
            for step, (_, drawn) in sorted(zip(STEPS, kd_tree)):
                writer.writerow(["Error held over drawn pixels", name, step, 10 ** (-drawn / 20)])
    (results / "held_error.md").write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
