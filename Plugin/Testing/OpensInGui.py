# SPDX-License-Identifier: BSD-3-Clause
"""Run by ParaView's own window: loads the plugin, chooses the representation, and saves a picture of the view."""

import os
import sys
import traceback

status = 1
try:
    from Support import *

    load_plugin()
    scene = make_scene()
    view = simple.GetActiveViewOrCreate("RenderView")
    display = simple.Show(scene, view)
    display.SetRepresentationType("ExaBricks")
    simple.ColorBy(display, ("CELLS", "value"))
    display.SetScalarBarVisibility(view, True)
    simple.Render(view)
    simple.ResetCamera(view)
    simple.Render(view)
    pixels = picture(view, "view")
    assert numpy.ptp(pixels[..., 0]) > 0.2, "something is drawn"
    assert "active" in statistics(display), statistics(display)
    status = 0
except BaseException:
    traceback.print_exc()
sys.stderr.flush()
os._exit(status)
