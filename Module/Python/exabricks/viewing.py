# SPDX-License-Identifier: BSD-3-Clause
"""A first look at AMR: one call."""

import sys

from .display import has_display, in_notebook
from .scene import VolumeScene


def show(source, array=None, *, component=None, levels=None, log=None, color_map="viridis", size=(800, 600),
         interactive=None):
    """Shows AMR in a viewer, or returns a Picture of it.

        exabricks.show("plt00216", "density")

    `source`: the path of an AMR file, a vtkOverlappingAMR, or a VolumeScene. The other arguments are those of VolumeScene;
    `size`: width and height in pixels. `interactive`: whether a viewer opens; None: where there is a display, but not in a
    notebook, which shows the Picture. Raises ReadError where nothing can be read, and ValueError for arguments that do not
    fit.
    """
    scene = source if isinstance(source, VolumeScene) else VolumeScene(
        source, array, component=component, levels=levels, log=log, color_map=color_map, size=size)
    if interactive is None:
        interactive = has_display() and not in_notebook() and sys.stdin is not None
    if not interactive:
        return scene.picture(size)
    from .viewer import Viewer  # with VTK's widgets and charts, which pictures do without

    Viewer(scene).start()
    return None
