# SPDX-License-Identifier: BSD-3-Clause
"""exabricks.amr_from_yt(): the grids of yt's data sets, the same cells and values as VTK's readers find."""

import math
import os
import pathlib
import sys
import tempfile

try:
    import numpy
    import yt
except ImportError as error:
    print(f"there is no {error.name} to read with")
    sys.exit(125)

import exabricks
from Bricks import bounds_of, bricks_of, range_of

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Programs"))
from AMRFiles import write_enzo, write_plotfile

yt.set_log_level("error")


def figures_of(data):
    numbers = [data.GetNumberOfBlocks(), data.GetNumberOfLevels(), data.GetNumberOfLeafCells()]
    return [*numbers, *range_of(data), *bounds_of(data)]


def grid(level, left, right, cells, values):
    return {"level": level, "left_edge": left, "right_edge": right, "dimensions": cells, "density": (values, "g/cm**3")}


# In memory: 16^3 cells, of which 2 x 4 x 4 are refined, four times, and what yt derives of them.
coarse = numpy.arange(16.0**3).reshape((16, 16, 16))
fine = numpy.full((8, 16, 16), -1.0)
grids = [
    grid(0, [-1.0, 0.0, 0.0], [1.0, 2.0, 4.0], [16, 16, 16], coarse),
    grid(1, [0.0, 0.5, 1.0], [0.25, 1.0, 2.0], [8, 16, 16], fine),
]
grids[0].update({("io", f"particle_position_{axis}"): numpy.ones(1) for axis in "xyz"})
bbox = numpy.array([[-1.0, 1.0], [0.0, 2.0], [0.0, 4.0]])
dataset = yt.load_amr_grids(grids, [16, 16, 16], refine_by=4, bbox=bbox)
amr = exabricks.amr_from_yt(dataset, [("gas", "density"), "cell_volume", ("index", "x"), ("gas", "x")])
cells = amr.GetDataSet(0, 0).GetCellData()
names = {cells.GetArrayName(i) for i in range(cells.GetNumberOfArrays())}
assert names == {"density", "cell_volume", "index_x", "gas_x"}, names
x, y, z = 5, 7, 11
assert cells.GetArray("density").GetTuple1(x + 16 * (y + 16 * z)) == coarse[x, y, z]
assert math.isclose(cells.GetArray("index_x").GetTuple1(x), -1.0 + 2.0 * (x + 0.5) / 16)
assert math.isclose(cells.GetArray("cell_volume").GetTuple1(x), 0.125 * 0.125 * 0.25)
data = bricks_of(amr)
assert data.GetArrayName() == "density"
expected = [2, 2, 16**3 - 2 * 4 * 4 + 8 * 16 * 16, -1.0, 16.0**3 - 1.0, -1.0, 1.0, 0.0, 2.0, 0.0, 4.0]
assert all(math.isclose(a, b) for a, b in zip(figures_of(data), expected)), figures_of(data)
data = bricks_of(exabricks.amr_from_yt(dataset, "density", levels=1))
assert figures_of(data)[:5] == [1, 1, 16**3, 0.0, 16.0**3 - 1.0], figures_of(data)

# In files: as exabricks.read() has it. VTK's reader turns Enzo's values into grams, by a factor in the file.
with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    plotfile = write_plotfile(folder / "plt00003")
    enzo = write_enzo(folder / "DD0003")
    with open(enzo.with_suffix(""), "a", encoding="ascii") as parameters:
        # What VTK does without, and yt does not.
        parameters.write("LeftFaceBoundaryCondition = 3 3 3\nGamma = 1.4\n")
        for name in ("ComovingCoordinates", "DualEnergyFormalism", "HydroMethod", "MultiSpecies", "NumberOfParticles"):
            parameters.write(f"{name} = 0\n")
    for path, loaded, field, factor in (
        (plotfile, yt.load(str(plotfile)), ("boxlib", "density"), 1.0),
        (enzo, yt.load(str(enzo.with_suffix(""))), ("enzo", "Density"), 0.25),
    ):
        for levels in (None, 1):
            data = bricks_of(exabricks.amr_from_yt(loaded, field, levels=levels))
            read = bricks_of(exabricks.read(path, arrays=field[1], levels=levels))
            assert data.GetNumberOfLeafCells() == (8**3 if levels else 8**3 - 4**3 + 8**3), figures_of(data)
            of_yt, of_vtk = figures_of(data), figures_of(read)
            of_yt[3:5] = [factor * value for value in of_yt[3:5]]
            print(path.name, of_yt, of_vtk)
            assert all(math.isclose(a, b, rel_tol=1e-12, abs_tol=1e-12) for a, b in zip(of_yt, of_vtk)), (of_yt, of_vtk)


def refuses(dataset, fields, *words, **keywords):
    try:
        exabricks.amr_from_yt(dataset, fields, **keywords)
    except ValueError as error:
        message = str(error)
    else:
        raise AssertionError("expected a ValueError")
    print(message)
    for word in words:
        assert word in message, (word, message)


refuses(dataset, ("gas", "densty"), "('gas', 'densty')", "('gas', 'density')")
refuses(dataset, "densty", "'densty'", "('gas', 'density')")
refuses(dataset, ("io", "particle_ones"), "fields of cells", "'particle'")
refuses(dataset, [], "at least one field")
refuses(dataset, "density", "at least 1 level", "levels=0", levels=0)

flat = yt.load_uniform_grid({"density": coarse[:, :, :1]}, [16, 16, 1])
refuses(flat, "density", "3 dimensions", "StreamDataset", "2")
wedge = yt.load_uniform_grid({"density": coarse}, coarse.shape, bbox=bbox + 1.5, geometry="cylindrical")
refuses(wedge, "density", "cartesian", "cylindrical")
places = {f"particle_position_{axis}": numpy.linspace(0.1, 0.9, 8) for axis in "xyz"}
refuses(yt.load_particles({**places, "particle_mass": numpy.ones(8)}), "density", "grids", "StreamParticlesDataset")
octree = yt.load_octree(numpy.zeros(1, "u1"), {"density": numpy.ones((8, 1))}, num_zones=2, partial_coverage=0)
refuses(octree, "density", "grids", "StreamOctreeDataset", "arbitrary_grid()", "amr_from_arrays()")
