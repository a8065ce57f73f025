# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvbatch on two ranks: that their pictures have seams is said, once, and a tolerance is not used there."""

from vtkmodules.vtkParallelCore import vtkMultiProcessController

from Support import *

assert vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses() == 2, "run by mpiexec -n 2 pvbatch"

load_plugin()
collector = Collector()
scene = make_scene()
view = make_view()
display = show(scene, view)
look_at(scene, view)
first = picture(view, "first")
assert drawn(first) > 0.1, drawn(first)
picture(view, "again")
collector.expect_said("2 ranks", "seams", "Use one rank")

# Each rank would choose steps and levels of its own.
display.ErrorTolerance = 0.05
picture(view, "tolerance")
expect_alike(picture(view, "toleranceAgain"), first, 70.0, "with a tolerance")
collector.expect_said("ErrorTolerance is not used")
