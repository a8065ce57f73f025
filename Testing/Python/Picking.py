# SPDX-License-Identifier: BSD-3-Clause
"""Which cell of real AMR data is seen at a place of the window, and its value."""

import argparse
import math

from vtkmodules.vtkIOXML import vtkXMLUniformGridAMRReader
from vtkmodules.vtkRenderingCore import vtkPropPicker, vtkRenderWindow, vtkRenderer, vtkVolume

import exabricks

arguments = argparse.ArgumentParser()
arguments.add_argument("-D", dest="data")
arguments, _ = arguments.parse_known_args()

reader = vtkXMLUniformGridAMRReader()
reader.SetFileName(f"{arguments.data}/rt_medium/rt_medium.vthb")
reader.SetMaximumLevelsToReadByDefault(0)  # all
mapper = exabricks.vtkExaBricksVolumeMapper()
mapper.SetInputConnection(reader.GetOutputPort())
mapper.SetScalarModeToUseCellFieldData()
mapper.SelectScalarArray("magvort")
mapper.Update()
value_range = [0.0, 0.0]
mapper.GetBuilder().GetOutput().GetScalarRange(value_range)
least, most = value_range

volume = vtkVolume()
volume.SetMapper(mapper)
unit = most - least
volume.GetProperty().GetRGBTransferFunction().AddRGBPoint(least, 1.0, 1.0, 1.0)
volume.GetProperty().GetScalarOpacity().RemoveAllPoints()
for value, opacity in ((least + 0.3 * unit, 0.0), (least + 0.35 * unit, 1.0)):
    volume.GetProperty().GetScalarOpacity().AddPoint(value, opacity)
renderer = vtkRenderer()
renderer.AddVolume(volume)
window = vtkRenderWindow()
window.SetMultiSamples(0)
window.SetSize(90, 90)
window.AddRenderer(renderer)
bounds = mapper.GetBounds()
volume.GetProperty().SetScalarOpacityUnitDistance(0.001 * (bounds[1] - bounds[0]))
camera = renderer.GetActiveCamera()
camera.SetPosition(0.0, -1.0, 0.2)
camera.SetViewUp(0.0, 0.0, 1.0)
renderer.ResetCamera()
window.Render()

picker = exabricks.vtkExaBricksPicker()
picked = []
for y in range(2, 90, 6):
    for x in range(2, 90, 6):
        if picker.Pick(x, y, 0.0, renderer):
            assert picker.GetVolume() is volume
            picked.append((x, y, picker.GetValue()))
            # The value is that of the reader's cell, and the place is in it.
            levels = reader.GetOutputDataObject(0)
            block = levels.GetDataSet(picker.GetLevel(), picker.GetBlock())
            array = block.GetCellData().GetArray("magvort")
            value = array.GetTuple1(picker.GetCellId())
            assert math.isclose(value, picker.GetValue(), rel_tol=1e-5, abs_tol=1e-6 * unit)
            place = picker.GetPickPosition()
            cell = block.GetCell(picker.GetCellId()).GetBounds()
            for axis in range(3):
                width = cell[2 * axis + 1] - cell[2 * axis]
                assert cell[2 * axis] - 1e-3 * width <= place[axis]
                assert place[axis] <= cell[2 * axis + 1] + 1e-3 * width
            # What is seen are cells that show anything.
            assert picker.GetValue() > least + 0.3 * unit, picker
assert len(picked) > 10, len(picked)
print(f"{len(picked)} places picked, values from {min(picked, key=lambda p: p[2])[2]:.3g}"
      f" to {max(picked, key=lambda p: p[2])[2]:.3g}")

props = vtkPropPicker()
x, y, _ = picked[len(picked) // 2]
assert props.Pick(x, y, 0.0, renderer) and props.GetViewProp() is volume
assert not picker.Pick(1, 1, 0.0, renderer) and picker.GetLevel() == -1
assert math.isnan(picker.GetValue())
