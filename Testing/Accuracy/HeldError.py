#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What error the pictures of real data hold, against the length of the step.

    xvfb-run -a HeldError.py <CompareMappers> <folder of results> [<folder of data>]

Draws the shipped data set, and those of the folder of data that are there, with the program's
default camera and transfer function (rt_medium also with those of its scene file) at step scales
4 to 1/4, and compares with the reference. Writes held_error.md and held_error.csv.
"""

import csv
import json
import pathlib
import subprocess
import sys
import tempfile

STEPS = (4, 2, 1, 0.5, 0.25)
SHIPPED = pathlib.Path(__file__).resolve().parent.parent / "Data" / "rt_medium" / "rt_medium.vthb"

# name, file in the folder of data, further arguments
DATA = (
    ("rt_small density", "rt_pre/plt00214", ["--array", "density"]),
    ("rt_medium magvort", "rt_medium/plt00216", ["--array", "magvort"]),
    ("rt_medium magvort, scene", "rt_medium/plt00216",
     ["--array", "magvort", "--scene", "scene_rt_medium.json"]),
    ("sv_small phi", "sv_small/plt00046", []),
    ("sv_aniso phi", "sv_aniso/plt00018", []),
    ("sv_r24_many phi", "sv_r24_many/plt00070", []),
    ("Enzo log10 Density", "Data/AMR/Enzo/DD0010/moving7_0010.hierarchy",
     ["--array", "Density", "--log"]),
    ("HierarchicalBoxDataset.v1.1", "Data/AMR/HierarchicalBoxDataset.v1.1.vthb", []),
    ("PeleLMeX temp", "test_assets/example_plt_3d", ["--array", "temp"]),
    ("embedded boundary density", "plt_eb_3d_headerfixed", []),
)


def measure(program, file, arguments):
    """PSNR in dB over all pixels and over drawn ones, by step scale; k-d tree and ray query."""
    with tempfile.TemporaryDirectory() as folder:
        result = pathlib.Path(folder) / "result.json"
        subprocess.run(
            [program, str(file), "--size", "256x256", "--rounds", "1", "--step-scales",
             ",".join(str(step) for step in STEPS), "--json", str(result)] + arguments,
            check=True, stdout=subprocess.DEVNULL)
        methods = json.loads(result.read_text())["methods"]
    table = {}
    for method in methods:
        for traversal in ("k-d tree", "ray query"):
            for step in STEPS:
                if method["name"] == f"direct, {traversal}, step {step:g}":
                    table[traversal, step] = (method["psnr_rgba"], method["psnr_rgba_drawn"])
    return table


def cells(values):
    return " | ".join(f"{value:.1f}" for value in values)


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    program, results = sys.argv[1], pathlib.Path(sys.argv[2])
    data = pathlib.Path(sys.argv[3]) if len(sys.argv) == 4 else None
    subjects = [("rt_medium magvort, as shipped", SHIPPED, ["--array", "magvort"])]
    for name, file, arguments in DATA:
        path = data / file if data else None
        arguments = [str(data / a) if data and a.endswith(".json") else a for a in arguments]
        if path and path.exists() and all(
                not a.endswith(".json") or pathlib.Path(a).exists() for a in arguments):
            subjects.append((name, path, arguments))
        else:
            print(f"HeldError: {name} is left out: there is no {file}"
                  + (f" in {data}" if data else ", as no folder of data is given"))

    header = " | ".join(f"{step:g}" for step in STEPS)
    lines = [f"| data | {header} | {header} |", "| --- " * (1 + 2 * len(STEPS)) + "|"]
    with open(results / "held_error.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["chart", "series", "x", "y"])
        for name, path, arguments in subjects:
            print(f"HeldError: {name}", flush=True)
            table = measure(program, path, arguments)
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
