# SPDX-License-Identifier: BSD-3-Clause
"""State files, state scripts and traces give the same picture again, with all settings."""

from paraview import smstate, smtrace

from Support import *

load_plugin()


def settings(display):
    return {
        "Representation": str(display.Representation),
        "OpacityUnitDistance": display.OpacityUnitDistance,
        "Reconstruction": str(display.Reconstruction),
        "StepScale": display.StepScale,
        "ErrorTolerance": display.ErrorTolerance,
        "EarlyTerminationOpacity": display.EarlyTerminationOpacity,
        "Traversal": str(display.Traversal),
        "VulkanDevice": display.VulkanDevice,
    }


def restored(what):
    """The view of a session that was just loaded, after a look at its settings."""
    view = simple.GetActiveViewOrCreate("RenderView")
    scene = [source for key, source in simple.GetSources().items() if "ExaBricksScene" in key[0]]
    assert len(scene) == 1, (what, simple.GetSources())
    assert settings(simple.GetDisplayProperties(scene[0], view)) == expected, what
    return view



scene = make_scene()
view = make_view()
display = show(scene, view)
look_at(scene, view)
display.OpacityUnitDistance = 12.0
display.Reconstruction = "Completed"
display.StepScale = 0.7
display.EarlyTerminationOpacity = 0.99
display.Traversal = "k-d tree"
display.VulkanDevice = "0"
expected = settings(display)
first = picture(view, "first")
assert drawn(first) > 0.05, drawn(first)

simple.SaveState("session.pvsm")
scripted = smstate.get_state()

simple.ResetSession()
load_plugin()
simple.LoadState("session.pvsm")
expect_alike(picture(restored("state file"), "fromState"), first, 60.0, "state file")


def replay(name, script):
    simple.ResetSession()
    load_plugin()
    open(name + ".txt", "w").write(script)  # to look at
    exec(compile(script, name, "exec"), {"__name__": "replayed"})


replay("script", scripted)
expect_alike(picture(restored("state script"), "fromScript"), first, 60.0, "state script")

# What is done while a trace is taken, done again.
simple.ResetSession()
load_plugin()
smtrace.start_trace()
view = make_view()
display = simple.Show(make_scene(), view)
display.SetRepresentationType("ExaBricks")
simple.ColorBy(display, ("CELLS", "value"))
simple.Render(view)
simple.ResetCamera(view)
simple.Render(view)
traced = smtrace.stop_trace()
expected = settings(display)
done = picture(view, "traced")
assert drawn(done) > 0.1, drawn(done)
replay("trace", traced if isinstance(traced, str) else "\n".join(traced))
view = restored("trace")
view.ViewSize = [240, 180]
darken(view)
expect_alike(picture(view, "replayed"), done, 50.0, "trace")
