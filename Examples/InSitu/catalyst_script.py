# SPDX-License-Identifier: BSD-3-Clause
"""A Catalyst script: draws the AMR "mesh" of a simulation with the representation ExaBricks, a picture each step.

Catalyst runs it on all ranks of a simulation, whatever language that is written in. $EXABRICKS_PLUGIN is the plugin's file,
if ParaView does not load it by itself. Pictures come into the folder "pictures" where the simulation runs.
"""

import os

from paraview import catalyst, simple

plugin = os.environ.get("EXABRICKS_PLUGIN")
if plugin:
    simple.LoadPlugin(plugin, remote=False, ns=vars(simple))

mesh = simple.TrivialProducer(registrationName="mesh")

view = simple.CreateView("RenderView")
view.ViewSize = [320, 240]
view.OrientationAxesVisibility = 0
view.UseFXAA = 0  # it smooths the picture of several ranks, and leaves a volume as it is on one
if hasattr(view, "UseColorPaletteForBackground"):
    view.UseColorPaletteForBackground = 0
view.Background = [0.0, 0.0, 0.0]
view.CameraFocalPoint = [0.5, 0.5, 0.5]
view.CameraPosition = [2.1, -1.0, 1.5]
view.CameraViewUp = [0.0, 0.0, 1.0]
view.CameraViewAngle = 30.0

display = simple.Show(mesh, view)
display.SetRepresentationType("ExaBricks")
simple.ColorBy(display, ("CELLS", "density"))
color = simple.GetColorTransferFunction("density")
color.ColorSpace = "RGB"
color.RGBPoints = [0.0, 0.1, 0.2, 0.8, 1.0, 1.0, 0.9, 0.6, 2.2, 1.0, 0.2, 0.1]
opacity = simple.GetOpacityTransferFunction("density")
opacity.Points = [0.0, 0.0, 0.5, 0.0, 0.2, 0.0, 0.5, 0.0, 2.2, 0.6, 0.5, 0.0]
color.ScalarOpacityFunction = opacity
display.OpacityUnitDistance = 0.1

pictures = simple.CreateExtractor("PNG", view, registrationName="pictures")
pictures.Trigger = "TimeStep"
pictures.Writer.FileName = "step{timestep:02d}.png"
pictures.Writer.ImageResolution = view.ViewSize

options = catalyst.Options()
options.ExtractsOutputDirectory = "pictures"
options.GlobalTrigger = "TimeStep"
