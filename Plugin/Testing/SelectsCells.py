# SPDX-License-Identifier: BSD-3-Clause
"""Selecting cells in the view, which hovering does too: those that are seen first, in their blocks of the AMR."""

from Support import *
from paraview.servermanager import vtkSMProxyManager

load_plugin()
scene = make_scene()
view = make_view()
display = show(scene, view)
display.OpacityUnitDistance = 8.0
simple.Render(view)  # the first time, the camera is placed
look_at(scene, view)
before = picture(view, "before")


def select(region, cells=True):
    """The cells that are selected in `region` (pixels, from the lower left corner): (number of the block, of the cell)."""
    simple.ClearSelection(scene)
    if cells:
        simple.SelectSurfaceCells(Rectangle=region, View=view)
    else:
        simple.SelectSurfacePoints(Rectangle=region, View=view)
    selection = scene.GetSelectionInput(0)
    if not selection:
        return []
    ids = list(selection.Input[0].IDs)
    return list(zip(ids[0::3], ids[2::3]))


def bounds_and_value(block, cell):
    amr = scene.GetClientSideObject().GetOutputDataObject(0)
    blocks = amr.NewIterator()
    blocks.InitTraversal()
    while blocks.GetCurrentFlatIndex() != block:
        blocks.GoToNextItem()
    grid = blocks.GetCurrentDataObject()
    bounds = [0.0] * 6
    grid.GetCellBounds(cell, bounds)
    return numpy.array(bounds[::2]), numpy.array(bounds[1::2]), grid.GetCellData().GetArray("value").GetValue(cell)


# One pixel shows one cell, on its line of sight, that is opaque or behind some that are.
drawn = numpy.argwhere(before.max(axis=-1) > 0.25)
y, x = (int(at) for at in drawn[len(drawn) // 2])
found = select([x, y, x, y])
assert len(found) == 1, found
low, high, value = bounds_and_value(*found[0])
assert value > 0.1, f"a cell that shows, of {value}"

ratio = before.shape[1] / before.shape[0]
up = math.tan(math.radians(0.5 * view.CameraViewAngle))
axis = numpy.subtract(view.CameraFocalPoint, view.CameraPosition)
axis /= numpy.linalg.norm(axis)
right = numpy.cross(axis, view.CameraViewUp)
right /= numpy.linalg.norm(right)
way = axis + up * ratio * (2.0 * (x + 0.5) / before.shape[1] - 1.0) * right \
    + up * (2.0 * (y + 0.5) / before.shape[0] - 1.0) * numpy.cross(right, axis)
ends = numpy.sort([(low - view.CameraPosition) / way, (high - view.CameraPosition) / way], axis=0)
margin = 1e-3 * numpy.max(ends)
assert ends[0].max() < ends[1].min() + margin, "the cell is on the line of sight"

# Of an area there are several, of several blocks.
area = [x - 20, y - 20, x + 20, y + 20]
found = select(area)
assert len(found) > 10 and len(set(found)) == len(found) and len({block for block, _ in found}) > 1, found

# Where nothing is drawn, nothing is selected; nor are points.
assert before[2, 2].max() == 0.0 and not select([0, 0, 4, 4])
assert not select([x, y, x, y], cells=False)

# They can be extracted, and are marked; ParaView 5.11 does neither for the AMR of any representation. The picture is as it
# was without them.
found = select(area)
if (vtkSMProxyManager.GetVersionMajor(), vtkSMProxyManager.GetVersionMinor()) > (5, 11):
    extract = simple.ExtractSelection(Input=scene, Selection=scene.GetSelectionInput(0))
    extract.UpdatePipeline()
    assert extract.GetDataInformation().GetNumberOfCells() == len(found), extract.GetDataInformation().GetNumberOfCells()
    simple.Delete(extract)
    expect_different(picture(view, "marked"), before, 60.0, "selected cells are marked")
simple.ClearSelection(scene)
expect_alike(picture(view, "after"), before, 90.0, "the picture afterwards")
