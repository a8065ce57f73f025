# SPDX-License-Identifier: BSD-3-Clause
"""Twenty time steps through one mapper, with equal boxes and with others each time: memory stays what it was."""

import sys

import numpy

from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkVolume

import exabricks

COARSE, FINE = 64, 80
STEPS = 20


def make_step(step, moves):
    """A coarse cube, and a fine one that may be elsewhere in each step; of 3 MB and more."""
    corner = (2 * (step % 10) if moves else 10, 8, 12)
    random = numpy.random.default_rng(step)
    return exabricks.amr_from_arrays([
        (0, (0, 0, 0), random.random((COARSE,) * 3, dtype="f4")),
        (1, corner, random.random((FINE,) * 3, dtype="f4")),
    ])


def resident():
    """Of this process, in MB; none where the system does not tell."""
    try:
        with open("/proc/self/statm", encoding="ascii") as file:
            return int(file.read().split()[1]) * 4096 / 1e6
    except OSError:
        return None


def play(moves):
    mapper = exabricks.vtkExaBricksVolumeMapper()
    mapper.SetReconstructionToBasis()
    mapper.SetErrorTolerance(0.02)  # which keeps coarser levels too
    colors = vtkColorTransferFunction()
    colors.AddRGBPoint(0.0, 0.2, 0.3, 0.9)
    colors.AddRGBPoint(1.0, 1.0, 0.8, 0.6)
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(0.3, 0.0)
    opacity.AddPoint(1.0, 0.3)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.GetProperty().SetColor(colors)
    volume.GetProperty().SetScalarOpacity(opacity)
    volume.GetProperty().SetScalarOpacityUnitDistance(4.0)
    renderer = vtkRenderer()
    renderer.AddVolume(volume)
    window = vtkRenderWindow()
    window.SetMultiSamples(0)
    window.SetSize(64, 64)
    window.AddRenderer(renderer)
    on_host, on_device = [], []
    for step in range(STEPS):
        mapper.SetInputDataObject(make_step(step, moves))
        if step == 0:
            renderer.ResetCamera(0.0, COARSE, 0.0, COARSE, 0.0, COARSE)
        window.Render()
        assert mapper.GetDrawn()
        on_host.append(resident())
        on_device.append(mapper.GetDeviceMemory())
    print("boxes that move:" if moves else "equal boxes:", "on the device", on_device[5], "to", on_device[-1],
          "bytes, on the host", on_host[5], "to", on_host[-1], "MB")
    assert max(on_device) <= 1.1 * on_device[0], on_device
    # Less than the data of two steps, of which fifteen were drawn in between.
    data = 4e-6 * (COARSE**3 + FINE**3)
    assert on_host[5] is None or on_host[-1] - on_host[5] < 2.0 * data, on_host


play(moves=False)
play(moves=True)
sys.exit(0)
