# SPDX-License-Identifier: BSD-3-Clause
"""Makes the pictures of Documentation/ParaView.md: ParaView's own "Volume" and ExaBricks, the same in all else.

    pvpython pictures.py <plugin: ExaBricks.so> <folder of AMR data> <folder for the pictures>

The data: rt_medium/plt00216, sv_r24_many/plt00070 (AMReX) and Enzo/DD0010/moving7_0010.hierarchy.
"""

import os
import sys

from paraview import servermanager, simple

plugin, data, output = sys.argv[1:]
simple.LoadPlugin(plugin, remote=False, ns=globals())


def apply_preset(color, name):
    """ParaView before 6.1 has it as "<name> (matplotlib)"."""
    presets = servermanager.vtkSMTransferFunctionPresets.GetInstance()
    known = {presets.GetPresetName(i) for i in range(presets.GetNumberOfPresets())}
    color.ApplyPreset(name if name in known else f"{name} (matplotlib)", True)


class Case:
    """A file, its array, and how it is looked at."""

    def __init__(self, name, path, array, preset, opacity, unit, position, focal_point, angle, logarithm=False):
        self.name, self.path, self.array, self.preset = name, path, array, preset
        self.opacity, self.unit, self.logarithm = opacity, unit, logarithm
        self.position, self.focal_point, self.angle = position, focal_point, angle


cases = [
    Case("rt_medium", "rt_medium/plt00216", "magvort", "Inferno",
         [(0, 0), (2, 0), (4, 0.03), (6, 0.01), (9, 0.04), (12, 0.25), (19, 0.5)], 0.0052,
         (1.05, -1.15, 0.95), (0.25, 0.25, 0.47), 17.0),
    Case("sv_r24_many", "sv_r24_many/plt00070", "phi", "Viridis",
         [(1.0, 0), (1.05, 0), (1.07, 0.3), (1.1, 0.3), (1.12, 0), (1.6, 0), (1.65, 0.6), (1.95, 0.6)], 0.01,
         (1.6, -1.0, 1.4), (0.6, 0.3, 0.35), 26.0),
    Case("enzo", "Enzo/DD0010/moving7_0010.hierarchy", "Density", "Inferno",
         [(0.1, 0), (1, 0.002), (10, 0.01), (100, 0.05), (1000, 0.2), (1e4, 0.5), (2.5e5, 0.9)], 0.004,
         (1.05, 0.4, 0.95), (0.75, 0.75, 0.75), 20.0, True),
]


def open_data(path):
    full = os.path.join(data, path)
    if path.endswith(".hierarchy"):
        reader = simple.EnzoReader(FileNames=[full])
    else:
        reader = simple.AMReXBoxLibGridReader(FileNames=[full])
    reader.UpdatePipelineInformation()
    for name in ("DefaultNumberOfLevels", "Level"):
        if name in reader.ListProperties():
            setattr(reader, name, 10)
    return reader


for case in cases:
    reader = open_data(case.path)
    reader.CellArrayStatus = [case.array]
    reader.UpdatePipeline()
    print(case.name, reader.CellData[case.array].GetRange(), reader.GetDataInformation().GetNumberOfCells(), "cells")

    view = simple.CreateView("RenderView")
    view.ViewSize = [400, 400]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.0, 0.0, 0.0]
    display = simple.Show(reader, view)
    display.SetRepresentationType("ExaBricks")
    simple.ColorBy(display, ("CELLS", case.array))
    color = simple.GetColorTransferFunction(case.array)
    opacity = simple.GetOpacityTransferFunction(case.array)
    apply_preset(color, case.preset)
    color.RescaleTransferFunction(case.opacity[0][0], case.opacity[-1][0])
    if case.logarithm:
        color.MapControlPointsToLogSpace()
        color.UseLogScale = 1
    opacity.Points = [number for value, alpha in case.opacity for number in (value, alpha, 0.5, 0.0)]

    # The first resampling of ParaView 5.11 leaves values unset: have it resample once more.
    display.SetRepresentationType("Volume")
    samples = list(display.NumberOfSamples)
    display.NumberOfSamples = [32, 32, 32]
    simple.Render(view)
    display.NumberOfSamples = samples
    simple.Render(view)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = case.position, case.focal_point, (0, 0, 1)
    view.CameraViewAngle = case.angle
    for representation in ("Volume", "ExaBricks"):
        display.SetRepresentationType(representation)
        display.ScalarOpacityUnitDistance = case.unit
        display.OpacityUnitDistance = case.unit
        name = f"{case.name}_{representation.lower()}.png"
        simple.SaveScreenshot(os.path.join(output, name), view, ImageResolution=[400, 400])
    display.SMProxy.UpdatePropertyInformation()
    print(display.SMProxy.GetProperty("Statistics").GetElement(0))
    simple.Delete(view)
