"""ExaBricks for VTK: volume rendering of vtkOverlappingAMR by active brick regions.

    import exabricks
    mapper = exabricks.vtkExaBricksVolumeMapper()
    mapper.SetInputConnection(reader.GetOutputPort())
"""

# VTK's rendering classes register themselves when their module is loaded.
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401

from .vtkRenderingVolumeExaBricks import (
    vtkExaBricksBuilder,
    vtkExaBricksData,
    vtkExaBricksFileCheck,
    vtkExaBricksFirstPicture,
    vtkExaBricksPicker,
    vtkExaBricksSceneSource,
    vtkExaBricksVolumeMapper,
)

__version__ = "0.1.0"

__all__ = [
    "vtkExaBricksBuilder",
    "vtkExaBricksData",
    "vtkExaBricksFileCheck",
    "vtkExaBricksFirstPicture",
    "vtkExaBricksPicker",
    "vtkExaBricksSceneSource",
    "vtkExaBricksVolumeMapper",
]
