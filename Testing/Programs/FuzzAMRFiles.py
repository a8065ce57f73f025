#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Damages AMR files in many ways, and has exabricks-render open each: words, or the picture of the whole file.

Usage: FuzzAMRFiles.py PROGRAM [COUNT [SEED [KIND [FILE ARRAY]]]]

KIND is plotfile (of AMReX), enzo, vthb, or all of them, each COUNT times. Without a file, small ones of two levels are written.
Damages are made by SEED, always the same ones. Each run has to end within a minute, not by a signal, and with a message if it
fails; if it does not fail, its picture is that of the file before. Exits with 1 if any run does not, and keeps its file.
"""

import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

from AMRFiles import ENCODINGS, write_enzo, write_plotfile, write_vthb

SECONDS = 60
NUMBERS = ("0", "-1", "1", "2", "3", "7", "64", "1000000000", "2147483647", "-2147483648", "99999999999999999999", "nan", "1e400", "x")
NUMBER = re.compile(r"(?<![\w.])-?\d+(\.\d+)?(e[-+]?\d+)?(?![\w.])")
APPENDED = re.compile(rb"<AppendedData[^>]*>\s*_")


def damage_text(text, chance):
    """Lines or numbers that are lost, doubled, swapped or changed.

    What makes another data set that is whole is not done: a .vthb loses none of its blocks, and arrays do not swap their names.
    """
    lines = text.split("\n")
    short = [i for i, line in enumerate(lines) if len(line) < 200]  # the others are values
    kind = chance.randrange(6)
    at, other = chance.choice(short), chance.choice(short)
    line = lines[at]
    if kind == 0 and "<DataSet" not in line:
        del lines[at]
    elif kind <= 1:
        lines.insert(at, line)
    elif kind == 2 and not "<DataArray" in line + lines[other]:
        lines[at], lines[other] = lines[other], line
    elif kind <= 3:
        numbers = list(NUMBER.finditer(line))
        if numbers:
            number = chance.choice(numbers)
            lines[at] = line[:number.start()] + chance.choice(NUMBERS) + line[number.end():]
    elif kind == 4:
        return text[: chance.randrange(len(text))]
    elif line:
        place = chance.randrange(len(line))
        lines[at] = line[:place] + chr(chance.randrange(32, 127)) + line[place + 1:]
    return "\n".join(lines)


def damage_header(path, chance):
    """Of a file that is all text, or of text before raw data."""
    data = path.read_bytes()
    mark = APPENDED.search(data)
    end = mark.end() if mark else len(data)
    text = damage_text(data[:end].decode("latin-1"), chance)
    path.write_bytes(text.encode("latin-1") + data[end:])
    return "header"


def damage_link(path, chance):
    """Has one file that it names be another one."""
    text = path.read_text("latin-1")
    names = list(re.finditer(r"[\w./]*(\.vti|\.cpu\d+|Cell_D_\d+|Level_\d+/Cell)\b", text))
    name = chance.choice(names)
    other = chance.choice([other.group() for other in names] + ["none", ".", "..", "/dev/null", "", path.name, name.group() + "/"])
    path.write_text(text[:name.start()] + other + text[name.end():], "latin-1")
    return f"link to {other}"


def damage_data(path, chance, others):
    """Cuts a file, or puts something else in its place; or changes what stands before the values of one array."""
    data = path.read_bytes()
    kind = chance.randrange(5)
    if kind < 3:
        path.write_bytes(data[: chance.randrange(len(data))])
        return "cut"
    if kind == 3:
        path.unlink()
        other = chance.choice(["nothing", "folder", "loop", *others])
        if other == "folder":
            path.mkdir()
        elif other == "loop":
            path.symlink_to(path.name)
        elif other != "nothing":
            shutil.copyfile(other, path)
        return f"replaced by {other}"
    if places := [place.start() for place in re.finditer(rb"FAB \(\(", data)]:
        begin = chance.choice(places)
        end = data.index(b"\n", begin)
        line = damage_text(data[begin:end].decode("latin-1"), chance).encode("latin-1")
        path.write_bytes(data[:begin] + line + data[end:])
        return "description of a box"
    if mark := APPENDED.search(data):
        offsets = [int(offset) for offset in re.findall(rb'offset="(\d+)"', data)]
        at = mark.end() + chance.choice(offsets) + chance.randrange(16 if b"compressor" in data else 4)
        path.write_bytes(data[:at] + bytes([chance.randrange(256)]) + data[at + 1:])
        return "head of an array"
    path.write_bytes(data[: chance.randrange(len(data))])
    return "cut"


def damage(folder, chance):
    """Damages one file; returns what was done."""
    files = sorted(path for path in folder.rglob("*") if path.is_file())
    links = [path for path in files if path.name in ("Header", "Cell_H") or path.suffix in (".hierarchy", ".vthb")]
    headers = links + [path for path in files if path.with_name(path.name + ".hierarchy") in files]
    headers += [path for path in files if path.suffix == ".vti"]
    kind = chance.randrange(8)
    if kind < 5:
        path = chance.choice(headers)
        return f"{path.name}: {damage_header(path, chance)}"
    if kind == 5:
        path = chance.choice(links)
        return f"{path.name}: {damage_link(path, chance)}"
    path = chance.choice(files)
    return f"{path.name}: {damage_data(path, chance, [other for other in files if other != path])}"


def write(folder, kind, number):
    """A whole data set; returns its path, and the name of an array."""
    if kind == "plotfile":
        return write_plotfile(folder / "whole"), "density"
    if kind == "enzo":
        return write_enzo(folder / "whole"), "Density"
    return write_vthb(folder / "whole", ENCODINGS[number % len(ENCODINGS)]), "density"


def fuzz(program, count, seed, kind, file, array):
    """Prints what came of it; returns whether all was well."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        whole, picture = folder / "whole", folder / "picture.png"

        def render(path):
            picture.unlink(missing_ok=True)
            return subprocess.run([program, path, picture, "--array", array, "--size", "64x48"], timeout=SECONDS,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", check=False)

        counts = {"refused": 0, "the same picture": 0, "crashes": 0, "hangs": 0, "other pictures": 0, "no words": 0}
        expected = None
        for number in range(count):
            chance = random.Random(f"{seed} {number}")
            shutil.rmtree(whole, ignore_errors=True)
            if file:
                source = file if file.is_dir() else file.parent
                shutil.copytree(source, whole)
                path = whole / file.relative_to(source)
            else:
                path, array = write(folder, kind, number)
            if not expected:
                done = render(path)
                assert done.returncode == 0, done.stdout
                expected = picture.read_bytes()
            what = damage(whole, chance)
            try:
                done = render(path)
            except subprocess.TimeoutExpired:
                end = "hangs"
            else:
                end = "crashes" if done.returncode < 0 or done.returncode > 120 else \
                    "refused" if done.returncode > 0 and done.stdout.strip() else \
                    "no words" if done.returncode > 0 else \
                    "the same picture" if picture.read_bytes() == expected else "other pictures"
            counts[end] += 1
            if end not in ("refused", "the same picture"):
                kept = pathlib.Path(tempfile.gettempdir()) / f"damaged-{kind}-{seed}-{number}"
                shutil.rmtree(kept, ignore_errors=True)
                shutil.copytree(whole, kept, symlinks=True)
                print(f"{end}: {what}, kept as {kept}", flush=True)
        print(f"{kind}: " + ", ".join(f"{end}: {n}" for end, n in counts.items()), flush=True)
        return counts["refused"] + counts["the same picture"] == count


def main(program, count=100, seed=1, kind="all", file=None, array=None):
    kinds = ("plotfile", "enzo", "vthb") if kind == "all" else (kind,)
    return not all([fuzz(program, int(count), seed, kind, file and pathlib.Path(file), array) for kind in kinds])


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
