# SPDX-License-Identifier: BSD-3-Clause
"""A series of files over time: each step has its own picture, also in an animation; levels of the reader change."""

from vtkmodules.vtkIOXML import vtkXMLUniformGridAMRWriter

from Support import *

load_plugin()

# Three steps, in files that every expat reads (raw data they do not).
names = []
for step, name in enumerate(("Exajet-wing", "Impact-5K", "Cloud")):
    scene = simple.ExaBricksScene(Scene=name, NumberOfLeafCells=60000)
    scene.UpdatePipeline()
    names.append(os.path.abspath(f"step{step}.vth"))
    writer = vtkXMLUniformGridAMRWriter()
    writer.SetInputDataObject(scene.GetClientSideObject().GetOutputDataObject(0))
    writer.SetDataModeToBinary()
    writer.SetFileName(names[-1])
    assert writer.Write()
    simple.Delete(scene)

view = make_view()
own = []
for name in names:
    reader = simple.OpenDataFile([name])
    reader.DefaultNumberOfLevels = 0  # all
    reader.UpdatePipeline()
    display = show(reader, view)
    display.OpacityUnitDistance = 0.05 if own else 8.0
    simple.Render(view)
    simple.ResetCamera(view)
    own.append(picture(view, f"own{len(own)}"))
    print(names[len(own) - 1], statistics(display))
    assert drawn(own[-1]) > 0.01, drawn(own[-1])
    simple.Delete(display)
    simple.Delete(reader)

series = simple.OpenDataFile(names)
series.DefaultNumberOfLevels = 0
series.UpdatePipeline()
assert list(series.TimestepValues) == [0.0, 1.0, 2.0], series.TimestepValues
display = show(series, view)
scene = simple.GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
assert scene.EndTime == 2.0, scene.EndTime


def at(step, name):
    display.OpacityUnitDistance = 0.05 if step else 8.0
    scene.AnimationTime = float(step)
    simple.Render(view)
    simple.ResetCamera(view)
    pixels = picture(view, name)
    print(step, statistics(display))
    return pixels


for turn in range(2):  # the second time from the view's cache
    for step in (0, 1, 2, 1):
        expect_alike(at(step, f"series{turn}{step}"), own[step], 50.0, f"step {step}")

# An animation writes the same frames.
at(1, "before")
pictures = []
for step in (1, 2):
    scene.AnimationTime = float(step)
    pictures.append(picture(view, f"still{step}"))
expect_different(pictures[0], pictures[1], 35.0, "steps 1 and 2")
simple.SaveAnimation("frame.png", view, FrameWindow=[0, 2])
for step in (1, 2):
    expect_alike(read_picture(f"frame.{step:04d}.png"), pictures[step - 1], 50.0, f"frame {step}")

# Fewer levels of the same data, and all of them again.
scene.AnimationTime = 0.0
all_levels = at(0, "allLevels")
assert "4 levels" in statistics(display), statistics(display)
series.DefaultNumberOfLevels = 1
series.UpdatePipeline()
coarse = at(0, "coarse")
assert statistics(display).startswith("1 level"), statistics(display)
expect_different(coarse, all_levels, 45.0, "one level")
series.DefaultNumberOfLevels = 0
series.UpdatePipeline()
expect_alike(at(0, "levelsAgain"), all_levels, 60.0, "all levels again")
