# SPDX-License-Identifier: BSD-3-Clause
"""ExaBricks for VTK: volume rendering of vtkOverlappingAMR by active brick regions.

    import exabricks
    exabricks.show("plt00216", "density")

    mapper = exabricks.vtkExaBricksVolumeMapper()
    mapper.SetInputDataObject(exabricks.read("plt00216", arrays="density"))
"""

# VTK's rendering classes register themselves when their module is loaded.
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401

from .arrays import amr_from_arrays
from .reading import ArrayInfo, ReadError, list_arrays, read
from .scene import Picture, VolumeScene
from .viewing import show
from .vtkRenderingVolumeExaBricks import (
    vtkExaBricksBuilder,
    vtkExaBricksData,
    vtkExaBricksFileCheck,
    vtkExaBricksFirstPicture,
    vtkExaBricksPicker,
    vtkExaBricksRedistribute,
    vtkExaBricksSceneSource,
    vtkExaBricksVolumeMapper,
)
from .yt_adapter import amr_from_yt

__version__ = "1.0.0"

__all__ = [
    "ArrayInfo",
    "Picture",
    "ReadError",
    "VolumeScene",
    "amr_from_arrays",
    "amr_from_yt",
    "list_arrays",
    "read",
    "show",
    "vtkExaBricksBuilder",
    "vtkExaBricksData",
    "vtkExaBricksFileCheck",
    "vtkExaBricksFirstPicture",
    "vtkExaBricksPicker",
    "vtkExaBricksRedistribute",
    "vtkExaBricksSceneSource",
    "vtkExaBricksVolumeMapper",
]
