# SPDX-License-Identifier: BSD-3-Clause
"""What the tests share: the plugin, a scene with a transfer function, pictures as arrays, and how alike two are.

Each test is a script for pvpython, run in a folder of its own; the environment tells where the plugin is.
"""

import math
import os
import subprocess

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow
from vtkmodules.vtkIOImage import vtkPNGReader

PLUGIN = os.environ["EXABRICKS_PLUGIN"]
CELLS = 60000


def load_plugin(remote=False):
    simple.LoadPlugin(PLUGIN, remote=remote, ns=vars(simple))


def make_scene():
    scene = simple.ExaBricksScene(Scene="Exajet-wing", NumberOfLeafCells=CELLS)
    scene.UpdatePipeline()
    return scene


def make_view(width=240, height=180):
    view = simple.CreateView("RenderView")
    view.ViewSize = [width, height]
    view.UseFXAA = 0  # VTK smooths volumes with it where depth is peeled, and leaves them otherwise
    darken(view)
    simple.SetActiveView(view)
    return view


def darken(view):
    """Nothing but the data, on black."""
    view.OrientationAxesVisibility = 0
    if hasattr(view, "UseColorPaletteForBackground"):
        view.UseColorPaletteForBackground = 0
    view.Background = [0.0, 0.0, 0.0]


def show(source, view, array=("CELLS", "value"), representation="ExaBricks"):
    """Shows the source with the transfer function of PlainPicture.cxx."""
    display = simple.Show(source, view)
    display.SetRepresentationType(representation)
    simple.ColorBy(display, array)
    color = simple.GetColorTransferFunction(array[1])
    color.ColorSpace = "RGB"
    color.RGBPoints = [0.0, 0.1, 0.2, 0.8, 0.4, 1.0, 0.9, 0.6, 1.0, 1.0, 0.2, 0.1]
    opacity = simple.GetOpacityTransferFunction(array[1])
    opacity.Points = [0.0, 0.0, 0.5, 0.0, 0.1, 0.0, 0.5, 0.0, 1.0, 0.6, 0.5, 0.0]
    color.ScalarOpacityFunction = opacity
    return display


def look_at(source, view):
    """From in front and above, all of it."""
    bounds = source.GetDataInformation().GetBounds()
    center = [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
    size = max(bounds[2 * i + 1] - bounds[2 * i] for i in range(3))
    view.CameraFocalPoint = center
    view.CameraPosition = [center[0] - 0.9 * size, center[1] - 0.7 * size, center[2] + 1.1 * size]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.CameraViewAngle = 30.0


def picture(view, name, **options):
    """Renders `view` into <name>.png; returns its pixels, rows from below, channels in [0, 1]."""
    simple.SaveScreenshot(name + ".png", view, **options)
    return read_picture(name + ".png")


def plain_vtk_picture(view, name, width, height, unit_distance, reconstruction=0, blend_mode=0):
    """What PlainPicture.cxx draws of the same scene with the camera of `view`."""
    numbers = [CELLS, width, height, unit_distance, reconstruction]
    numbers += [*view.CameraPosition, *view.CameraFocalPoint, *view.CameraViewUp, view.CameraViewAngle, blend_mode]
    command = [os.environ["EXABRICKS_PLAIN_PICTURE"], name + ".png", *(repr(number) for number in numbers)]
    subprocess.run(command, check=True)
    return read_picture(name + ".png")


def read_picture(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())
    return pixels.reshape(height, width, -1).astype(float) / 255.0


def decibel(found, expected):
    """Peak signal-to-noise ratio; infinite if equal."""
    assert found.shape == expected.shape, (found.shape, expected.shape)
    error = numpy.mean((found - expected) ** 2)
    return math.inf if error == 0.0 else -10.0 * math.log10(error)


def expect_alike(found, expected, least, what):
    likeness = decibel(found, expected)
    print(f"{what}: {likeness:.1f} dB, at least {least}")
    assert likeness >= least, what


def expect_different(found, expected, most, what):
    likeness = decibel(found, expected)
    print(f"{what}: {likeness:.1f} dB, at most {most}")
    assert likeness <= most, what


def drawn(pixels):
    """The share of the pixels that are not black."""
    return float(numpy.mean(pixels[..., :3].max(axis=-1) > 0.02))


def make_empty():
    """An AMR with nothing in it."""
    empty = simple.ProgrammableSource()
    types = empty.GetProperty("OutputDataSetType").Available
    # Older versions name the former class.
    empty.OutputDataSetType = "vtkOverlappingAMR" if "vtkOverlappingAMR" in types else "vtkHierarchicalBoxDataSet"
    empty.Script = ""
    empty.UpdatePipeline()
    return empty


def environment_of_ranks():
    """For mpiexec, without what this process's own MPI tells of itself: it would be taken for mpiexec's own."""
    kept = ("OMPI_ALLOW", "OMPI_MCA_rmaps", "PRTE_MCA_rmaps")
    return {name: value for name, value in os.environ.items()
            if not name.startswith(("OMPI_", "PMIX_", "PRTE_")) or name.startswith(kept)}


def statistics(display):
    """What the panel tells of the last picture."""
    return display.SMProxy.GetProperty("Statistics").GetElement(0)


class Collector:
    """Every text of ParaView's output window comes here."""

    def __init__(self):
        self.said = []
        self.window = vtkOutputWindow.GetInstance()
        for event in ("ErrorEvent", "WarningEvent"):
            self.window.AddObserver(event, self.collect)

    def collect(self, caller, event, text):
        self.said.append(text)

    collect.CallDataType = "string0"

    def expect_said(self, *words):
        """One warning of ours with all these words, since the last look."""
        found = [text for text in self.said if "ExaBricks" in text]
        assert len(found) == 1, found
        for word in words:
            assert word in found[0], (word, found[0])
        self.said.clear()

    def expect_silence(self):
        found = [text for text in self.said if "ExaBricks" in text]
        assert not found, found
