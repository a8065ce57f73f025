#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes inputs for FuzzFileCheck.cxx to begin with: whole data sets of each kind.

Usage: FuzzCorpus.py FOLDER
"""

import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "Programs"))
from AMRFiles import ENCODINGS, write_enzo, write_plotfile, write_vthb  # noqa: E402

FILES = {
    "plotfile": ["Header", "Level_0/Cell_H", "Level_0/Cell_D_00000", "Level_1/Cell_H", "Level_1/Cell_D_00000"],
    "enzo": ["data0003.hierarchy", "data0003", "data0003.cpu0000", "data0003.cpu0001"],
    "vthb": ["data.vthb", "data/data_0.vti", "data/data_1.vti", "data/data_2.vti"],
}

for kind, files in FILES.items():
    target = pathlib.Path(sys.argv[1]) / kind
    target.mkdir(parents=True)
    for encoding in ENCODINGS if kind == "vthb" else ["raw"]:
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name) / "whole"
            if kind == "vthb":
                write_vthb(folder, encoding)
            else:
                {"plotfile": write_plotfile, "enzo": write_enzo}[kind](folder)
            data = b"\n=====\n".join((folder / file).read_bytes() for file in files)
            (target / encoding.replace(" ", "-")).write_bytes(kind[0].encode() + data)
