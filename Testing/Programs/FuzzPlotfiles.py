#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Damages AMReX plotfiles in many ways, and has exabricks-render open each: words, or the picture of the whole file.

Usage: FuzzPlotfiles.py PROGRAM [COUNT [SEED [PLOTFILE [ARRAY]]]]

Without a plotfile, one of two levels is written. Damages are made by SEED, always the same ones. Each run has to end within a
minute, not by a signal, and with a message if it fails; if it does not fail, its picture is that of the file before. Exits
with 1 if any run does not, and keeps its file.
"""

import pathlib
import random
import shutil
import struct
import subprocess
import sys
import tempfile

SECONDS = 60
NUMBERS = ("0", "-1", "1", "2", "3", "7", "64", "1000000000", "2147483647", "-2147483648", "99999999999999999999", "nan", "1e400", "x")


def write_plotfile(folder):
    """Two levels, ratio 2: 8^3 cells, of which the middle ones are refined in two boxes."""
    folder = pathlib.Path(folder)
    boxes = [[((0, 0, 0), (7, 7, 7))], [((4, 4, 4), (7, 11, 11)), ((8, 4, 4), (11, 11, 11))]]
    text = lambda box: "({} {} (0,0,0))".format(*("(" + ",".join(map(str, corner)) + ")" for corner in box))
    header = ["HyperCLaw-V1.1", "1", "density", "3", "0.5", "1", "0 0 0", "1 1 1", "2",
              text(((0, 0, 0), (7, 7, 7))) + " " + text(((0, 0, 0), (15, 15, 15))), "3 6",
              "0.125 0.125 0.125", "0.0625 0.0625 0.0625", "0", "0"]
    for level, grids in enumerate(boxes):
        width = 0.125 / 2**level
        header += [f"{level} {len(grids)} 0.5", "3"]
        header += [f"{lo[axis] * width} {(hi[axis] + 1) * width}" for lo, hi in grids for axis in range(3)]
        header.append(f"Level_{level}/Cell")
        place = folder / f"Level_{level}"
        place.mkdir(parents=True)
        data, offsets = b"", []
        for lo, hi in grids:
            offsets.append(len(data))
            data += ("FAB ((8, (64 11 52 0 1 12 0 1023)),(8, (8 7 6 5 4 3 2 1)))" + text((lo, hi)) + " 1\n").encode()
            cells = [(x + 0.5, y + 0.5, z + 0.5) for z in range(lo[2], hi[2] + 1) for y in range(lo[1], hi[1] + 1)
                     for x in range(lo[0], hi[0] + 1)]
            data += struct.pack(f"<{len(cells)}d", *(1.0 + width * (x + 2.0 * y * width * z) for x, y, z in cells))
        (place / "Cell_D_00000").write_bytes(data)
        lines = ["1", "1", "1", "0", f"({len(grids)} 0", *map(text, grids), ")", str(len(grids))]
        lines += [f"FabOnDisk: Cell_D_00000 {offset}" for offset in offsets]
        lines += ["", f"{len(grids)},1", *["1.0,"] * len(grids), "", f"{len(grids)},1", *["2.0,"] * len(grids), ""]
        (place / "Cell_H").write_text("\n".join(lines))
    (folder / "Header").write_text("\n".join(header) + "\n")


def first_line_of_box(path, data, chance):
    """Where the description of one of the boxes in a file of them is."""
    places = []
    at = data.find(b"FAB ((")
    while at >= 0 and len(places) < 64:
        places.append(at)
        at = data.find(b"FAB ((", at + 1)
    begin = chance.choice(places)
    return begin, data.index(b"\n", begin)


def damage_text(text, chance):
    """Lines or numbers of a header that are lost, doubled, swapped or changed."""
    lines = text.split("\n")
    kind = chance.randrange(6)
    at = chance.randrange(max(len(lines), 1))
    if kind == 0:
        del lines[at]
    elif kind == 1:
        lines.insert(at, lines[at])
    elif kind == 2:
        other = chance.randrange(len(lines))
        lines[at], lines[other] = lines[other], lines[at]
    elif kind == 3:
        words = lines[at].replace(",", " , ").replace("(", " ( ").replace(")", " ) ").split()
        numbers = [i for i, word in enumerate(words) if word.lstrip("-").replace(".", "").isdigit()]
        if numbers:
            words[chance.choice(numbers)] = chance.choice(NUMBERS)
            lines[at] = " ".join(words)
    elif kind == 4:
        return text[: chance.randrange(len(text))]
    else:
        place = chance.randrange(len(text))
        return text[:place] + chr(chance.randrange(32, 127)) + text[place + 1:]
    return "\n".join(lines)


def damage(folder, chance):
    """Damages one file of the plotfile; returns what was done."""
    files = sorted(path for path in folder.rglob("*") if path.is_file())
    path = chance.choice([path for path in files if path.name in ("Header", "Cell_H")] * 3 + files)
    if path.name.startswith("Cell_D"):
        data = path.read_bytes()
        kind = chance.randrange(3)
        if kind == 0:
            path.unlink()
        elif kind == 1:
            path.write_bytes(data[: chance.randrange(len(data))])
        else:
            begin, end = first_line_of_box(path, data, chance)
            line = damage_text(data[begin:end].decode("latin-1"), chance)
            path.write_bytes(data[:begin] + line.encode("latin-1") + data[end:])
        return f"{path.name}, kind {kind}"
    path.write_text(damage_text(path.read_text("latin-1"), chance), "latin-1")
    return path.name


def main(program, count=100, seed=1, plotfile=None, array="density"):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        whole = pathlib.Path(plotfile) if plotfile else folder / "plt00003"
        if not plotfile:
            write_plotfile(whole)
        picture, target = folder / "picture.png", folder / "damaged"

        def render(path):
            picture.unlink(missing_ok=True)
            return subprocess.run([program, path, picture, "--array", array, "--size", "64x48"], timeout=SECONDS,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", check=False)

        done = render(whole)
        assert done.returncode == 0, done.stdout
        expected = picture.read_bytes()
        counts = {"refused": 0, "the same picture": 0, "crashes": 0, "hangs": 0, "other pictures": 0, "no words": 0}
        for number in range(int(count)):
            chance = random.Random(f"{seed} {number}")
            shutil.rmtree(target, ignore_errors=True)
            shutil.copytree(whole, target)
            what = damage(target, chance)
            try:
                done = render(target)
            except subprocess.TimeoutExpired:
                kind = "hangs"
            else:
                kind = "crashes" if done.returncode < 0 or done.returncode > 120 else \
                    "refused" if done.returncode > 0 and done.stdout.strip() else \
                    "no words" if done.returncode > 0 else \
                    "the same picture" if picture.read_bytes() == expected else "other pictures"
            counts[kind] += 1
            if kind not in ("refused", "the same picture"):
                kept = pathlib.Path(tempfile.gettempdir()) / f"damaged-{seed}-{number}"
                shutil.rmtree(kept, ignore_errors=True)
                shutil.copytree(target, kept)
                print(f"{kind}: {what}, kept as {kept}", flush=True)
        print(", ".join(f"{kind}: {n}" for kind, n in counts.items()))
        return counts["refused"] + counts["the same picture"] != int(count)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
