# SPDX-License-Identifier: BSD-3-Clause
"""Opens a .vthb file and draws one of its arrays as a volume into a PNG.

    minimal.py Testing/Data/rt_medium/rt_medium.vthb magvort picture.png
"""
import sys

from exabricks import vtkExaBricksVolumeMapper
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUniformGridAMRReader
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction,
    vtkRenderer,
    vtkRenderWindow,
    vtkVolume,
    vtkWindowToImageFilter,
)

if len(sys.argv) != 4:
    sys.exit("usage: minimal.py FILE.vthb ARRAY PICTURE.png")

reader = vtkXMLUniformGridAMRReader()
reader.SetFileName(sys.argv[1])
reader.SetMaximumLevelsToReadByDefault(0)  # all of them

mapper = vtkExaBricksVolumeMapper()
mapper.SetInputConnection(reader.GetOutputPort())
mapper.SetScalarModeToUseCellFieldData()
mapper.SelectScalarArray(sys.argv[2])
mapper.Update()
data = mapper.GetBuilder().GetOutput()
if data.GetNumberOfLeafCells() == 0:
    sys.exit(1)  # VTK has said why
scalar_range = [0.0, 0.0]
data.GetScalarRange(scalar_range)  # of the leaf cells
least, greatest = scalar_range
spacing = [0.0, 0.0, 0.0]
data.GetFinestSpacing(spacing)

colors = vtkColorTransferFunction()
colors.AddRGBPoint(least, 0.2, 0.3, 0.8)
colors.AddRGBPoint(greatest, 1.0, 0.8, 0.3)
opacity = vtkPiecewiseFunction()
opacity.AddPoint(least + 0.1 * (greatest - least), 0.0)
opacity.AddPoint(greatest, 0.2)

volume = vtkVolume()
volume.SetMapper(mapper)
volume.GetProperty().SetColor(colors)
volume.GetProperty().SetScalarOpacity(opacity)
volume.GetProperty().SetInterpolationTypeToLinear()  # continuous, as the mapper draws it
volume.GetProperty().SetScalarOpacityUnitDistance(spacing[0])



def end_without_display(window, event, message):
    """VTK before 9.4 aborts the program after an error of its window; this ends it before, with words."""
    sys.exit(message + "minimal.py needs a display to draw in. Without one, run it as xvfb-run -a python3 minimal.py ...")


end_without_display.CallDataType = "string0"

renderer = vtkRenderer()
renderer.AddVolume(volume)
window = vtkRenderWindow()
window.AddObserver("ErrorEvent", end_without_display)
window.SetOffScreenRendering(1)
window.SetSize(400, 400)
window.AddRenderer(renderer)
window.Render()

image = vtkWindowToImageFilter()
image.SetInput(window)
writer = vtkPNGWriter()
writer.SetFileName(sys.argv[3])
writer.SetInputConnection(image.GetOutputPort())
writer.Write()
if writer.GetErrorCode():
    sys.exit(f"'{sys.argv[3]}' cannot be written. Is its folder there?")
