# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's own window: loads the plugin, chooses the representation, and saves a picture of the view.

Started by Python, this starts ParaView, which runs the second half, and watches how far that gets: on a busy machine
each step may take long, but one that takes longer than WAIT is named.
"""

import os
import subprocess
import sys
import time
import traceback

WAIT = 300.0  # seconds for a step; without load each takes one to eight
PROGRESS = "progress.txt"


def begin(step):
    """Tells the watching process what is done next."""
    with open(PROGRESS, "a") as file:
        file.write(step + "\n")


def watch():
    if os.path.exists(PROGRESS):
        os.remove(PROGRESS)
    begin("ParaView starts, opens its window and runs the script")
    # Without settings, and so without the window that welcomes to a first start: a second after it, within whatever the
    # script does then, that one waits for somebody to close it.
    command = [os.environ["EXABRICKS_PARAVIEW"], "--dr", "--script", os.path.abspath(__file__)]
    paraview = subprocess.Popen(command, env=dict(os.environ, EXABRICKS_IN_WINDOW="1"))
    seen, since = 0, time.monotonic()
    try:
        while True:
            try:
                status = paraview.wait(timeout=0.2)
                break
            except subprocess.TimeoutExpired:
                pass
            steps = open(PROGRESS).read().splitlines()
            if len(steps) > seen:
                print(f"{time.monotonic() - since:.1f} s, then: {steps[-1]}", flush=True)
                seen, since = len(steps), time.monotonic()
            assert time.monotonic() - since < WAIT, f"waited {WAIT} s for: {steps[-1]}"
    finally:
        paraview.kill()
    steps = open(PROGRESS).read().splitlines()
    # ParaView keeps what a script prints in its window.
    print("\n".join(steps[seen:]))
    assert status == 0, f"ParaView ended with status {status}, last it did: {steps[-1]}"


def look():
    """Within ParaView's window."""
    status = 1
    try:
        from Support import (
            darken, decibel, load_plugin, look_at, make_scene, picture, plain_vtk_picture, show, simple, statistics)

        begin("the plugin loads")
        load_plugin()
        begin("the scene is made, and shown by ExaBricks")
        scene = make_scene()
        view = simple.GetActiveViewOrCreate("RenderView")
        darken(view)
        display = show(scene, view)
        display.OpacityUnitDistance = 8.0
        look_at(scene, view)
        simple.Render(view)
        begin("a picture is saved")
        found = picture(view, "view", ImageResolution=[240, 180])
        begin("the same is drawn by plain VTK")
        likeness = decibel(found, plain_vtk_picture(view, "plain", 240, 180, 8.0))
        begin(f"the pictures are compared: {likeness:.1f} dB, at least 55")
        assert likeness >= 55.0
        assert "active" in statistics(display), statistics(display)
        begin("a 2-D transfer function is used")
        display.TransferFunction2D.Range = [0.0, 1.0, 0.0, 1.0]
        display.TransferFunction2D.Boxes = [0.4, 0.0, 0.6, 1.0, 1.0, 0.0, 0.0, 0.5]
        display.UseTransfer2D = 1
        simple.Render(view)
        red = picture(view, "planar", ImageResolution=[240, 180])
        assert red[..., 0].sum() > 10.0 * red[..., 1].sum(), (red[..., 0].sum(), red[..., 1].sum())
        status = 0
    except BaseException:
        begin(traceback.format_exc())
    os._exit(status)


if "EXABRICKS_IN_WINDOW" in os.environ:
    look()
else:
    watch()
