#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""vtkExaBricksFileCheck: whole files have no fault; of damaged ones it says what was expected and found where."""

import pathlib
import tempfile

from AMRFiles import ENCODINGS, write_enzo, write_plotfile, write_vthb

from exabricks import vtkExaBricksFileCheck


def replace(path, old, new):
    text = path.read_bytes()
    assert text.count(old) >= 1, (path, old)
    path.write_bytes(text.replace(old, new, 1))


# What is done to a file, and words of the fault that is found.
PLOTFILE = (
    ("Header", b"HyperCLaw", b"SomethingElse", ["of a kind that is not read", "HyperCLaw-V1.1", "line 1", "SomethingElse"]),
    ("Header", b"\n3\n0.5", b"\n2\n0.5", ["of a kind that is not read", "the number of dimensions, 3", "'2'"]),
    ("Header", b"\n0\n0\n0 1", b"\n1\n0\n0 1", ["of a kind that is not read", "Cartesian"]),
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

LIST, PARAMETERS = "data0003.hierarchy", "data0003"
ENZO = (
    (LIST, b"Grid = 2", b"Grid = 3", ["the number of the next grid, 2", "line 21", "'3'"]),
    (LIST, b"GridRank          = 3", b"GridRank          = 2", ["of a kind that is not read", "GridRank", "'2'"]),
    (LIST, b"GridRightEdge", b"GridRiteEdge", ["'GridRightEdge = '", "'NumberOfBaryonFields'"]),
    (LIST, b"GridEndIndex      = 10 10 10", b"GridEndIndex      = 10 10 9", ["ghost cells on both sides", "cells from 3 to 9 of 14"]),
    (LIST, b"GridEndIndex      = 10 10 10", b"GridEndIndex      = 10 10", ["GridEndIndex", "'GridLeftEdge'"]),
    (LIST, b"GridDimension     = 14", b"GridDimension     = 1000000000", ["from 0 to 1048576", "'1000000000'"]),
    (LIST, b"GridLeftEdge      = 0 0 0", b"GridLeftEdge      = 0 0 nan", ["a finite number", "'nan'"]),
    (LIST, b"GridLeftEdge      = 0 0 0", b"GridLeftEdge      = 0 0 2", ["a right edge beyond the left one", "1 after 2"]),
    (LIST, b"GridLeftEdge      = 0 0 0", b"GridLeftEdge      = 0 0 -1", ["grid 1 to have cells of width 0.125, found 0.25"]),
    (LIST, b"GridLeftEdge      = 0.25", b"GridLeftEdge      = 0.26", ["grid 2 to have cells of width 0.0625, found 0.06"]),
    (LIST, b"GridLeftEdge      = 0.5 0.25 0.25", b"GridLeftEdge      = 0.5  .25 0.25 1", ["the end of the line", "'1'"]),
    (LIST, b"NumberOfParticles   = 0", b"NumberOfParticles   = 7", ["'ParticleFileName = '", "'Pointer:'"]),
    (LIST, b"[1]->NextGridNextLevel = 2", b"[1]->NextGridNextLevel = 0", ["grid 2 to have a pointer to it"]),
    (LIST, b"[2]->NextGridThisLevel = 3", b"[2]->NextGridThisLevel = 1", ["a pointer to a grid behind it", "grid 1 of 3"]),
    (LIST, b"[2]->NextGridThisLevel = 3", b"[2]->NextGridThisLevel = 9", ["a pointer to a grid behind it", "grid 9 of 3"]),
    (LIST, b"[2]->NextGridThisLevel", b"[8]->NextGridThisLevel", ["the number of a grid before from 1 to 2", "'8"]),
    (LIST, b"Pointer: Grid[2]->NextGridNextLevel = 0", b"", ["grid 2 to have pointers"]),
    (LIST, b"data0003.cpu0001", b"data0003.cpu0000", ["grid 3 to have a group in 'data0003.cpu0000', found none"]),
    (LIST, b"data0003.cpu0001", b"data0003.cpu0009", ["data0003.cpu0009", "none that can be read"]),
    (LIST, b"data0003.cpu0001", b".", ["none that can be read"]),
    (PARAMETERS, b"TopGridRank         = 3", b"", ["'TopGridRank = '", "none"]),
    (PARAMETERS, b"TopGridRank         = 3", b"TopGridRank         = 1", ["of a kind that is not read", "TopGridRank"]),
    (PARAMETERS, b"= 8 8 8", b"= 8 8 16", ["grid 1 to have cells of width 0.0625, found 0.125"]),
    (PARAMETERS, b"RefineBy               = 2", b"RefineBy               = 4", ["grid 2 to have cells of width 0.03125"]),
    (PARAMETERS, b"InitialTime         = 0.5", b"InitialTime         = soon", ["a time", "'soon'", "line 2"]),
    (PARAMETERS, b"ConversionFactor[0] = 0.25", b"ConversionFactor[0] = 0", ["a factor above zero"]),
    (PARAMETERS, b"DataLabel[0]", b"DataLabel[", ["the number of a field", "line 10"]),
    (PARAMETERS, b"DataLabel[0]              = Density", b"", ["a 'DataLabel' for each of its 1 fields"]),
    ("data0003.cpu0001", b"HDF", b"HDG", ["expected an HDF5 file in 'data0003.cpu0001'"]),
    ("data0003.cpu0001", b"Grid00000003", b"Grid00000004", ["grid 3 to have a group"]),
    ("data0003.cpu0001", b"SNOD", b"SNOB", ["a table of symbols at byte"]),
    ("data0003.cpu0001", b"\x08\0\0\0\0\0\0\0\x08\0\0\0\0\0\0\0\x04\0", b"\x08\0\0\0\0\0\0\0\x08\0\0\0\0\0\0\0\x05\0",
     ["4 values of 'Density'", "5"]),
)

AMR, VTI = "data.vthb", "data/data_1.vti"
VTHB = (
    (AMR, b"<VTKFile", b"<VTKFeil", ["'</VTKFeil>'", "line 16"]),
    (AMR, b"</vtkOverlappingAMR>", b"", ["'</vtkOverlappingAMR>'", "'</VTKFile>'"]),
    (AMR, b'"vtkOverlappingAMR"', b'"vtkMultiBlockDataSet"', ["of a kind that is not read", "vtkMultiBlockDataSet"]),
    (AMR, b'version="1.1"', b'version="0.1"', ["of a kind that is not read", "a version from 1.1"]),
    (AMR, b'description="XYZ"', b'description="XY"', ["of a kind that is not read", "3-D"]),
    (AMR, b'level="1"', b'level="1000000000"', ["a number in 'level', 1", "line 6", "'1000000000'"]),
    (AMR, b'spacing="0.125 ', b'spacing="-0.125 ', ["a spacing above zero"]),
    (AMR, b'spacing="0.125 ', b'spacing="nan ', ["a finite number", "'nan'"]),
    (AMR, b'spacing="0.125 ', b'spacing="0.15 ', ["a whole refinement ratio", "2.4 along one"]),
    (AMR, b'index="1"', b'index="7"', ["a number in 'index', 1", "line 8", "'7'"]),
    (AMR, b"7 4 11 4 11", b"3 4 11 4 11", ["1 to 2^20 cells", "0 along one"]),
    (AMR, b"7 4 11 4 11", b"99999999999 4 11 4 11", ["a number in 'amr_box' from -1073741824 to 1073741824"]),
    (AMR, b"7 4 11 4 11", b"7 4 11 4 31", ["inside the bounds of the coarser level", "line 7"]),
    (AMR, b"7 4 11 4 11", b"7 4 11 4 11 4", ["6 numbers in 'amr_box'", "more"]),
    (AMR, b"4 7 4 11 4 11", b"5 8 4 11 4 11", ["an origin where the amr_box is", VTI]),
    (AMR, b"data/data_1.vti", b"data/data_9.vti", ["data_9.vti", "none that can be read"]),
    (AMR, b"data/data_1.vti", b"data/data_2.vti", ["an origin where the amr_box is"]),
    (AMR, b"data/data_1.vti", b"data.vthb", ["the name of a .vti file"]),
    (AMR, b' file="data/data_1.vti"', b' feil="data/data_1.vti"', ["a 'file', or 'index' and 'amr_box' alone"]),
    (AMR, b"<DataSet", b" DataSet", ["nothing but elements inside 'Block'", "text"]),
    (AMR, b'NumberOfTuples="1"', b'NumberOfTuples="1000000000"', ["8000000000 bytes of data", "found 8"]),
    (AMR, b'type="Float64"', b'type="Float46"', ["a type of VTK's values", "Float46"]),
    (VTI, b'"ImageData" v', b'"PolyData" v', ["the type 'ImageData'", VTI]),
    (VTI, b'Extent="0 4 0 8 0 8" O', b'Extent="0 4 0 8 0 9" O', ["the Extent of all", "'0 4 0 8 0 8'"]),
    (VTI, b'Origin="0.25', b'Origin="0.28', ["an origin where the amr_box is", "(0.28, 0.25, 0.25)"]),
    (VTI, b'Spacing="0.0625', b'Spacing="0.0675', ["the spacing of the level, 0.0625"]),
    (VTI, b'Name="pressure"', b'Name="density"', ["names of their own", "'density'"]),
    (VTI, b'Name="pressure"', b'Name="pressure" NumberOfComponents="3"', ["6144 bytes of data", "2048"]),
    (VTI, b'offset="2052"', b'offset="0"', ["the end of the appended data"]),
    (VTI, b'offset="2052"', b'offset="2053"', ["line 8"]),
    (VTI, b"_\0\x08", b"_\0\x07", ["2048 bytes of data", "1792"]),
    (VTI, b"_\0\x08\0\0", b"_\0\x08\0\x7f", ["bytes of data from byte", "up to their end"]),
    (VTI, b"UInt32", b"UInt64", ["from byte"]),
    (VTI, b"</AppendedData>", b"", ["the end of the appended data and of the file"]),
)


def check(folder, write, damages, data):
    """Each damage is found; and so is a data file that was cut, or is a folder."""
    for number, (file, old, new, words) in enumerate(damages):
        path = write(folder / str(number))
        assert vtkExaBricksFileCheck.CanCheck(str(path))
        assert vtkExaBricksFileCheck.FindFault(str(path)) == "", vtkExaBricksFileCheck.FindFault(str(path))
        replace(folder / str(number) / file, old, new)
        fault = vtkExaBricksFileCheck.FindFault(str(path))
        print(fault)
        assert "expected" in fault and "found" in fault and all(word in fault for word in words), (fault, words)
    path = write(folder / "short")
    file = folder / "short" / data
    whole = file.read_bytes()
    for length in (len(whole) - 2, len(whole) - 40, len(whole) // 2, 1, 0):
        file.write_bytes(whole[:length])
        assert "expected" in vtkExaBricksFileCheck.FindFault(str(path)), length
    file.unlink()
    file.mkdir()
    assert "none that can be read" in vtkExaBricksFileCheck.FindFault(str(path))


with tempfile.TemporaryDirectory() as name:
    top = pathlib.Path(name)
    check(top / "plotfiles", write_plotfile, PLOTFILE, "Level_1/Cell_D_00000")
    check(top / "enzo", write_enzo, ENZO, "data0003.cpu0001")

    def write_inline(folder):
        return write_vthb(folder, "binary")

    check(top / "vthb", write_vthb, VTHB, "data/data_2.vti")
    check(top / "inline", write_inline, [
        (VTI, b'format="binary"', b'format="ascii"', ["256 values", "found 1"]),
        (VTI, b'format="binary"', b'format="appended"', ["'binary' or 'ascii' without"]),
        (VTI, b"AAgAAA", b"AAgA", ["line 7"]),
        (VTI, b"</DataArray>", b"AAAA</DataArray>", ["data of 2048 bytes", "more"]),
        (VTI, b"</CellData>", b"<DataArray/></CellData>", ["a value of 'Name' of 'DataArray'"]),
    ], "data/data_2.vti")

    for number, encoding in enumerate(ENCODINGS):
        assert vtkExaBricksFileCheck.FindFault(str(write_vthb(top / f"encoding{number}", encoding))) == "", encoding
    # Ghost cells: a grid that is larger than its box, where they are marked.
    path = write_vthb(top / "ghosts")
    replace(path, b"8 11 4 11 4 11", b"8 11 5 10 4 11")
    assert "6 cells of the amr_box" in vtkExaBricksFileCheck.FindFault(str(path))
    replace(path.parent / "data" / "data_2.vti", b'"pressure"', b'"vtkGhostType"')
    assert vtkExaBricksFileCheck.FindFault(str(path)) == "", vtkExaBricksFileCheck.FindFault(str(path))
    # A block that is not there.
    path = write_vthb(top / "null")
    replace(path, b' file="data/data_2.vti"', b"")
    assert vtkExaBricksFileCheck.FindFault(str(path)) == ""

    assert not vtkExaBricksFileCheck.CanCheck(name)
    assert not vtkExaBricksFileCheck.CanCheck(name + "/nothing.vthb")
    assert "no file or folder" in vtkExaBricksFileCheck.FindFault(name + "/nothing.vthb")
    assert vtkExaBricksFileCheck.FindFault(name) == ""  # of other kinds of files nothing is known
