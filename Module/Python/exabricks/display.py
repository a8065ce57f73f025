# SPDX-License-Identifier: BSD-3-Clause
"""Whether there is a display to draw on, and one that nobody sees where VTK needs it."""

import ctypes
import ctypes.util
import os
import shutil
import subprocess
import sys

from vtkmodules.vtkCommonCore import vtkVersion


def in_notebook():
    """Whether this runs in a Jupyter notebook, which shows what an expression returns."""
    shell = sys.modules.get("IPython")
    kernel = shell and shell.get_ipython()
    return bool(kernel) and type(kernel).__name__ == "ZMQInteractiveShell"


_kept = []  # connections: a server whose last client leaves may start anew, and refuses those who come just then
_own_server = []  # the X server of ensure_drawing(), which nobody sees


def _connect():
    """Whether an X server answers."""
    if _kept:
        return True
    library = ctypes.util.find_library("X11")
    if not os.environ.get("DISPLAY") or not library:
        return False
    x11 = ctypes.CDLL(library)
    x11.XOpenDisplay.restype = ctypes.c_void_p
    connection = x11.XOpenDisplay(None)
    if connection:
        _kept.append(connection)
    return bool(connection)


def has_display():
    """Whether windows can be opened that somebody sees."""
    if sys.platform in ("win32", "darwin"):
        return True
    return not _own_server and _connect()


def ensure_drawing():
    """Lets VTK draw off screen where there is no display: before 9.4 it ends the program without an X server.

    Starts Xvfb (Debian: xvfb), which ends with this program. Raises RuntimeError where that is missing.
    """
    version = (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion())
    if has_display() or _own_server or version >= (9, 4):
        return
    if not shutil.which("Xvfb"):
        raise RuntimeError(
            f"VTK {vtkVersion.GetVTKVersion()} draws on an X server only, and there is none. Install xvfb, or set DISPLAY")
    # It ends when the last client leaves: the connection that is kept.
    server = subprocess.Popen(  # pylint: disable=consider-using-with
        ["Xvfb", "-displayfd", "1", "-screen", "0", "1280x1024x24", "-terminate", "-nolisten", "tcp"],
        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    number = server.stdout.readline().strip()
    if number:
        os.environ["DISPLAY"] = ":" + number
    if not number or not _connect():
        server.terminate()
        raise RuntimeError("Xvfb did not start: run it by hand to see why")
    _own_server.append(server)
