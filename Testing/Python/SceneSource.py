# SPDX-License-Identifier: BSD-3-Clause
"""A stand-in for one of the paper's models, made and drawn in Python."""

from vtkmodules.vtkCommonCore import vtkStringArray, vtkUnsignedCharArray
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkRenderer, vtkVolume

import exabricks

source = exabricks.vtkExaBricksSceneSource()
source.SetSceneName("Exajet-wing")
source.SetNumberOfLeafCells(60000)
assert source.GetScene() == source.EXAJET_WING

mapper = exabricks.vtkExaBricksVolumeMapper()
mapper.SetInputConnection(source.GetOutputPort())
volume = vtkVolume()
volume.SetMapper(mapper)
source.InitializeProperty(volume.GetProperty())
renderer = vtkRenderer()
renderer.AddVolume(volume)
source.InitializeCamera(renderer.GetActiveCamera())
renderer.ResetCameraClippingRange()
window = vtkRenderWindow()
window.SetMultiSamples(0)
window.SetSize(64, 64)
window.AddRenderer(renderer)
window.Render()

data = mapper.GetBuilder().GetOutput()
assert data.GetArrayName() == "value"
assert data.GetNumberOfLevels() == 4
assert abs(data.GetNumberOfLeafCells() / 60000 - 1) < 0.2, data.GetNumberOfLeafCells()
assert source.GetMesh().GetNumberOfPolys() > 0
assert source.GetCellsPerBrickOfOriginal() == 206


def draw():
    """The brightness of each colour of each pixel, from 0 to 255."""
    window.Render()
    pixels = vtkUnsignedCharArray()
    window.GetPixelData(0, 0, 63, 63, 1, pixels, 0)
    return [pixels.GetValue(i) for i in range(pixels.GetNumberOfValues())]


by_tree = draw()
drawn = sum(value > 0 for value in by_tree)
assert drawn > len(by_tree) / 10, drawn

# Two ways to find the same regions agree on the picture.
devices = vtkStringArray()
mapper.GetDevices(devices)
lines = [devices.GetValue(i) for i in range(devices.GetNumberOfValues())]
if any(mapper.GetDeviceName() in line and "(with ray query)" in line for line in lines):
    mapper.SetTraversalToRayQuery()
    by_query = draw()
    assert sum(abs(a - b) for a, b in zip(by_tree, by_query)) < 0.5 * drawn
else:
    print("the device has no ray query to compare with")
