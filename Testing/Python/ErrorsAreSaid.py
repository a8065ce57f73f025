# SPDX-License-Identifier: BSD-3-Clause
"""Wrong use from Python ends in VTK's error events or Python's exceptions, and the next picture is well."""

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkAMRBox, vtkOverlappingAMR, vtkUniformGrid
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkRenderer, vtkVolume

import exabricks

classes = {name for name in exabricks.__all__ if name.startswith("vtk")}
assert classes == {
    "vtkExaBricksBuilder",
    "vtkExaBricksData",
    "vtkExaBricksFileCheck",
    "vtkExaBricksFirstPicture",
    "vtkExaBricksPicker",
    "vtkExaBricksRedistribute",
    "vtkExaBricksSceneSource",
    "vtkExaBricksVolumeMapper",
}
assert all(hasattr(exabricks, name) for name in exabricks.__all__)
for name in classes:
    instance = getattr(exabricks, name)()
    assert instance.GetClassName() == name
    assert name in str(instance)


def make_amr(cells=4):
    """One level, one block, its cell array 'value' is 1."""
    grid = vtkUniformGrid()
    grid.SetDimensions((cells + 1,) * 3)
    amr = vtkOverlappingAMR()
    if hasattr(amr, "GetOverlappingAMRMetaData"):  # VTK 9.6
        amr.Initialize([1])
    else:
        amr.Initialize(1, [1])
        amr.SetGridDescription(grid.GetGridDescription())
    amr.SetOrigin((0.0, 0.0, 0.0))
    amr.SetSpacing(0, (1.0, 1.0, 1.0))
    amr.SetAMRBox(0, 0, vtkAMRBox((0, 0, 0), (cells - 1,) * 3))
    values = vtkDoubleArray()
    values.SetName("value")
    values.SetNumberOfTuples(grid.GetNumberOfCells())
    values.Fill(1.0)
    grid.GetCellData().SetScalars(values)
    amr.SetDataSet(0, 0, grid)
    return amr


errors = []


def collect(caller, event, message):
    errors.append(message)


collect.CallDataType = "string0"

mapper = exabricks.vtkExaBricksVolumeMapper()
mapper.AddObserver("ErrorEvent", collect)
mapper.GetBuilder().AddObserver("ErrorEvent", collect)
volume = vtkVolume()
volume.SetMapper(mapper)
renderer = vtkRenderer()
renderer.AddVolume(volume)
window = vtkRenderWindow()
window.SetMultiSamples(0)
window.SetSize(20, 20)
window.AddRenderer(renderer)


def says(*words):
    """Renders; the one error has these words."""
    errors.clear()
    window.Render()
    assert len(errors) == 1, errors
    for word in words:
        assert word in errors[0], (word, errors[0])


says("found none", "SetInputConnection")
mapper.SetInputData(vtkOverlappingAMR())
says("at least one block")
mapper.SetInputData(make_amr())
mapper.SetScalarModeToUseCellFieldData()
mapper.SelectScalarArray("pressure")
says("'pressure'", "'value'")
mapper.SelectScalarArray("value")
mapper.SetBlendModeToSlice()
says("slice")
mapper.SetBlendModeToComposite()
mapper.SetDevice("abacus")
says("abacus")
mapper.SetDevice(None)

# Python's own checks.
for wrong in (lambda: mapper.SetStepScale("long"), lambda: mapper.SetReconstruction(None)):
    try:
        wrong()
    except TypeError:
        pass
    else:
        raise AssertionError("expected a TypeError")

# A class is kept although its wrapper goes, and draws after all that.
errors.clear()
property_ = volume.GetProperty()
property_.GetScalarOpacity().RemoveAllPoints()
property_.GetScalarOpacity().AddPoint(0.0, 1.0)
property_.GetRGBTransferFunction().RemoveAllPoints()
property_.GetRGBTransferFunction().AddRGBPoint(0.0, 0.0, 1.0, 0.0)
del mapper
renderer.ResetCamera()
window.Render()
assert not errors, errors
pixel = vtkUnsignedCharArray()
window.GetPixelData(10, 10, 10, 10, 1, pixel, 0)
assert pixel.GetTuple3(0) == (0.0, 255.0, 0.0), pixel.GetTuple3(0)
