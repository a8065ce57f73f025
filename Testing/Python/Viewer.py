# SPDX-License-Identifier: BSD-3-Clause
"""The viewer by events: keys, the pointer in the picture and in the editor, scenes that are saved and opened again."""

import json
import os
import sys
import tempfile

try:
    import numpy
except ImportError:
    print("takes numpy (Debian: python3-numpy)")
    sys.exit(125)

import exabricks
from exabricks import viewer as viewing

DATA = os.path.join(sys.argv[sys.argv.index("-D") + 1], "rt_medium", "rt_medium.vthb")
SIZE = (480, 400)
EDITOR = int(viewing.EDITOR_HEIGHT * SIZE[1])  # rows of pixels from below

scene = exabricks.VolumeScene(DATA, "magvort", size=SIZE)
viewer = viewing.Viewer(scene, [DATA, DATA])
interactor = viewer.interactor
interactor.Initialize()
viewer.render()


def pixels():
    viewer.render()
    return viewing.grab(viewer.window).pixels.astype(float) / 255.0


def volume_part():
    """Rows of the picture above the editor and the line of text, without the scalar bar and the axes."""
    return pixels()[:SIZE[1] - EDITOR - 40, 100:400]


def press(key):
    interactor.SetKeySym(key)
    interactor.InvokeEvent("KeyPressEvent")


def drag(start, end):
    interactor.SetEventInformation(*start)
    interactor.InvokeEvent("MouseMoveEvent")
    interactor.InvokeEvent("LeftButtonPressEvent")
    for part in (0.5, 1.0):
        interactor.SetEventInformation(*(round(a + part * (b - a)) for a, b in zip(start, end)))
        interactor.InvokeEvent("MouseMoveEvent")
    interactor.InvokeEvent("LeftButtonReleaseEvent")


def rounded(settings):
    """Numbers as text: VTK makes directions one long anew."""
    return json.loads(json.dumps(settings), parse_float=lambda text: f"{float(text):.9g}")


def drawn(picture):
    return float(numpy.mean(picture.max(axis=-1) > 0.1))


first = volume_part()
assert drawn(first) > 0.1, drawn(first)
assert pixels()[SIZE[1] - EDITOR + 5:, 50:].max() > 0.4, "the editor shows something"

# The pointer moves the camera in the picture, and control points in the editor.
before = scene.camera.GetPosition()
drag((200, 300), (260, 310))
assert scene.camera.GetPosition() != before, "the camera is moved"
assert numpy.abs(volume_part() - first).max() > 0.1
before, opacity = scene.camera.GetPosition(), scene.opacity
point = [0.0] * 4
scene.volume_property.GetScalarOpacity().GetNodeValue(len(opacity) - 1, point)
bottom = viewer.editor.chart.GetAxis(1)  # vtkAxis.BOTTOM
left = viewer.editor.chart.GetAxis(0)


def in_window(value, opacity_of_value):
    x = bottom.GetPoint1()[0] + (value - bottom.GetMinimum()) / (bottom.GetMaximum() - bottom.GetMinimum()) \
        * (bottom.GetPoint2()[0] - bottom.GetPoint1()[0])
    y = left.GetPoint1()[1] + opacity_of_value * (left.GetPoint2()[1] - left.GetPoint1()[1])
    return round(x), round(y)


inner = opacity[len(opacity) // 2]
drag(in_window(*inner), in_window(inner[0], 0.9))
assert scene.camera.GetPosition() == before, "the camera stays"
assert scene.opacity != opacity, "a control point is moved"
assert max(value for _, value in scene.opacity) > 0.7, scene.opacity

# Keys.
interactor.SetEventInformation(200, 260)
press("h")
assert viewer.help.GetVisibility()
press("h")
names = [scene.array]
press("n")
names.append(scene.array)
press("n")
assert scene.array == names[0] and set(names) == {"density", "magvort"}, names
assert not scene.log
read_once = scene.amr
press("g")
assert scene.log and "log10(magvort)" in viewer.bar.GetTitle()
assert scene.color_range[1] < 1.5, scene.color_range
press("g")
assert not scene.log and scene.amr is read_once
press("m")
assert scene.color_map == "plasma"
assert scene.volume_property.GetRGBTransferFunction().GetRange() == scene.color_range
for mode in ("maximum", "minimum", "average", "additive", "isosurface", "slice", "composite"):
    press("b")
    assert scene.to_dict()["view"]["blend_mode"] == mode
    assert viewer.slice_widget.GetEnabled() == (mode == "slice")
    assert drawn(volume_part()) > 0.01, mode
    if mode == "slice":  # its plane is moved by the widget, and kept in a scene
        viewer.slice_widget.GetRepresentation().SetNormal(1.0, 0.0, 0.0)
        viewer.slice_widget.InvokeEvent("InteractionEvent")
        assert scene.slice[1] == (1.0, 0.0, 0.0), scene.slice
        assert scene.to_dict()["view"]["slice"]["normal"] == [1.0, 0.0, 0.0]
press("r")
viewer.render()
press("v")
assert "in cell" in viewer.said and "level" in viewer.said, viewer.said
press("i")
assert scene.to_dict()["view"]["blend_mode"] == "isosurface" and scene.to_dict()["view"]["iso_values"]
press("b")
press("b")
assert scene.blend_mode == "composite"
press("plus")
assert scene.mapper.GetStepScale() == 2.0
press("minus")
press("minus")
assert scene.mapper.GetStepScale() == 0.5
press("plus")
press("less")
assert scene.mapper.GetLevelRange()[1] == 1
press("greater")
press("greater")
assert scene.mapper.GetLevelRange()[1] > 2
whole = drawn(volume_part())
press("k")
assert scene.mapper.GetClippingPlanes().GetNumberOfItems() == 1
# What a scene is cut by is there to be moved in a viewer that opens it.
press("x")
cut = exabricks.VolumeScene(DATA, "magvort", size=SIZE)
cut.apply(scene.to_dict())
other = viewing.Viewer(cut)
other.interactor.Initialize()
other.render()
assert other.plane_widget.GetEnabled() and other.box_widget.GetEnabled() and not other.slice_widget.GetEnabled()
numpy.testing.assert_allclose(other.plane_widget.GetRepresentation().GetNormal(),
                              scene.mapper.GetClippingPlanes().GetItemAsObject(0).GetNormal())
other.close()
press("x")
press("k")
assert scene.mapper.GetClippingPlanes().GetNumberOfItems() == 0
press("x")
assert scene.mapper.GetCropping()
press("x")
assert not scene.mapper.GetCropping() and abs(drawn(volume_part()) - whole) < 0.01
press("Right")
assert viewer.step == 1 and "step 2 of 2" in viewer.status.GetInput()
press("Left")
assert viewer.step == 0
press("space")
assert viewer.timer is not None
interactor.InvokeEvent("TimerEvent")
assert viewer.step == 1
press("space")
assert viewer.timer is None
press("e")
assert pixels()[SIZE[1] - 60:SIZE[1] - 40, 50:400].max() < 1.0 and not viewer.editor_shown
press("e")

# Screenshots and scenes go into files with free names; a scene opens again as it was.
with tempfile.TemporaryDirectory() as folder:
    home = os.getcwd()
    os.chdir(folder)
    try:
        press("s")
        press("s")
        press("w")
        assert sorted(os.listdir(".")) == ["exabricks-000.png", "exabricks-001.png", "exabricks-scene-000.json"]
        again = exabricks.VolumeScene.load("exabricks-scene-000.json")
        assert rounded(again.to_dict()) == rounded(scene.to_dict())
        # Each window draws with buffers of its own; the numbers are the same.
        alone = exabricks.VolumeScene.load("exabricks-scene-000.json").picture((120, 100)).pixels.astype(int)
        assert numpy.abs(alone - again.picture((120, 100)).pixels.astype(int)).max() <= 1
        assert alone.max() > 60

        for text, word in (("hello", "no JSON"), ("[1]", "list"), ('{"input": {}}', "input")):
            with open("wrong.json", "w", encoding="utf-8") as file:
                file.write(text)
            try:
                exabricks.VolumeScene.load("wrong.json")
                raise AssertionError(text)
            except ValueError as error:
                assert "expected a scene" in str(error) and word in str(error), error

        # Colors of ParaView's presets.
        with open("preset.json", "w", encoding="utf-8") as file:
            file.write('[{"Name": "two", "ColorSpace": "RGB", "RGBPoints": [0, 1, 0, 0, 10, 0, 0, 1]}]')
        low, high = scene.color_range
        scene.load_color_preset("preset.json")
        colors = scene.volume_property.GetRGBTransferFunction()
        assert scene.color_range == (low, high) and colors.GetColor(low) == (1.0, 0.0, 0.0), colors.GetColor(low)
        # Another array keeps the colors, and so does a scene.
        scene.set_array("density")
        scene.save("preset-scene.json")
        kept = exabricks.VolumeScene.load("preset-scene.json")
        low, high = kept.color_range
        assert numpy.allclose(kept.volume_property.GetRGBTransferFunction().GetColor(high), (0.0, 0.0, 1.0), atol=1e-6)
        scene.set_array("magvort")
        try:
            scene.load_color_preset("preset.json", "three")
            raise AssertionError("an unknown preset")
        except ValueError as error:
            assert "'three'" in str(error) and "two" in str(error), error
    finally:
        os.chdir(home)

# A button that is let go outside of the editor is let go.
press("m")  # the editor shows the functions that the scene has now
opacity = scene.opacity
inner = opacity[len(opacity) // 2]
drag(in_window(*inner), (in_window(*inner)[0], SIZE[1] - 40))
interactor.SetEventInformation(in_window(*inner)[0] + 30, 60)
moved = scene.opacity
interactor.InvokeEvent("MouseMoveEvent")
assert scene.opacity == moved and moved != opacity

# A step that cannot be read leaves all as it was, and is told of.
viewer.files.append("no-such-file.vthb")
before = scene.to_dict()
viewer.go_to(0)
press("Right")
press("Right")
assert viewer.step == 1 and "no-such-file" in viewer.said and scene.to_dict() == before, viewer.said

# Pictures beside the viewer are without its annotations, and afterwards the scene is free for another one.
beside = scene.picture((120, 100)).pixels.astype(int)
viewer.render()
viewer.close()
assert scene.renderer.GetViewProps().GetNumberOfItems() == 1 and not scene.annotations, "the volume alone is left"
assert scene.renderer.GetViewport() == (0.0, 0.0, 1.0, 1.0)
assert numpy.abs(scene.picture((120, 100)).pixels.astype(int) - beside).max() <= 1
again = viewing.Viewer(scene)
again.interactor.Initialize()
again.render()
again.close()

# The program.
assert viewing.main(["no-such-file.vthb"]) == 3
with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, "window.png")
    assert viewing.main([DATA, "-a", "density", "--size", "300x260", "--screenshot", path]) == 0
    assert os.path.getsize(path) > 1000
