# SPDX-License-Identifier: BSD-3-Clause
"""A first look at AMR: one call."""

from .display import has_display, in_notebook
from .scene import VolumeScene


def show(source, array=None, *, component=None, levels=None, log=None, color_map=None, size=None, interactive=None):
    """Shows AMR in a viewer, or returns a Picture of it.

        exabricks.show("plt00216", "density")

    `source`: the path of an AMR file, a vtkOverlappingAMR, or a VolumeScene, which has its own array and colors. The other
    arguments are those of VolumeScene; `size`: width and height in pixels; None: 800 x 600, or the scene's. `interactive`:
    whether a viewer opens; None: where there is a display, but not in a notebook, which shows the Picture. Raises ReadError
    where nothing can be read, ValueError for arguments that do not fit, and RuntimeError where a viewer is asked for and
    there is no display.
    """
    if isinstance(source, VolumeScene):
        if (array, component, levels, log, color_map) != (None,) * 5:
            raise ValueError("expected a scene alone, which has its array and colors, found more: use set_array() and "
                             "set_color_map() of the scene")
        scene = source
        scene.size = tuple(size or scene.size)
    else:
        scene = VolumeScene(source, array, component=component, levels=levels, log=log, color_map=color_map or "viridis",
                            size=size or (800, 600))
    if interactive is None:
        interactive = has_display() and not in_notebook()
    if not interactive:
        return scene.picture()
    if not has_display():
        raise RuntimeError("expected a display to open a window on, found none: set DISPLAY, or leave interactive out")
    from .viewer import Viewer  # with VTK's widgets and charts, which pictures do without

    Viewer(scene).start()
    return None
