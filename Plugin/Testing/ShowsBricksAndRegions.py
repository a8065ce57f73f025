# SPDX-License-Identifier: BSD-3-Clause
"""The filter shows bricks and regions as cells; the source makes scenes with a surface inside."""

from Support import *

load_plugin()
scene = make_scene()
surface = simple.OutputPort(scene, 1)
assert surface.GetDataInformation().GetNumberOfCells() > 0

cells = simple.ExaBricksCells(Input=scene)
assert list(cells.SelectInputScalars) in (["CELLS", "value"], ["", "value"]), cells.SelectInputScalars
cells.UpdatePipeline()
bricks = cells.GetDataInformation().GetNumberOfCells()
assert cells.CellData["Level"].GetRange() == (0.0, 3.0), cells.CellData["Level"].GetRange()
assert cells.CellData["Cells"].GetNumberOfComponents() == 3
low, high = cells.CellData["Range"].GetRange(1)
assert 0.0 <= low <= high <= 1.0, (low, high)

cells.Cells = "Regions"
cells.UpdatePipeline()
regions = cells.GetDataInformation().GetNumberOfCells()
assert cells.CellData["BrickCount"].GetRange()[1] > 1
view = make_view()
display = show(scene, view)
look_at(scene, view)
picture(view, "volume")
line = statistics(display)
assert f"{bricks} bricks" in line and f"{regions} regions" in line, (bricks, regions, line)

# They are where the data are.
found = cells.GetDataInformation().GetBounds()
expected = scene.GetDataInformation().GetBounds()
assert max(abs(a - b) for a, b in zip(found, expected)) < 1e-6 * abs(expected[1] - expected[0]), (found, expected)
simple.Hide(scene, view)


def surface(source, name):
    """All of the data in one color, unlit."""
    shown = simple.Show(source, view)
    shown.SetRepresentationType("Surface")
    shown.ColorArrayName = ["POINTS", ""]
    shown.AmbientColor = shown.DiffuseColor = [1.0, 1.0, 1.0]
    shown.Ambient, shown.Diffuse = 1.0, 0.0
    pixels = picture(view, name)
    simple.Hide(source, view)
    return pixels


filled = surface(scene, "data")
assert 0.1 < drawn(filled) < 0.9, drawn(filled)
expect_alike(surface(cells, "regions"), filled, 30.0, "the regions fill what the data fill")
cells.Cells = "Bricks"
expect_alike(surface(cells, "bricks"), filled, 30.0, "and so do the bricks")

# Of an AMR with nothing in it there are none, and that is no fault.
empty = make_empty()
none = simple.ExaBricksCells(Input=empty)
none.UpdatePipeline()
assert none.GetDataInformation().GetNumberOfCells() == 0
