# SPDX-License-Identifier: BSD-3-Clause
"""exabricks.amr_from_arrays(): numpy arrays, drawn as AMR, without a copy where their memory is laid out as VTK's."""

import gc
import sys
import weakref

try:
    import numpy
except ImportError:
    print("there is no numpy to make arrays with")
    sys.exit(125)

from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkOverlappingAMR
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkRenderer, vtkVolume

import exabricks
from Bricks import bounds_of, bricks_of, range_of


def cells_of(amr, level=0, index=0):
    return amr.GetDataSet(level, index).GetCellData()


# A cube of 8^3 cells, of which the middle ones are refined.
coarse = numpy.arange(8.0**3).reshape((8, 8, 8))
fine = numpy.full((8, 8, 8), -1.0)
amr = exabricks.amr_from_arrays([(0, (0, 0, 0), coarse), (1, (4, 4, 4), fine)])
assert isinstance(amr, vtkOverlappingAMR)
data = bricks_of(amr)
assert (data.GetArrayName(), data.GetNumberOfLevels()) == ("values", 2), data
assert data.GetNumberOfLeafCells() == 8**3 - 4**3 + 8**3, data.GetNumberOfLeafCells()
assert range_of(data) == [-1.0, 8.0**3 - 1.0], range_of(data)
assert bounds_of(data) == [0.0, 8.0] * 3, bounds_of(data)

# Values lie where they belong, whatever the order of the memory: array[x, y, z] is the cell there.
for values in (coarse, numpy.asfortranarray(coarse), coarse.astype(">f4"), coarse[::-1, ::2][::-1].astype("i2")):
    array = cells_of(exabricks.amr_from_arrays([(0, (0, 0, 0), values)])).GetArray("values")
    nx, ny, _ = values.shape
    assert array.GetNumberOfTuples() == values.size
    for x, y, z in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (5, 3, 6)):
        assert array.GetTuple1(x + nx * (y + ny * z)) == values[x, y, z], (values.dtype, x, y, z)

# Somewhere in space, of any spacing, with several ratios, and arrays with names and components.
velocity = numpy.zeros((4, 4, 4, 3), "f4")
velocity[..., 1] = 2.0
blocks = [
    (0, (-2, 0, 0), {"p": numpy.ones((4, 4, 4)), "velocity": velocity}),
    (1, (-4, 0, 0), {"p": numpy.zeros((4, 4, 4), "u1"), "velocity": velocity}),
    (2, (-16, 0, 0), {"velocity": velocity, "p": numpy.full((4, 4, 4), 7.0)}),
]
amr = exabricks.amr_from_arrays(iter(blocks), spacing=(1.0, 2.0, 4.0), origin=(10.0, 0.0, 0.0), ratio=[2, 4])
data = bricks_of(amr)
assert data.GetArrayName() == "p"
assert bounds_of(data) == [8.0, 12.0, 0.0, 8.0, 0.0, 16.0], bounds_of(data)
assert data.GetNumberOfLeafCells() == (4**3 - 2**3) + (4**3 - 1) + 4**3, data.GetNumberOfLeafCells()
assert range_of(data) == [0.0, 7.0], range_of(data)
assert bricks_of(amr, "velocity").GetNumberOfLeafCells() == data.GetNumberOfLeafCells()
array = cells_of(amr).GetArray("velocity")
assert array.GetTuple3(9) == (0.0, 2.0, 0.0), array.GetTuple3(9)

# Levels may be without blocks, and of blocks that overlap the first one counts.
ones = numpy.ones((4, 4, 4))
data = bricks_of(exabricks.amr_from_arrays([(1, (0, 0, 0), ones), (3, (0, 0, 0), 2.0 * ones)]))
assert (data.GetNumberOfLevels(), data.GetNumberOfLeafCells()) == (2, 4**3 - 1 + 4**3), data
overlapping = [(0, (first, 0, 0), value * ones) for first, value in ((0, 1.0), (2, 5.0), (1, 9.0))]
data = bricks_of(exabricks.amr_from_arrays(overlapping))
assert data.GetNumberOfLeafCells() == 6 * 4 * 4 and range_of(data) == [1.0, 5.0], data

# VTK uses the memory of arrays that lie as its own do, and copies others.
from_z_y_x = numpy.zeros((3, 4, 5)).T
vectors = numpy.zeros((3, 4, 5, 2), "f4").transpose(2, 1, 0, 3)
frozen = numpy.asfortranarray(ones)
frozen.flags.writeable = False
for values, shared in ((from_z_y_x, True), (vectors, True), (frozen, True), (coarse, False), (from_z_y_x[1:], False)):
    amr = exabricks.amr_from_arrays([(0, (0, 0, 0), values)])
    assert numpy.shares_memory(numpy.asarray(cells_of(amr).GetArray("values")), values) == shared, values.strides
from_z_y_x[2, 1, 0] = 4.0
amr = exabricks.amr_from_arrays([(0, (0, 0, 0), from_z_y_x)])
from_z_y_x[2, 1, 0] = 5.0
assert cells_of(amr).GetArray("values").GetTuple1(2 + 5 * 1) == 5.0


# That memory lives as long as VTK's array, and no longer.
class Watched(numpy.ndarray):
    pass


memory = numpy.full(64**3, 3.0).view(Watched)
watch = weakref.ref(memory)
amr = exabricks.amr_from_arrays([(0, (0, 0, 0), memory.reshape((64, 64, 64), order="F"))])
del memory
gc.collect()
assert watch() is not None
kept = cells_of(amr).GetArray("values")
del amr
gc.collect()
assert watch() is not None and kept.GetRange() == (3.0, 3.0), kept.GetRange()
del kept
gc.collect()
assert watch() is None

# Types stay, but for half precision.
for kind in ("i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8"):
    array = cells_of(exabricks.amr_from_arrays([(0, (0, 0, 0), ones.astype(kind))])).GetArray("values")
    assert numpy.asarray(array).dtype == kind, (kind, array.GetClassName())
    assert array.GetRange() == (1.0, 1.0)
half = cells_of(exabricks.amr_from_arrays([(0, (0, 0, 0), ones.astype("f2"))])).GetArray("values")
assert half.GetDataTypeAsString() == "float" and half.GetRange() == (1.0, 1.0)


def refuses(kind, blocks, *words, **keywords):
    try:
        exabricks.amr_from_arrays(blocks, **keywords)
    except kind as error:
        message = str(error)
    else:
        raise AssertionError(f"expected a {kind.__name__}")
    print(message)
    for word in words:
        assert word in message, (word, message)


corner = (0, 0, 0)
good = (0, corner, ones)
refuses(ValueError, [], "at least one block")
refuses(TypeError, [good, (0, ones)], "blocks[1]", "(level, corner, values)")
refuses(TypeError, [(0.5, corner, ones)], "level", "whole", "0.5")
refuses(ValueError, [(-1, corner, ones)], "level", "-1")
refuses(TypeError, [(0, (0.0, 0, 0), ones)], "corner", "whole", "0.0")
refuses(ValueError, [(0, (0, 0), ones)], "three cell indices")
refuses(ValueError, [(0, (2**31 - 3, 0, 0), ones)], "32 bits", str(2**31 - 3))
refuses(ValueError, [(0, (0, -(2**31) - 1, 0), ones)], "32 bits", str(-(2**31) - 1))
refuses(ValueError, [(0, corner, ones[0])], "[x, y, z]", "(4, 4)")
refuses(ValueError, [(0, corner, ones[:0])], "at least one cell", "(0, 4, 4)")
refuses(ValueError, [(0, corner, {})], "at least one array")
refuses(ValueError, [(0, corner, {"a": ones, "b": ones[:2]})], "4 x 4 x 4", "2 x 4 x 4", "'b'")
refuses(TypeError, [(0, corner, {3: ones})], "text", "3")
refuses(ValueError, [good, (0, (4, 0, 0), {"other": ones})], "blocks[1]", "values", "other")
refuses(ValueError, [good, (0, (4, 0, 0), velocity)], "blocks[1]", "'values': 1", "'values': 3")
refuses(TypeError, [(0, corner, ones > 0)], "bool", "view(numpy.uint8)")
refuses(TypeError, [(0, corner, ones + 1j)], "complex128", ".real")
refuses(TypeError, [(0, corner, ones.astype(object))], "object", "astype(float)")
refuses(TypeError, [(0, corner, numpy.ma.masked_greater(coarse, 9))], "mask", "filled(numpy.nan)")
refuses(ValueError, [good], "spacing", "three", spacing=(1.0, 2.0))
refuses(ValueError, [good], "spacing", "above zero", spacing=0.0)
refuses(ValueError, [good], "origin", "finite", origin=(0.0, 0.0, float("nan")))
refuses(ValueError, [good], "at least 2", "1", ratio=1)
refuses(TypeError, [good], "ratio", "whole", "1.5", ratio=1.5)
refuses(ValueError, [good, (2, corner, ones)], "2 steps", "3 levels", "[2]", ratio=[2])

# And it draws: red where the fine cells are, green around them.
mapper = exabricks.vtkExaBricksVolumeMapper()
mapper.SetInputData(exabricks.amr_from_arrays([(0, corner, numpy.zeros((6, 6, 6))), (1, (4, 4, 0), ones)]))
volume = vtkVolume()
volume.SetMapper(mapper)
property_ = volume.GetProperty()
property_.GetRGBTransferFunction().AddRGBPoint(0.0, 0.0, 1.0, 0.0)
property_.GetRGBTransferFunction().AddRGBPoint(1.0, 1.0, 0.0, 0.0)
property_.GetScalarOpacity().AddPoint(0.0, 1.0)
property_.GetScalarOpacity().AddPoint(1.0, 1.0)
property_.SetScalarOpacityUnitDistance(0.01)
renderer = vtkRenderer()
renderer.AddVolume(volume)
renderer.GetActiveCamera().SetPosition(0.0, 0.0, -1.0)
renderer.ResetCamera()
renderer.GetActiveCamera().ParallelProjectionOn()
renderer.GetActiveCamera().SetParallelScale(3.0)
window = vtkRenderWindow()
window.SetMultiSamples(0)
window.SetSize(60, 60)
window.AddRenderer(renderer)
window.Render()
pixel = vtkUnsignedCharArray()
for place, color in (((30, 30), (255.0, 0.0, 0.0)), ((5, 30), (0.0, 255.0, 0.0)), ((30, 55), (0.0, 255.0, 0.0))):
    window.GetPixelData(*place, *place, 1, pixel, 0)
    assert pixel.GetTuple3(0) == color, (place, pixel.GetTuple3(0))
