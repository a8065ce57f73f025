# SPDX-License-Identifier: BSD-3-Clause
"""The viewer: a volume of AMR in a window, with a transfer-function editor and keys for the rest."""

import argparse
import os
import sys

import vtkmodules.vtkRenderingFreeType  # noqa: F401  draws text
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersSources import vtkOutlineSource
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkInteractionWidgets import (
    vtkBoxRepresentation,
    vtkBoxWidget2,
    vtkImplicitPlaneRepresentation,
    vtkImplicitPlaneWidget2,
    vtkOrientationMarkerWidget,
)
from vtkmodules.vtkRenderingAnnotation import vtkAxesActor, vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderWindow,
    vtkRenderWindowInteractor,
    vtkTextActor,
)

from .display import has_display
from .editor import TransferFunctionEditor
from .reading import ReadError
from .scene import BLEND_MODES, VolumeScene, color_map_names, grab
from .vtkRenderingVolumeExaBricks import vtkExaBricksPicker

EDITOR_HEIGHT = 0.28  # of the window

# What each key does: its name, as VTK tells it, and words.
KEYS = (
    ("h", "these keys, or none"),
    ("e", "the editor of colors and opacities, or none"),
    ("n", "the next array"),
    ("g", "logarithms, or the values themselves"),
    ("m", "the next color map"),
    ("b", "the next blend mode; a slice has a plane to move"),
    ("i", "iso-surface of the value under the pointer"),
    ("plus", "longer steps: faster"),
    ("minus", "shorter steps: finer"),
    ("less", "one level fewer"),
    ("greater", "one level more"),
    ("k", "a clipping plane to move, or none"),
    ("x", "a cropping box to move, or none"),
    ("v", "the value under the pointer"),
    ("Left", "the time step before"),
    ("Right", "the next time step"),
    ("space", "play, or stop"),
    ("r", "all that shows into the picture"),
    ("s", "a screenshot into a file"),
    ("w", "the scene into a file"),
    ("q", "the end"),
)
LABELS = {"plus": "+", "minus": "-", "less": "<", "greater": ">", "Left": "left", "Right": "right"}


class Viewer:
    """A window that shows a VolumeScene.

    `files`: paths of time steps, of which the scene shows the first one. Keys are listed on the screen. Colors and opacities
    are edited below it.
    """

    def __init__(self, scene, files=()):
        self.scene = scene
        self.files = list(files)
        self.step = 0
        self.timer = None
        self.pressed = False  # a button of the pointer, in the editor
        self.said = ""

        self.window = vtkRenderWindow()
        self.window.SetWindowName("exabricks-view")
        self.window.SetMultiSamples(0)
        self.window.SetSize(*scene.size)
        self.window.AddRenderer(scene.renderer)
        self.interactor = vtkRenderWindowInteractor()
        self.interactor.SetRenderWindow(self.window)
        self.camera_style = vtkInteractorStyleTrackballCamera()
        _take_keys_from(self.camera_style)
        self.interactor.SetInteractorStyle(self.camera_style)
        for event in ("MouseMoveEvent", "MouseWheelForwardEvent", "MouseWheelBackwardEvent"):
            self.interactor.AddObserver(event, self._choose_style, 10.0)
        for button in ("Left", "Middle", "Right"):
            self.interactor.AddObserver(button + "ButtonPressEvent", self._press, 10.0)
            self.interactor.AddObserver(button + "ButtonReleaseEvent", self._release, 10.0)
        self.interactor.AddObserver("KeyPressEvent", self._key_pressed, 10.0)
        self.interactor.AddObserver("TimerEvent", self._tick)
        self.window.AddObserver("AbortCheckEvent", self._abort_if_asked)

        self._annotate()
        self.editor = TransferFunctionEditor(self._editing, self._edited)
        self.editor.renderer.SetViewport(0.0, 0.0, 1.0, EDITOR_HEIGHT)
        self.editor_shown = True
        _take_keys_from(self.editor.style)
        self._make_cuts()
        self._follow_data()
        self._follow_cuts()
        self._layout()

    # What is beside the volume

    def _add(self, prop):
        self.scene.renderer.AddViewProp(prop)
        self.scene.annotations.append(prop)

    def close(self):
        """Leaves the scene as it was before, but for what was set of it."""
        for widget in (self.plane_widget, self.slice_widget, self.box_widget, self.axes):
            widget.SetEnabled(0)
        for prop in (self.outline_actor, self.bar, self.help, self.status):
            self.scene.renderer.RemoveViewProp(prop)
            self.scene.annotations.remove(prop)
        self.scene.renderer.SetViewport(0.0, 0.0, 1.0, 1.0)
        self.window.RemoveRenderer(self.scene.renderer)
        self.scene.volume.ReleaseGraphicsResources(self.window)

    def _annotate(self):
        self.outline = vtkOutlineSource()
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(self.outline.GetOutputPort())
        outline = self.outline_actor = vtkActor()
        outline.SetMapper(mapper)
        outline.GetProperty().SetColor(0.6, 0.6, 0.6)
        outline.GetProperty().LightingOff()
        outline.PickableOff()
        self._add(outline)
        self.bar = vtkScalarBarActor()
        self.bar.UnconstrainedFontSizeOn()
        self.bar.SetNumberOfLabels(5)
        self.bar.SetBarRatio(0.25)
        self.bar.SetPosition(0.88, 0.1)
        self.bar.SetWidth(0.1)
        self.bar.SetHeight(0.8)
        for text in (self.bar.GetTitleTextProperty(), self.bar.GetLabelTextProperty()):
            text.SetFontSize(13)
            text.BoldOff()
            text.ItalicOff()
            text.ShadowOff()
        self._add(self.bar)
        self.axes = vtkOrientationMarkerWidget()
        self.axes.SetOrientationMarker(vtkAxesActor())
        self.axes.SetInteractor(self.interactor)
        self.axes.SetViewport(0.0, 0.75, 0.16, 1.0)
        self.axes.SetEnabled(1)
        self.axes.InteractiveOff()
        self.axes.KeyPressActivationOff()
        self.help = vtkTextActor()
        self.help.SetInput("\n".join(f"{LABELS.get(key, key):>6}  {words}" for key, words in KEYS))
        self.help.GetTextProperty().SetFontFamilyToCourier()
        self.help.GetTextProperty().SetFontSize(13)
        self.help.GetTextProperty().SetBackgroundColor(0.0, 0.0, 0.0)
        self.help.GetTextProperty().SetBackgroundOpacity(0.7)
        self.help.GetTextProperty().SetVerticalJustificationToTop()
        self.help.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
        self.help.SetPosition(0.02, 0.97)
        self.help.VisibilityOff()
        self._add(self.help)
        self.status = vtkTextActor()
        self.status.GetTextProperty().SetFontSize(13)
        self.status.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
        self.status.SetPosition(0.01, 0.01)
        self._add(self.status)

    def _editing(self, *_):
        self.window.SetDesiredUpdateRate(self.interactor.GetDesiredUpdateRate())
        self.window.Render()

    def _edited(self, *_):
        self.window.SetDesiredUpdateRate(self.interactor.GetStillUpdateRate())
        self.render()

    def _make_plane_widget(self, moved):
        representation = vtkImplicitPlaneRepresentation()
        representation.SetPlaceFactor(1.0)
        representation.OutlineTranslationOff()
        representation.ScaleEnabledOff()
        representation.DrawPlaneOff()
        widget = vtkImplicitPlaneWidget2()
        widget.SetInteractor(self.interactor)
        widget.SetRepresentation(representation)
        widget.SetDefaultRenderer(self.scene.renderer)
        widget.KeyPressActivationOff()
        widget.AddObserver("InteractionEvent", moved)
        return widget

    def _place_plane_widget(self, widget, origin, normal):
        representation = widget.GetRepresentation()
        representation.PlaceWidget(self.scene.first.GetShownBounds())
        representation.SetOrigin(*origin)
        representation.SetNormal(*normal)

    def _make_cuts(self):
        self.plane = vtkPlane()
        self.plane_widget = self._make_plane_widget(self._plane_moved)
        self.slice_widget = self._make_plane_widget(self._slice_moved)
        box = vtkBoxRepresentation()
        box.SetPlaceFactor(1.0)
        self.box_widget = vtkBoxWidget2()
        self.box_widget.SetInteractor(self.interactor)
        self.box_widget.SetRepresentation(box)
        self.box_widget.SetDefaultRenderer(self.scene.renderer)
        self.box_widget.KeyPressActivationOff()
        self.box_widget.RotationEnabledOff()
        self.box_widget.AddObserver("InteractionEvent", self._box_moved)

    def _plane_moved(self, *_):
        self.plane_widget.GetRepresentation().GetPlane(self.plane)

    def _slice_moved(self, *_):
        representation = self.slice_widget.GetRepresentation()
        self.scene.set_slice(representation.GetOrigin(), representation.GetNormal())

    def _box_moved(self, *_):
        bounds = self.box_widget.GetRepresentation().GetBounds()
        self.scene.mapper.SetCroppingRegionPlanes(*bounds)

    def _follow_cuts(self):
        """Shows what a scene cuts the volume by, to be moved."""
        planes = self.scene.mapper.GetClippingPlanes()
        if planes and planes.GetNumberOfItems() == 1:
            self.plane = planes.GetItemAsObject(0)
            self._place_plane_widget(self.plane_widget, self.plane.GetOrigin(), self.plane.GetNormal())
            self.plane_widget.SetEnabled(True)
        if self.scene.mapper.GetCropping():
            self.box_widget.GetRepresentation().PlaceWidget(self.scene.mapper.GetCroppingRegionPlanes())
            self.box_widget.SetEnabled(True)
        self._follow_slice()

    def _follow_slice(self):
        on = self.scene.blend_mode == "slice"
        if on:
            self._place_plane_widget(self.slice_widget, *self.scene.slice)
        self.slice_widget.SetEnabled(on)

    # What follows the data

    def _title(self):
        scene = self.scene
        name = scene.array if scene.component is None else f"{scene.array}, component {scene.component}"
        return f"log10({name})" if scene.log else name

    def _follow_data(self):
        bounds = [0.0] * 6
        self.scene.data.GetBounds(bounds)
        self.outline.SetBounds(bounds)
        self.bar.SetTitle(self._title())
        self._follow_colors()

    def _follow_colors(self):
        self.bar.SetLookupTable(self.scene.volume_property.GetRGBTransferFunction())
        self.editor.fill(self.scene, self._title())

    def _layout(self):
        self.window.RemoveRenderer(self.editor.renderer)
        if self.editor_shown:
            self.window.AddRenderer(self.editor.renderer)
        self.scene.renderer.SetViewport(0.0, EDITOR_HEIGHT if self.editor_shown else 0.0, 1.0, 1.0)

    def _choose_style(self, *_):
        """The pointer edits where the editor is, and moves the camera elsewhere, until the button is let go."""
        if self.pressed:
            return
        _, y = self.interactor.GetEventPosition()
        inside = self.editor_shown and y < EDITOR_HEIGHT * self.window.GetSize()[1]
        style = self.editor.style if inside else self.camera_style
        if self.interactor.GetInteractorStyle() is not style:
            self.editor.attach(False)
            self.interactor.SetInteractorStyle(style)
            self.editor.attach(inside)

    def _press(self, *_):
        self._choose_style()
        # The style of the camera takes all events until the button is let go.
        self.pressed = self.interactor.GetInteractorStyle() is self.editor.style

    def _release(self, *_):
        self.pressed = False

    # Keys

    def _key_pressed(self, *_):
        key = self.interactor.GetKeySym()
        action = getattr(self, "_key_" + key, None) if key and key.isidentifier() else None
        if action:
            try:
                action()
            except (ValueError, OSError) as error:
                self.say(str(error))

    def say(self, text):
        """Writes a line at the lower edge of the picture."""
        self.said = text
        self.render()

    def render(self):
        """Draws, with the line of what is shown."""
        mapper = self.scene.mapper
        step = f", step {self.step + 1} of {len(self.files)}" if len(self.files) > 1 else ""
        blend = self.scene.blend_mode
        self.status.SetInput(
            f"{self._title()}{step}, {blend}, step scale {mapper.GetStepScale():g}"
            + (f", levels 0 to {mapper.GetLevelRange()[1]}" if mapper.GetLevelRange()[1] < 1000 else "")
            + (f": {self.said}" if self.said else "   (h: keys)"))
        self.window.Render()

    def _key_h(self):
        self.help.SetVisibility(not self.help.GetVisibility())
        self.render()

    def _key_e(self):
        self.editor_shown = not self.editor_shown
        self._layout()
        self.render()

    def _key_n(self):
        self.scene.set_array(_after(self.scene.array, self.scene.arrays))
        self._follow_data()
        self.say("")

    def _key_g(self):
        log = not self.scene.log
        try:
            self.scene.set_array(self.scene.array, log, self.scene.component)
        except ValueError:
            self.scene.set_array(self.scene.array, not log, self.scene.component)
            raise
        finally:
            self._follow_data()
        self.say("")

    def _key_m(self):
        self.scene.set_color_map(_after(self.scene.color_map, color_map_names()))
        self._follow_colors()
        self.say(self.scene.color_map)

    def _key_b(self):
        mode = _after(self.scene.blend_mode, BLEND_MODES)
        if mode == "isosurface" and not self.scene.iso_values:
            low, high = self.scene.color_range
            self.scene.set_iso_values([0.5 * (low + high)])
        self.scene.blend_mode = mode
        self._follow_slice()
        self._follow_colors()
        self.say("")

    def _pick(self):
        picker = vtkExaBricksPicker()
        x, y = self.interactor.GetEventPosition()
        return picker if picker.Pick(x, y, 0.0, self.scene.renderer) else None

    def _key_i(self):
        picker = self._pick()
        if not picker:
            self.say("nothing is under the pointer")
            return
        self.scene.set_iso_values([picker.GetValue()])
        self.scene.volume_property.ShadeOn()
        self.scene.blend_mode = "isosurface"
        self._follow_slice()
        self.say(f"iso-surface of {picker.GetValue():g}")

    def _key_v(self):
        picker = self._pick()
        self.say("nothing is under the pointer" if not picker else
                 f"{picker.GetValue():g} in cell {picker.GetCellId()} of block {picker.GetBlock()}, level {picker.GetLevel()}")

    def _scale_steps(self, factor):
        self.scene.mapper.SetStepScale(min(max(self.scene.mapper.GetStepScale() * factor, 1.0 / 16.0), 16.0))
        self.say("")

    def _key_plus(self):
        self._scale_steps(2.0)

    def _key_minus(self):
        self._scale_steps(0.5)

    def _change_levels(self, by):
        finest = self.scene.amr.GetNumberOfLevels() - 1
        last = min(self.scene.mapper.GetLevelRange()[1], finest) + by
        self.scene.mapper.SetLevelRange(0, min(max(last, 0), finest) if last < finest else 2**31 - 1)
        self.say("")

    def _key_less(self):
        self._change_levels(-1)

    def _key_greater(self):
        self._change_levels(1)

    def _key_k(self):
        mapper = self.scene.mapper
        mapper.RemoveAllClippingPlanes()
        on = not self.plane_widget.GetEnabled()
        if on:
            bounds = self.scene.first.GetShownBounds()
            middle = [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
            self._place_plane_widget(self.plane_widget, middle, (-1.0, 1.0, 0.0))
            self._plane_moved()
            mapper.AddClippingPlane(self.plane)
        self.plane_widget.SetEnabled(on)
        self.say("")

    def _key_x(self):
        on = not self.box_widget.GetEnabled()
        if on:
            self.box_widget.GetRepresentation().PlaceWidget(self.scene.first.GetShownBounds())
            self._box_moved()
        self.scene.mapper.SetCropping(on)
        self.box_widget.SetEnabled(on)
        self.say("")

    def go_to(self, step):
        """Shows a time step, counted from 0, with the colors and the camera as they are."""
        if not 0 <= step < len(self.files):
            return
        self.scene.set_source(self.files[step])
        self.step = step
        self._follow_data()
        self.say("")

    def _key_Left(self):
        self.go_to(self.step - 1)

    def _key_Right(self):
        self.go_to(self.step + 1)

    def _key_space(self):
        if self.timer is not None:
            self.interactor.DestroyTimer(self.timer)
            self.timer = None
        elif len(self.files) > 1:
            self.timer = self.interactor.CreateRepeatingTimer(100)

    def _tick(self, *_):
        if self.timer is not None:
            try:
                self.go_to((self.step + 1) % len(self.files))
            except (ValueError, OSError) as error:
                self._key_space()
                self.say(str(error))

    def _key_r(self):
        self.scene.frame()
        self.say("")

    def _key_s(self):
        path = _free_name("exabricks", ".png")
        self.window.Render()
        grab(self.window).save(path)
        self.say(f"written: {path}")

    def _key_w(self):
        path = _free_name("exabricks-scene", ".json")
        self.scene.save(path)
        self.say(f"written: {path}")

    def _key_q(self):
        self.interactor.ExitCallback()

    # The window

    def _abort_if_asked(self, *_):
        """A new event ends the picture that is being drawn."""
        if self.window.GetEventPending():
            self.window.SetAbortRender(1)

    def start(self):
        """Opens the window, and returns when it is closed: then the scene can be used elsewhere."""
        self.interactor.Initialize()
        self.render()
        self.interactor.Start()
        self.close()


def _take_keys_from(style):
    """Keys are the viewer's: a style that is observed does nothing of its own."""
    for event in ("CharEvent", "KeyPressEvent", "KeyReleaseEvent"):
        style.AddObserver(event, lambda *_: None)


def _after(name, names):
    """The next one in turn; the first after a name that is none of them."""
    names = list(names)
    return names[(names.index(name) + 1) % len(names)] if name in names else names[0]


def _free_name(stem, ending):
    number = 0
    while os.path.exists(f"{stem}-{number:03d}{ending}"):
        number += 1
    return f"{stem}-{number:03d}{ending}"


def _size(text):
    try:
        width, height = (int(part) for part in text.split("x"))
    except ValueError:
        width = height = 0
    if width < 1 or height < 1:
        raise argparse.ArgumentTypeError(f"expected a size such as 1024x768, found {text!r}")
    return width, height


def _parser():
    parser = argparse.ArgumentParser(
        prog="exabricks-view", description="Shows AMR data sets as volumes. Keys are listed in the window: press h.")
    parser.add_argument("files", nargs="*", metavar="FILE", help="an AMR data set; several are time steps")
    parser.add_argument("-a", "--array", help="cell array to draw [density, temperature, or the first that varies]")
    parser.add_argument("--component", type=int, metavar="N", help="of several, from 0 [their magnitude]")
    parser.add_argument("--levels", type=int, metavar="N", help="levels to read, from the coarsest [all]")
    log = parser.add_mutually_exclusive_group()
    log.add_argument("--log", action="store_true", default=None, help="draw logarithms [where they show more]")
    log.add_argument("--linear", dest="log", action="store_false", help="draw the values themselves")
    parser.add_argument("--color-map", choices=color_map_names(), metavar="NAME",
                        help=", ".join(color_map_names()))
    parser.add_argument("--color-preset", metavar="FILE.json", help="colors of a color map that ParaView exported")
    parser.add_argument("--scene", metavar="FILE.json", help="a scene that was saved, or the --stats of exabricks-render")
    parser.add_argument("--size", type=_size, metavar="WxH", help="of the window, pixels [1024x768, or the scene's]")
    parser.add_argument("--screenshot", metavar="FILE.png", help="write the window to a file, and end")
    return parser


def main(arguments=None):
    """The program exabricks-view. Returns its exit status: 0, 1 without a display, 2 for wrong arguments, 3 where nothing can
    be read, 4 where nothing can be written."""
    parser = _parser()
    asked = parser.parse_args(arguments)
    if not asked.files and not asked.scene:
        parser.error("give an AMR data set, or a --scene")
    if not has_display():
        print("exabricks-view: there is no display to open a window on: set DISPLAY, or use exabricks-render",
              file=sys.stderr)
        return 1
    try:
        if asked.scene:
            scene = VolumeScene.load(
                asked.scene, asked.files[0] if asked.files else None, array=asked.array, component=asked.component,
                levels=asked.levels, log=asked.log)
        else:
            scene = VolumeScene(asked.files[0], asked.array, component=asked.component, levels=asked.levels, log=asked.log,
                                size=(1024, 768))
        scene.size = asked.size or scene.size
        if asked.color_map:
            scene.set_color_map(asked.color_map)
        if asked.color_preset:
            scene.load_color_preset(asked.color_preset)
    except (ReadError, OSError, ValueError) as error:
        print(f"exabricks-view: {error}", file=sys.stderr)
        return 3
    viewer = Viewer(scene, asked.files)
    if asked.screenshot:
        viewer.render()
        try:
            grab(viewer.window).save(asked.screenshot)
        except OSError as error:
            print(f"exabricks-view: {error}", file=sys.stderr)
            return 4
        return 0
    viewer.start()
    return 0


if __name__ == "__main__":
    sys.exit(main())
