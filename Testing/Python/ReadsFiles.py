# SPDX-License-Identifier: BSD-3-Clause
"""exabricks.read(): from a path to AMR with all its levels and arrays, or to words that say why not."""

import argparse
import contextlib
import math
import os
import pathlib
import shutil
import sys
import tempfile

sys.modules["numpy"] = None  # none of this may need it

from vtkmodules.vtkCommonCore import vtkLogger, vtkObject, vtkOutputWindow, vtkVersion
from vtkmodules.vtkCommonDataModel import vtkOverlappingAMR

import exabricks
from Bricks import bricks_of, range_of

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Programs"))
from AMRFiles import HDF5Writer, write_enzo, write_plotfile, write_vthb

arguments = argparse.ArgumentParser()
arguments.add_argument("-D", dest="data")
arguments, _ = arguments.parse_known_args()
rings = pathlib.Path(arguments.data) / "rt_medium" / "rt_medium.vthb"


def arrays_of(amr):
    cells = amr.GetDataSet(0, 0).GetCellData()
    return {cells.GetArrayName(i) for i in range(cells.GetNumberOfArrays())} - {"vtkGhostType"}


window = vtkOutputWindow.GetInstance()
verbosity = vtkLogger.GetCurrentVerbosityCutoff()

# All levels and arrays are read, or those that are asked for.
arrays = exabricks.list_arrays(rings)
assert list(arrays) == ["density", "magvort"], arrays
assert [info.components for info in arrays.values()] == [1, 1], arrays
(least, greatest), = arrays["magvort"].ranges
assert abs(greatest - 13.3944) < 1e-4 and 0 < least < 1e-4, arrays

amr = exabricks.read(rings)
assert isinstance(amr, vtkOverlappingAMR) and arrays_of(amr) == {"density", "magvort"}
amr = exabricks.read(str(rings), arrays="magvort")
assert arrays_of(amr) == {"magvort"}
data = bricks_of(amr)
assert data.GetArrayName() == "magvort"
assert (data.GetNumberOfLevels(), data.GetNumberOfLeafCells()) == (3, 549120), data
assert abs(range_of(data)[1] - 18.7710) < 1e-4
for levels, cells in ((1, 24 * 24 * 48), (2, 124416), (9, 549120)):
    data = bricks_of(exabricks.read(rings, levels=levels, arrays=["density", "magvort"]))
    assert data.GetArrayName() == "density"
    assert (data.GetNumberOfLevels(), data.GetNumberOfLeafCells()) == (min(levels, 3), cells), (levels, data)

with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)

    # The same cells in the files of several codes: 8^3, of which 4^3 are refined.
    paths = {
        "plotfile": (f"{write_plotfile(folder / 'plt00003')}/", "density"),
        "Enzo": (write_enzo(folder / "enzo"), "Density"),
        "vthb": (write_vthb(folder / "vthb"), "pressure"),
    }
    for kind, (path, name) in paths.items():
        assert name in exabricks.list_arrays(path), (kind, exabricks.list_arrays(path))
        (least, greatest), = exabricks.list_arrays(path)[name].ranges
        coarse = bricks_of(exabricks.read(path, levels=1, arrays=name))
        assert coarse.GetNumberOfLeafCells() == 8**3, (kind, coarse.GetNumberOfLeafCells())
        assert all(math.isclose(a, b) for a, b in zip(range_of(coarse), (least, greatest))), kind
        data = bricks_of(exabricks.read(path, arrays=name))
        assert data.GetArrayName() == name
        assert data.GetNumberOfLeafCells() == 8**3 - 4**3 + 8**3, (kind, data.GetNumberOfLeafCells())

    # What cannot be read is said, once, in an exception, and nowhere else.
    @contextlib.contextmanager
    def silent():
        """Nothing is written to the process's stderr."""
        with tempfile.TemporaryFile() as file:
            before = os.dup(2)
            os.dup2(file.fileno(), 2)
            try:
                yield
            finally:
                os.dup2(before, 2)
                os.close(before)
            file.seek(0)
            said = file.read().decode()
            assert not said, said

    assert issubclass(exabricks.ReadError, OSError)

    def refuses(path, *words, function=exabricks.read, **keywords):
        with silent():
            try:
                function(path, **keywords)
            except exabricks.ReadError as error:
                message = str(error)
            else:
                raise AssertionError(f"{path} was read")
        for word in words:
            assert word in message, (word, message)
        print(message)

    def write(name, content):
        path = folder / name
        path.write_bytes(content)
        return path

    refuses("no_such.vthb", "no_such.vthb", "check the path")
    refuses("no_such.vthb", "no_such.vthb", function=exabricks.list_arrays)
    refuses(__file__, ".vthb", ".hierarchy", ".vtkhdf", "plotfile")
    refuses(folder, "Header", "such as plt00216")
    refuses(os.path.dirname(rings), "Header", "Did you mean", "rt_medium.vthb")
    refuses(rings, "levels=0", "at least 1", levels=0)
    refuses(rings, "'magwort'", "did you mean 'magvort'?", "density, magvort", arrays=["density", "magwort"])
    refuses(rings, "'MAGVORT'", "did you mean 'magvort'?", arrays="MAGVORT")
    refuses(rings, "'xyz'", "choose of density, magvort", arrays="xyz")
    refuses(rings, "at least one", arrays=[])

    refuses(write("broken.vthb", b"<VTKFile type='vtkOverlappingAMR' version='1.1'><vtkOverl"), "broken.vthb")
    copy = shutil.copytree(rings.parent, folder / "rt")
    (folder / "rt" / "rt_medium" / "rt_medium_7.vti").unlink()
    refuses(pathlib.Path(copy) / rings.name, "rt_medium_7.vti")
    vtkObject.GlobalWarningDisplayOff()  # a program may have asked VTK to be quiet
    refuses(pathlib.Path(copy) / rings.name, "rt_medium_7.vti")
    assert not vtkObject.GetGlobalWarningDisplay()
    vtkObject.GlobalWarningDisplayOn()

    (folder / "plt00003" / "Level_1" / "Cell_D_00000").write_bytes(b"FAB")
    refuses(f"{folder}/plt00003/", "plt00003' is damaged", "Cell_D_00000", "Copy it anew")
    (folder / "plt00003" / "Header").write_text("hello")
    refuses(folder / "plt00003", "Header", "HyperCLaw-V1.1")

    refuses(write("hello.hierarchy", b"hello"), "hello.hierarchy", "'Grid = 1'")
    os.remove(paths["Enzo"][0].with_suffix(""))
    refuses(paths["Enzo"][0], "data0003'", "parameters", "copy it there")

    refuses(write("hello.hdf5", b"hello".ljust(200, b"\0")), "not an HDF5 file")
    writer = HDF5Writer()
    writer.write(folder / "other.hdf5", writer.add_group({"numbers": writer.add_doubles([1.0, 2.0], [2])}))
    refuses(folder / "other.hdf5", "other.hdf5", "holds no blocks", "Invalid Flash file")
    refuses(write("short.hdf5", (folder / "other.hdf5").read_bytes()[:-7]), "damaged", "Copy it anew")
    other = shutil.copy(folder / "other.hdf5", folder / "other.vtkhdf")
    old = vtkVersion().GetVTKMajorVersion() == 9 and vtkVersion().GetVTKMinorVersion() < 3
    refuses(other, "other.vtkhdf", "VTK 9.3 or later" if old else "could not be read")
    sys.modules["vtkmodules.vtkIOHDF"] = None
    refuses(other, "module vtkIOHDF")

# VTK speaks as before.
assert vtkOutputWindow.GetInstance() is window
assert vtkLogger.GetCurrentVerbosityCutoff() == verbosity

try:
    exabricks.read(rings, levels=1.5)
except TypeError:
    pass
else:
    raise AssertionError("expected a TypeError")
