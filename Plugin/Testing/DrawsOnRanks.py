# SPDX-License-Identifier: BSD-3-Clause
"""The picture of several ranks is that of one rank, with geometry in between, basis and completed; what is not
the same on several ranks is said.

Started by Python, this draws on one rank first, and then on several, which compare.
"""

import os
import subprocess
import sys

RANKS = 4
FOLDER = "alone"

if len(sys.argv) == 1:
    subprocess.run([os.environ["EXABRICKS_PVPYTHON"], os.path.abspath(__file__), "alone"], check=True)
    batch = [os.environ["EXABRICKS_PVBATCH"], os.path.abspath(__file__), "ranks"]
    sys.exit(subprocess.run([os.environ["EXABRICKS_MPIEXEC"], "-n", str(RANKS), *batch]).returncode)

from vtkmodules.vtkParallelCore import vtkMultiProcessController

from Support import *


def draw(folder):
    """Pictures of one scene with all that is tried."""
    os.makedirs(folder, exist_ok=True)
    scene = make_scene()
    view = make_view()
    display = show(scene, view)
    look_at(scene, view)
    display.OpacityUnitDistance = 8.0
    pictures = {"basis": picture(view, folder + "/basis")}
    display.Reconstruction = "Completed"
    pictures["completed"] = picture(view, folder + "/completed")
    display.Shading = 1
    pictures["shaded"] = picture(view, folder + "/shaded")
    display.Shading = 0
    display.Reconstruction = "Basis"
    display.BlendMode = "Isosurface"
    display.IsosurfaceValues = [0.4]
    pictures["isosurface"] = picture(view, folder + "/isosurface")
    display.BlendMode = "Composite"
    manager = simple.servermanager.vtkSMProxyManager
    if (manager.GetVersionMajor(), manager.GetVersionMinor()) < (5, 12):
        print("geometry between ranks is skipped: Debian 12's ParaView cannot share it out since an update of expat")
        return view, display, pictures
    # An opaque sphere in the middle, and a translucent one beside it.
    bounds = scene.GetDataInformation().GetBounds()
    center = [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
    size = max(bounds[2 * i + 1] - bounds[2 * i] for i in range(3))
    sphere = simple.Sphere(Center=center, Radius=0.08 * size, ThetaResolution=60, PhiResolution=60)
    sphere_display = simple.Show(sphere, view)
    sphere_display.AmbientColor = sphere_display.DiffuseColor = [0.1, 0.9, 0.3]
    pictures["opaque"] = picture(view, folder + "/opaque")
    sphere_display.Opacity = 0.5
    pictures["translucent"] = picture(view, folder + "/translucent")
    simple.Hide(sphere, view)
    return view, display, pictures


def compare():
    """On several ranks, which all come here together."""
    controller = vtkMultiProcessController.GetGlobalController()
    assert controller.GetNumberOfProcesses() == RANKS, controller.GetNumberOfProcesses()
    collector = Collector()
    view, display, pictures = draw("ranks")
    if controller.GetLocalProcessId() == 0:
        faults = []
        for name, found in pictures.items():
            expected = read_picture(f"{FOLDER}/{name}.png")
            shown = (found.max(axis=-1) > 0.02) | (expected.max(axis=-1) > 0.02)
            error = float(numpy.mean((found - expected)[shown] ** 2))
            quality = -10.0 * math.log10(max(error, 1e-12))
            most = round(255.0 * float(numpy.abs(found - expected).max()))
            print(f"{name}: {quality:.1f} dB over drawn pixels, most {most} of 255, drawn {float(shown.mean()):.3f}")
            if quality < 54.0 or not shown.mean() > 0.01:
                faults.append(name)
        assert not faults, faults
        assert "of all" in statistics(display), statistics(display)
    collector.expect_silence()

    # Each rank would choose steps and levels of its own; ParaView puts pictures one over the other.
    first = picture(view, "first")
    # With image reduction ranks draw fewer pixels, of all that shows.
    view.StillRenderImageReductionFactor = 2
    reduced = picture(view, "reduced")
    print(f"a quarter of the pixels: {decibel(reduced, first):.1f} dB, drawn {drawn(reduced):.3f} of {drawn(first):.3f}")
    assert 22.0 < decibel(reduced, first) < 45.0, decibel(reduced, first)
    assert abs(drawn(reduced) - drawn(first)) < 0.02, (drawn(reduced), drawn(first))
    view.StillRenderImageReductionFactor = 1
    expect_alike(picture(view, "unreduced"), first, 70.0, "without it again")
    display.ErrorTolerance = 0.05
    expect_alike(picture(view, "tolerance"), first, 70.0, "with a tolerance")
    collector.expect_said(f"{RANKS} ranks", "ErrorTolerance is not used")
    display.ErrorTolerance = 0.0
    display.BlendMode = "Maximum Intensity"
    picture(view, "maximum")
    collector.expect_said("of its own part")


load_plugin()
if sys.argv[1] == "alone":
    draw(FOLDER)
else:
    compare()
