# SPDX-License-Identifier: BSD-3-Clause
"""Changes of properties are undone and redone. (Their pictures are up to ParaView's window, which renders after it.)"""

from paraview import servermanager
from paraview.modules.vtkRemotingServerManager import vtkSMUndoStack, vtkSMUndoStackBuilder

from Support import *

load_plugin()
stack = vtkSMUndoStack()
builder = vtkSMUndoStackBuilder()
builder.SetUndoStack(stack)
servermanager.vtkSMProxyManager.GetProxyManager().SetUndoStackBuilder(builder)
scene = make_scene()
view = make_view()
display = show(scene, view)
display.OpacityUnitDistance = 5.0

changes = [
    ("OpacityUnitDistance", 8.0),
    ("Reconstruction", "Nearest"),
    ("ErrorTolerance", 0.01),
    ("VulkanDevice", "0"),
    ("Representation", "Outline"),
]


def values():
    return [str(display.GetPropertyValue(name)) for name, value in changes]


history = [values()]
for name, value in changes:
    builder.Begin(name)
    setattr(display, name, value)
    builder.End()
    builder.PushToStack()
    history.append(values())
    assert history[-1] != history[-2], name
for before in reversed(history[:-1]):
    assert stack.Undo()
    assert values() == before, (values(), before)
for after in history[1:]:
    assert stack.Redo()
    assert values() == after, (values(), after)
