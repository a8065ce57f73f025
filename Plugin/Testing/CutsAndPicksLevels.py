# SPDX-License-Identifier: BSD-3-Clause
"""Iso-surfaces, slices, cropping, a range of levels, the material, arrays of two components and two arrays."""

import textwrap

from Support import *



def change_cells(script):
    """The scene with `cells`, the cell data of each block, changed by a script."""
    changed = simple.ProgrammableFilter(Input=scene, CopyArrays=1)
    changed.Script = """
from vtkmodules.vtkCommonCore import vtkDoubleArray
output = self.GetOutputDataObject(0)
output.ShallowCopy(self.GetInputDataObject(0, 0))
place = output.NewIterator()
place.InitTraversal()
while not place.IsDoneWithTraversal():
    cells = place.GetCurrentDataObject().GetCellData()
""" + textwrap.indent(script, "    ") + """
    place.GoToNextItem()
"""
    return changed


load_plugin()
collector = Collector()
scene = make_scene()
view = make_view()
display = show(scene, view)
look_at(scene, view)
display.OpacityUnitDistance = 8.0
whole = picture(view, "whole")

display.BlendMode = "Isosurface"
display.IsosurfaceValues = [0.3]
surface = picture(view, "surface")
assert drawn(surface) > 0.02, drawn(surface)
display.IsosurfaceValues = [0.3, 0.6]
expect_different(picture(view, "surfaces"), surface, 60.0, "two surfaces")
display.Shading = 1
lit = picture(view, "lit")
expect_alike(picture(view, "litAgain"), lit, 60.0, "lit twice")
display.Ambient = 1.0
display.Diffuse = 0.0
expect_different(picture(view, "ambient"), lit, 45.0, "another material")
display.Ambient = 0.0
display.Diffuse = 1.0
display.Shading = 0

display.BlendMode = "Slice"
display.SliceFunction = "Plane"
center = view.CameraFocalPoint
display.SliceFunction.Origin = list(center)
display.SliceFunction.Normal = [0.0, 0.0, 1.0]
slice = picture(view, "slice")
assert drawn(slice) > 0.02, drawn(slice)
display.SliceFunction.Normal = [1.0, 0.0, 0.0]
expect_different(picture(view, "otherSlice"), slice, 45.0, "another plane")

display.BlendMode = "Composite"
expect_alike(picture(view, "wholeAgain"), whole, 60.0, "composite again")
bounds = scene.GetDataInformation().GetBounds()
display.Cropping = 1
display.CroppingRegionPlanes = [bounds[0], center[0], bounds[2], bounds[3], bounds[4], bounds[5]]
half = picture(view, "half")
assert 0.0 < drawn(half) < drawn(whole), (drawn(half), drawn(whole))
display.CroppingRegionFlags = "Inverted Cross"
expect_different(picture(view, "inverted"), half, 45.0, "other regions")
display.Cropping = 0

display.LevelRange = [0, 1]
coarse = picture(view, "coarse")
expect_different(coarse, whole, 60.0, "without fine levels")
assert drawn(coarse) > 0.5 * drawn(whole), (drawn(coarse), drawn(whole))
assert statistics(display).startswith("2 levels"), statistics(display)
display.LevelRange = [0, 100]
expect_alike(picture(view, "allLevels"), whole, 60.0, "all levels again")
collector.expect_silence()

# Of two components the first one has colors, the second one opacity.
pair = change_cells("""
both = vtkDoubleArray()
both.SetName("both")
both.SetNumberOfComponents(2)
both.SetNumberOfTuples(cells.GetNumberOfTuples())
for component in range(2):
    both.CopyComponent(component, cells.GetArray("value"), 0)
cells.AddArray(both)
""")
simple.Hide(scene, view)
both = simple.Show(pair, view)
both.SetRepresentationType("ExaBricks")
simple.ColorBy(both, ("CELLS", "both"))
both.LookupTable = display.LookupTable
both.ScalarOpacityFunction = display.ScalarOpacityFunction
both.OpacityUnitDistance = 8.0
both.Components = "Dependent"
# Within a step the color is a mean by itself, and not weighted with opacity.
expect_alike(picture(view, "dependent"), whole, 40.0, "the same array as color and as opacity")
both.Components = "Independent"
twice = picture(view, "independent")
both.Components = "One"
expect_different(picture(view, "magnitude"), whole, 45.0, "the magnitude of both")
expect_different(twice, whole, 45.0, "both added up")
display.OpacityUnitDistance = 4.0
simple.Hide(pair, view)
simple.Show(scene, view)
expect_alike(twice, picture(view, "dense"), 60.0, "one of twice the density")
display.OpacityUnitDistance = 8.0

# Colors of one array, opacities of another: of one component, or of the magnitude of several.
display.UseSeparateOpacityArray = 1
display.OpacityArrayName = ["CELLS", "value"]
expect_alike(picture(view, "sameOpacity"), whole, 40.0, "the same array for both")
simple.Hide(scene, view)
simple.Show(pair, view)
simple.ColorBy(both, ("CELLS", "value"))
both.LookupTable = display.LookupTable
both.ScalarOpacityFunction = display.ScalarOpacityFunction
both.UseSeparateOpacityArray = 1
both.OpacityArrayName = ["CELLS", "both"]
both.OpacityComponent = 1
expect_alike(picture(view, "secondOpacity"), whole, 40.0, "the second component as opacity")
both.OpacityComponent = 2
expect_different(picture(view, "magnitudeOpacity"), whole, 45.0, "the magnitude as opacity")
both.UseSeparateOpacityArray = 0
expect_alike(picture(view, "noSecondArray"), whole, 60.0, "no other array")
collector.expect_silence()

# Cells without a value, in the color map's color of them.
holes = change_cells("""
values = vtkDoubleArray()
values.DeepCopy(cells.GetArray("value"))
values.SetName("value")
for i in range(0, values.GetNumberOfTuples(), 2):
    values.SetValue(i, float("nan"))
cells.AddArray(values)
""")
simple.Hide(pair, view)
gaps = show(holes, view)
gaps.OpacityUnitDistance = 8.0
gaps.LookupTable.NanColor = [1.0, 1.0, 0.0]
without = picture(view, "gaps")
gaps.UseNanColor = 1
filled = picture(view, "filled")
expect_different(filled, without, 30.0, "cells without a value")
assert drawn(filled) > drawn(without), (drawn(filled), drawn(without))
collector.expect_silence()
