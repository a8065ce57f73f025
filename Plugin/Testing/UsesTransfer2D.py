# SPDX-License-Identifier: BSD-3-Clause
"""2-D transfer functions, of a value and its gradient, or of two arrays, and back to the 1-D ones; kept by a state."""

from Support import *

load_plugin()
collector = Collector()
scene = make_scene()
second = simple.ProgrammableFilter(Input=scene, CopyArrays=1)
second.Script = """
from vtkmodules.vtkCommonCore import vtkDoubleArray
blocks = output.VTKObject.NewIterator()
while not blocks.IsDoneWithTraversal():
    block = blocks.GetCurrentDataObject()
    value = block.GetCellData().GetArray("value")
    pair = vtkDoubleArray()
    pair.SetName("pair")
    pair.SetNumberOfComponents(2)
    pair.SetNumberOfTuples(value.GetNumberOfTuples())
    pair.CopyComponent(0, value, 0)
    pair.CopyComponent(1, value, 0)
    pair.SetComponent(0, 1, -1.0)  # a range from -1
    block.GetCellData().AddArray(pair)
    blocks.GoToNextItem()
"""
view = make_view()
display = show(second, view)
look_at(scene, view)
display.OpacityUnitDistance = 8.0
simple.Render(view)
plain = picture(view, "plain")
assert drawn(plain) > 0.05, drawn(plain)

function = simple.GetTransferFunction2D("value") if hasattr(simple, "GetTransferFunction2D") else display.TransferFunction2D
function.Range = [0.0, 1.0, 0.0, 1.0]
function.OutputDimensions = [64, 64]
# Red from values of 0.4 on, whatever the second variable is.
function.Boxes = [0.4, 0.0, 0.6, 1.0, 1.0, 0.0, 0.0, 0.5]
display.TransferFunction2D = function
display.UseTransfer2D = 1
boxes = picture(view, "boxes")
red = boxes[..., 0].sum()
assert drawn(boxes) > 0.01 and red > 10.0 * boxes[..., 1].sum(), (drawn(boxes), red, boxes[..., 1].sum())
assert drawn(boxes) < 0.9 * drawn(plain), (drawn(boxes), drawn(plain))

# Only where the gradient is steep: less of it.
function.Boxes = [0.4, 0.5, 0.6, 0.5, 1.0, 0.0, 0.0, 0.5]
steep = picture(view, "steep")
assert steep[..., 0].sum() < 0.7 * red, (steep[..., 0].sum(), red)

# The second array has the value itself, and in its other component one of another range.
function.Boxes = [0.4, 0.4, 0.6, 0.6, 1.0, 0.0, 0.0, 0.5]
display.UseGradientForTransfer2D = 0
display.ColorArray2Name = ["CELLS", "pair"]
first = picture(view, "first")
assert 0.5 * red < first[..., 0].sum() < 2.0 * red, (first[..., 0].sum(), red)
function.Boxes = [0.4, 0.0, 0.6, 0.4, 1.0, 0.0, 0.0, 0.5]
assert drawn(picture(view, "none")) < 0.2 * drawn(first)
display.ColorArray2Component = 1
function.Boxes = [0.4, 0.7, 0.6, 0.3, 1.0, 0.0, 0.0, 0.5]
component = picture(view, "component")
assert drawn(component) > 0.004, drawn(component)
collector.expect_silence()

# A state has it all.
simple.SaveState("state.pvsm")
simple.ResetSession()
load_plugin()
simple.LoadState("state.pvsm")
view = simple.GetActiveViewOrCreate("RenderView")
expect_alike(picture(view, "state"), component, 60.0, "from a state")

# Back to the 1-D functions.
display = simple.GetDisplayProperties(simple.FindSource("ProgrammableFilter1"), view)
display.UseTransfer2D = 0
expect_alike(picture(view, "again"), plain, 60.0, "1-D functions again")
collector.expect_silence()
