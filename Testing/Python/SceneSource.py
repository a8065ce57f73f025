# SPDX-License-Identifier: BSD-3-Clause
"""A stand-in for one of the paper's models, made and drawn in Python."""

from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
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

pixels = vtkUnsignedCharArray()
window.GetPixelData(0, 0, 63, 63, 1, pixels, 0)
drawn = sum(any(pixels.GetTuple3(i)) for i in range(pixels.GetNumberOfTuples()))
assert drawn > 64 * 64 / 10, drawn
