# SPDX-License-Identifier: BSD-3-Clause
"""From a file to a picture in Python: importing exabricks is all that VTK needs to draw overlapping AMR."""

import os
import sys

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdTypeArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction, vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLUniformGridAMRReader
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction,
    vtkRenderWindow,
    vtkRenderer,
    vtkVolume,
)
from vtkmodules.vtkTestingRendering import vtkTesting

import exabricks

testing = vtkTesting()
for argument in sys.argv[1:]:
    testing.AddArgument(argument)
testing.AddArgument("-V")
testing.AddArgument(os.path.join(sys.argv[sys.argv.index("-B") + 1], "PythonReaderToPicture.png"))

reader = vtkXMLUniformGridAMRReader()
reader.SetFileName(os.path.join(testing.GetDataRoot(), "rt_medium", "rt_medium.vthb"))
reader.SetMaximumLevelsToReadByDefault(0)  # all

mapper = exabricks.vtkExaBricksVolumeMapper()
mapper.SetInputConnection(reader.GetOutputPort())
mapper.SetScalarModeToUseCellFieldData()
mapper.SelectScalarArray("magvort")

color = vtkColorTransferFunction()
color.AddRGBPoint(0.5, 0.1, 0.2, 0.8)
color.AddRGBPoint(6.0, 1.0, 0.9, 0.6)
color.AddRGBPoint(18.0, 1.0, 0.2, 0.1)
opacity = vtkPiecewiseFunction()
opacity.AddPoint(0.5, 0.0)
opacity.AddPoint(10.0, 0.5)

volume = vtkVolume()
volume.SetMapper(mapper)
volume.GetProperty().SetColor(color)
volume.GetProperty().SetScalarOpacity(opacity)
volume.GetProperty().SetScalarOpacityUnitDistance(0.02)

renderer = vtkRenderer()
renderer.AddVolume(volume)
window = vtkRenderWindow()
window.SetMultiSamples(0)
window.SetSize(200, 200)
window.AddRenderer(renderer)
camera = renderer.GetActiveCamera()
camera.SetPosition(0.8, -1.2, 1.2)
camera.SetFocalPoint(0.25, 0.25, 0.38)
camera.SetViewUp(0.0, 0.0, 1.0)
renderer.ResetCameraClippingRange()
window.Render()

# What the bricks were made of.
data = mapper.GetBuilder().GetOutput()
assert isinstance(data, exabricks.vtkExaBricksData)
assert isinstance(mapper.GetBuilder(), exabricks.vtkExaBricksBuilder)
assert data.GetNumberOfLevels() == 3
assert data.GetNumberOfBlocks() == 25
assert data.GetNumberOfLeafCells() == 549120
assert data.GetArrayName() == "magvort"
value_range = [0.0, 0.0]
data.GetScalarRange(value_range)
assert abs(value_range[1] - 18.7710) < 1e-4, value_range
bounds = mapper.GetBounds()
assert max(abs(a - b) for a, b in zip(bounds, (0, 0.5, 0, 0.5, 0, 1))) < 1e-9, bounds

counts = vtkIdTypeArray()
data.GetHistogram(16, counts)
shares = vtkDoubleArray()
data.GetVolumeHistogram(16, shares)
assert abs(sum(shares.GetValue(i) for i in range(16)) - 1.0) < 1e-9
# Fine cells are many, and small.
assert shares.GetValue(0) > counts.GetValue(0) / data.GetNumberOfLeafCells()
histogram = [counts.GetValue(i) for i in range(counts.GetNumberOfValues())]
assert sum(histogram) == data.GetNumberOfLeafCells()
assert histogram[0] == max(histogram), "most of the gas is still"

# Bricks and regions as VTK cells.
cells = vtkUnstructuredGrid()
data.GetBricksAsCells(cells)
sizes = cells.GetCellData().GetArray("Cells")
sizes = [sizes.GetTuple3(i) for i in range(sizes.GetNumberOfTuples())]
assert sum(x * y * z for x, y, z in sizes) == data.GetNumberOfLeafCells()
data.GetRegionsAsCells(cells, opacity)
active = cells.GetCellData().GetArray("Active")
active = [active.GetTuple1(i) for i in range(active.GetNumberOfTuples())]
assert sum(active) == mapper.GetNumberOfActiveRegions()
assert 0 < sum(active) < len(active)

# On which device.
devices = vtkStringArray()
exabricks.vtkExaBricksVolumeMapper.GetDevices(devices)
lines = [devices.GetValue(i) for i in range(devices.GetNumberOfValues())]
assert any(mapper.GetDeviceName() in line for line in lines), lines
assert mapper.GetTraversalUsed() in ("KdTree", "RayQuery")
assert mapper.GetDeviceMemory() > 549120 * 4
assert mapper.GetMarchTime() > 0

testing.SetRenderWindow(window)
sys.exit(0 if testing.RegressionTest(0.15) == vtkTesting.PASSED else 1)
