#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""vtkExaBricksFileCheck: a whole plotfile has no fault; of a damaged one it says what was expected and found where."""

import pathlib
import tempfile

from FuzzPlotfiles import write_plotfile

from exabricks import vtkExaBricksFileCheck


def replace(path, old, new):
    text = path.read_bytes()
    assert text.count(old) >= 1, (path, old)
    path.write_bytes(text.replace(old, new, 1))


# What is done to a file, and words of the fault that is found.
DAMAGES = (
    ("Header", b"HyperCLaw", b"SomethingElse", ["HyperCLaw-V1.1", "line 1", "SomethingElse"]),
    ("Header", b"\n3\n0.5", b"\n2\n0.5", ["the number of dimensions, 3", "'2'"]),
    ("Header", b"0.0625 0.0625", b"0.05 0.0625", ["fill the domain"]),
    ("Header", b"1 2 0.5", b"1 3 0.5", ["a bound of a box", "Level_1/Cell"]),
    ("Header", b"Level_1/Cell", b"../Level_1/Cell", ["inside the plotfile"]),
    ("Header", b"Level_1/Cell", b"Level_7/Cell", ["Level_7", "none that can be read"]),
    ("Level_1/Cell_H", b"(2 0", b"(1000000000 0", ["the number of boxes that 'Header' has, 2", "'1000000000'"]),
    ("Level_1/Cell_H", b"(11,11,11)", b"(11,99,11)", ["inside the domain"]),
    ("Level_1/Cell_H", b"(11,11,11)", b"(11,10,11)", ["where 'Header' has it"]),
    ("Level_1/Cell_H", b"Cell_D_00000 0", b"Cell_D_00000 17", ["'F'"]),
    ("Level_1/Cell_H", b"Cell_D_00000 0", b"/etc/passwd 0", ["a file beside this one"]),
    ("Level_1/Cell_D_00000", b"(8 7 6 5 4 3 2 1)", b"(8 7 6 5 1 3 2 1)", ["a byte's place"]),
    ("Level_0/Cell_D_00000", b" 1\n", b" 1\n\n", ["up to byte"]),
)

with tempfile.TemporaryDirectory() as name:
    for number, (file, old, new, words) in enumerate(DAMAGES):
        folder = pathlib.Path(name) / f"plt{number:05}"
        write_plotfile(folder)
        assert vtkExaBricksFileCheck.CanCheck(str(folder))
        assert vtkExaBricksFileCheck.FindFault(str(folder)) == ""
        replace(folder / file, old, new)
        fault = vtkExaBricksFileCheck.FindFault(str(folder))
        print(fault)
        assert "expected" in fault and "found" in fault and all(word in fault for word in words), (fault, words)

    short = pathlib.Path(name) / "short"
    write_plotfile(short)
    data = short / "Level_1" / "Cell_D_00000"
    data.write_bytes(data.read_bytes()[:-1])
    assert "bytes of values" in vtkExaBricksFileCheck.FindFault(str(short))
    assert not vtkExaBricksFileCheck.CanCheck(name)
    assert vtkExaBricksFileCheck.FindFault(name) == ""  # of other kinds of files nothing is known
