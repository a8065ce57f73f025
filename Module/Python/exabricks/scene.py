# SPDX-License-Identifier: BSD-3-Clause
"""A volume of AMR with all that is set of it, and the same as a file: what show(), the viewer and exabricks-render share."""

import json
import os

from vtkmodules.vtkCommonDataModel import vtkOverlappingAMR, vtkPiecewiseFunction, vtkPlane
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction,
    vtkRenderer,
    vtkRenderWindow,
    vtkVolume,
    vtkWindowToImageFilter,
)

from .display import ensure_drawing
from .reading import arrays_of, list_arrays, read
from .vtkRenderingVolumeExaBricks import vtkExaBricksFirstPicture, vtkExaBricksVolumeMapper

RECONSTRUCTIONS = ("basis", "nearest", "completed")
BLEND_MODES = {
    "composite": vtkExaBricksVolumeMapper.COMPOSITE_BLEND,
    "maximum": vtkExaBricksVolumeMapper.MAXIMUM_INTENSITY_BLEND,
    "minimum": vtkExaBricksVolumeMapper.MINIMUM_INTENSITY_BLEND,
    "average": vtkExaBricksVolumeMapper.AVERAGE_INTENSITY_BLEND,
    "additive": vtkExaBricksVolumeMapper.ADDITIVE_BLEND,
    "isosurface": vtkExaBricksVolumeMapper.ISOSURFACE_BLEND,
    "slice": vtkExaBricksVolumeMapper.SLICE_BLEND,
}
OF_THE_DATA = ("input", "picture", "method")  # parts of a scene that mean something to every program


def color_map_names():
    """The color maps that there are."""
    return vtkExaBricksFirstPicture.GetColorMapNames().split(", ")


class Picture:
    """What was drawn. Shows itself in a notebook.

    `image`: a vtkImageData of red, green, blue, 8 bits each, row 0 at the bottom.
    """

    def __init__(self, image):
        self.image = image

    @property
    def pixels(self):
        """A numpy array of bytes, [height][width][red, green, blue], row 0 at the top."""
        from vtkmodules.util.numpy_support import vtk_to_numpy  # only here, as it takes numpy

        width, height, _ = self.image.GetDimensions()
        return vtk_to_numpy(self.image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1]

    def save(self, path):
        """Writes a PNG. Raises OSError where that cannot be."""
        with open(path, "wb") as file:
            file.write(self._repr_png_())

    def _repr_png_(self):
        writer = vtkPNGWriter()
        writer.SetInputData(self.image)
        writer.WriteToMemoryOn()
        writer.Write()
        return bytes(memoryview(writer.GetResult()))


class VolumeScene:
    """A volume in a renderer, with colors, opacities and a camera chosen from the data.

    `source`: the path of an AMR file, or a vtkOverlappingAMR, whose blocks may get another array and hidden cells.
    `array`: of cells; None: density, temperature, or the first that varies. `component`: of several; None: their magnitude.
    `levels`: how many are read of a file, from the coarsest on. `log`: whether logarithms are drawn; None: where they show
    more. Raises ReadError where nothing can be read, and ValueError for arguments that do not fit.

        scene = exabricks.VolumeScene("plt00216", "density")
        scene.mapper.SetErrorTolerance(0.004)
        scene.picture((800, 600)).save("density.png")
    """

    def __init__(self, source, array=None, *, component=None, levels=None, log=None, color_map="viridis", size=(800, 600)):
        self.mapper = vtkExaBricksVolumeMapper()
        self.volume = vtkVolume()
        self.volume.SetMapper(self.mapper)
        self.renderer = vtkRenderer()
        self.renderer.AddVolume(self.volume)
        self.first = vtkExaBricksFirstPicture()
        self.size = tuple(size)
        self.levels = levels
        self.annotations = []  # props of a viewer, which are not in pictures
        self.iso_values = []  # those that somebody asked for
        self._preset = None  # of colors that are no named map: (color space, [(place in [0, 1], red, green, blue)])
        self._set_color_map(color_map)
        in_memory = isinstance(source, vtkOverlappingAMR)
        if in_memory and levels is not None:
            raise ValueError("expected levels of a file, of which so many are read, found data in memory: set "
                             "mapper.SetLevelRange() of the scene")
        self._own_amr = source if in_memory else None
        self.path = None if in_memory else os.fspath(source)
        self.array, self.component = None, None
        self._take(self._load(self.path, array, component))
        self._draw_array(log)
        self.frame()

    @property
    def volume_property(self):
        """The vtkVolumeProperty."""
        return self.volume.GetProperty()

    @property
    def camera(self):
        """The vtkCamera."""
        return self.renderer.GetActiveCamera()

    @property
    def data(self):
        """What is drawn, as bricks: a vtkExaBricksData."""
        return self.mapper.GetBuilder().GetOutput()

    def _set_color_map(self, name):
        if name not in color_map_names():
            raise ValueError(f"expected a color map of {', '.join(color_map_names())}, found {name!r}")
        self.first.SetColorMap(name)
        self.color_map = name

    def _load(self, path, array, component):
        """What is drawn of a file, or of the data in memory: (path, arrays, AMR, array, component)."""
        if path is None:
            # Logarithms are added to what is drawn, and are none of the data.
            infos = {name: info for name, info in arrays_of(self._own_amr).items() if not name.startswith("log10(")}
        else:
            infos = list_arrays(path)
        arrays = {name: (info.components, _varies(info.ranges)) for name, info in infos.items()}
        array, component = _choose_array(arrays, array, component)
        return path, arrays, self._read(path, arrays, array), array, component

    def _read(self, path, arrays, array):
        """The AMR with the array, and without cells that the volume fractions beside it call covered."""
        if path is None:
            amr = self._own_amr
        else:
            fractions = [name for name in arrays if vtkExaBricksFirstPicture.IsVolumeFraction(name)]
            amr = read(path, self.levels, [array, *(name for name in fractions if name != array)])
        if not vtkExaBricksFirstPicture.IsVolumeFraction(array):
            vtkExaBricksFirstPicture.HideCoveredCells(amr)
        return amr

    def _take(self, loaded):
        self.path, self.arrays, self.amr, self.array, self.component = loaded

    def set_array(self, array, log=None, component=None):
        """Draws another array of the file or data, with colors and opacities chosen anew. The camera stays."""
        if self.path is None:
            self._take(self._load(None, array, component))
        else:
            # A file is listed once, and read once for each array.
            array, component = _choose_array(self.arrays, array, component)
            amr = self.amr if array == self.array else self._read(self.path, self.arrays, array)
            self._take((self.path, self.arrays, amr, array, component))
        self._draw_array(log)

    def set_source(self, path):
        """Draws another file with the same array, colors, opacities and camera: another time step.

        Raises ReadError or ValueError where it cannot be drawn; then all is as it was.
        """
        self._take(self._load(os.fspath(path), self.array, self.component))
        self._select(self.log)
        self.mapper.Update()
        self.first.SetBlendMode(self.mapper.GetBlendMode())
        self.first.Choose(self.data)
        self.renderer.ResetCameraClippingRange()

    def _select(self, log):
        self.log = log
        name = self.array
        if log:
            component = -1 if self.component is None else self.component
            name = vtkExaBricksFirstPicture.AddLogarithm(self.amr, self.array, component)
        mapper = self.mapper
        mapper.SetInputDataObject(self.amr)
        mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectScalarArray(name)
        if log or self.component is None:
            mapper.SetVectorModeToMagnitude()
        else:
            mapper.SetVectorModeToComponent()
            mapper.SetVectorComponent(self.component)
        self.first.SetLogarithmic(bool(log))

    def _draw_array(self, log):
        self._select(bool(log))
        self.choose()
        if log is None and self.first.GetLogarithmWanted():
            self._select(True)
            self.choose()

    def choose(self):
        """Chooses colors and opacities from the data. Raises ValueError where no cell has a value."""
        self.mapper.Update()
        self.first.SetBlendMode(self.mapper.GetBlendMode())
        data = self.data
        if data.GetNumberOfLeafCells() <= data.GetNumberOfAbsentCells() or not self.first.Choose(data):
            raise ValueError(f"expected cells with values of {self.array!r}, found none"
                             + (" above zero: draw it without logarithms" if self.log else ""))
        self.first.InitializeProperty(self.volume_property)
        self._chosen_opacity = self._opacity_and_unit()
        self._spread_preset(self.first.GetColorRange())

    def set_color_map(self, name):
        """Spreads another color map over the range that the colors have."""
        self._set_color_map(name)
        self._preset = None
        vtkExaBricksFirstPicture.FillColorMap(name, self.color_range, self.volume_property.GetRGBTransferFunction())

    def load_color_preset(self, path, name=None):
        """Takes the colors of a color map that ParaView exported (.json), spread over the range that they have.

        `name`: of the map in the file; None: the first. Raises ValueError where there is none with colors.
        """
        with open(path, encoding="utf-8") as file:
            presets = json.load(file)
        presets = presets if isinstance(presets, list) else [presets]
        found = [preset for preset in presets
                 if preset.get("RGBPoints") and name in (None, preset.get("Name"))]
        if not found:
            raise ValueError(f"expected a color map of ParaView with RGBPoints{f' named {name!r}' if name else ''} "
                             f"in {path!r}, found {[preset.get('Name') for preset in presets]}")
        points = found[0]["RGBPoints"]
        begin, end = points[0], points[-4]
        width = end - begin or 1.0
        self._preset = (found[0].get("ColorSpace", "RGB"),
                        [((points[i] - begin) / width, *points[i + 1:i + 4]) for i in range(0, len(points), 4)])
        self.color_map = found[0].get("Name", os.fspath(path))
        self._spread_preset(self.color_range)

    def _spread_preset(self, color_range):
        if not self._preset:
            return
        space, points = self._preset
        colors = vtkColorTransferFunction()
        set_space = {"Lab": colors.SetColorSpaceToLab, "HSV": colors.SetColorSpaceToHSV,
                     "Diverging": colors.SetColorSpaceToDiverging}
        set_space.get(space, colors.SetColorSpaceToRGB)()
        low, high = color_range
        for place, *color in points:
            colors.AddRGBPoint(low + place * (high - low), *color)
        self.volume_property.SetColor(colors)

    @property
    def blend_mode(self):
        """A name in BLEND_MODES."""
        return next(name for name, mode in BLEND_MODES.items() if mode == self.mapper.GetBlendMode())

    @blend_mode.setter
    def blend_mode(self, name):
        """Opacities that were chosen, and that nobody has changed since, give way to those chosen for the mode."""
        if name not in BLEND_MODES:
            raise ValueError(f"expected a blend mode of {', '.join(BLEND_MODES)}, found {name!r}")
        self.mapper.SetBlendMode(BLEND_MODES[name])
        self.first.SetBlendMode(BLEND_MODES[name])
        if self._opacity_and_unit() == self._chosen_opacity and self.first.Choose(self.data):
            self.volume_property.GetScalarOpacity().DeepCopy(self.first.GetScalarOpacity())
            self.volume_property.SetScalarOpacityUnitDistance(self.first.GetScalarOpacityUnitDistance())
            self._chosen_opacity = self._opacity_and_unit()

    def _opacity_and_unit(self):
        return self.opacity, self.volume_property.GetScalarOpacityUnitDistance()

    @property
    def color_range(self):
        """The values at the ends of the color map, of the array or its logarithm."""
        return tuple(self.volume_property.GetRGBTransferFunction().GetRange())

    @property
    def opacity(self):
        """Values with their opacities of the unit distance."""
        function = self.volume_property.GetScalarOpacity()
        node = [0.0] * 4
        points = []
        for i in range(function.GetSize()):
            function.GetNodeValue(i, node)
            points.append((node[0], node[1]))
        return points

    @opacity.setter
    def opacity(self, points):
        function = vtkPiecewiseFunction()
        for value, opacity in points:
            function.AddPoint(value, opacity)
        self.volume_property.SetScalarOpacity(function)

    def frame(self):
        """Places the camera so that all that shows is in the picture."""
        self.first.InitializeCamera(self.camera, self.size[0] / self.size[1])
        self.renderer.ResetCameraClippingRange()

    def picture(self, size=None):
        """Draws off screen what the renderer shows, but for what a viewer adds, and returns a Picture.

        `size`: width and height in pixels.
        """
        ensure_drawing()
        window = vtkRenderWindow()
        window.SetOffScreenRendering(1)
        window.SetMultiSamples(0)
        window.SetSize(*(size or self.size))
        # The scene's own renderer may be in a window.
        renderer = vtkRenderer()
        renderer.SetBackground(self.renderer.GetBackground())
        renderer.SetActiveCamera(self.camera)
        for light in _items(self.renderer.GetLights()):
            renderer.AddLight(light)
        for prop in _items(self.renderer.GetViewProps()):
            if prop not in self.annotations and not prop.IsA("vtkWidgetRepresentation"):
                renderer.AddViewProp(prop)
        window.AddRenderer(renderer)
        renderer.ResetCameraClippingRange()
        window.Render()
        picture = grab(window)
        for prop in _items(renderer.GetViewProps()):
            prop.ReleaseGraphicsResources(window)
        renderer.RemoveAllViewProps()
        return picture

    # As a file

    def to_dict(self):
        """What is set, as what exabricks-render --stats writes of it. Lengths are those of the data.

        Of the mapper: reconstruction, steps, error tolerance, blend mode, levels, clipping planes, and cropping planes; of
        the property: colors, opacities, their unit distance, iso-values, the plane of a slice, and whether it is shaded, scatters light and casts shadows; lights are none of it.
        Their other settings are not kept.
        """
        camera = self.camera
        planes = _items(self.mapper.GetClippingPlanes())
        contours = self.volume_property.GetIsoSurfaceValues()
        mode = self.blend_mode
        return {
            "input": {"file": self.path, "array": self.array, "component": self.component, "log10": self.log,
                      "levels": self.levels},
            "picture": {
                "size": list(self.size),
                "camera": {
                    "position": list(camera.GetPosition()), "focal": list(camera.GetFocalPoint()),
                    "up": list(camera.GetViewUp()), "view_angle": camera.GetViewAngle(),
                    "parallel": bool(camera.GetParallelProjection()), "parallel_scale": camera.GetParallelScale()},
                "look": {
                    "color_map": self.color_map, "color_range": list(self.color_range), "colors": self._colors(),
                    "opacity": [list(point) for point in self.opacity],
                    "opacity_unit": self.volume_property.GetScalarOpacityUnitDistance(),
                    "background": list(self.renderer.GetBackground())}},
            "method": {
                "reconstruction": RECONSTRUCTIONS[self.mapper.GetReconstruction()],
                "step_scale": self.mapper.GetStepScale(), "error_tolerance": self.mapper.GetErrorTolerance()},
            "view": {
                "blend_mode": mode,
                "iso_values": [contours.GetValue(i) for i in range(contours.GetNumberOfContours())]
                              if mode == "isosurface" else [],
                "slice": dict(zip(("origin", "normal"), map(list, self.slice))) if mode == "slice" else None,
                "levels": list(self.mapper.GetLevelRange()),
                "clipping_planes": [{"origin": list(plane.GetOrigin()), "normal": list(plane.GetNormal())}
                                    for plane in planes],
                "cropping": list(self.mapper.GetCroppingRegionPlanes()) if self.mapper.GetCropping() else None,
                "shaded": bool(self.volume_property.GetShade()),
                "scattering": self.mapper.GetVolumetricScatteringBlending(),
                "shadow_reach": self.mapper.GetGlobalIlluminationReach()},
        }

    def _colors(self):
        """Of colors that are no named map: [value, red, green, blue] each, between which they are linear; else None."""
        if not self._preset:
            return None
        function = self.volume_property.GetRGBTransferFunction()
        low, high = function.GetRange()
        values = [low + i / 32.0 * (high - low) for i in range(33)]
        return [[value, *function.GetColor(value)] for value in values]

    def set_iso_values(self, values):
        """The values of iso-surfaces, of the array or its logarithm."""
        self.iso_values = [float(value) for value in values]
        contours = self.volume_property.GetIsoSurfaceValues()
        contours.SetNumberOfContours(len(self.iso_values))
        for number, value in enumerate(self.iso_values):
            contours.SetValue(number, value)

    @property
    def slice(self):
        """Origin and normal of the plane that blend mode slice shows; at first through the middle of what shows."""
        plane = self.volume_property.GetSliceFunction()
        if not isinstance(plane, vtkPlane):
            bounds = self.first.GetShownBounds()
            self.set_slice([0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)], (0.0, 0.0, 1.0))
            plane = self.volume_property.GetSliceFunction()
        return plane.GetOrigin(), plane.GetNormal()

    def set_slice(self, origin, normal):
        """The plane that blend mode slice shows."""
        plane = vtkPlane()
        plane.SetOrigin(origin)
        plane.SetNormal(normal)
        self.volume_property.SetSliceFunction(plane)

    def save(self, path):
        """Writes the scene, as JSON."""
        text = json.dumps(self.to_dict(), indent=2) + "\n"
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

    @classmethod
    def load(cls, path, source=None, *, array=None, component=None, levels=None, log=None):
        """Opens a scene that save() or exabricks-render --stats wrote.

        `source`: data in place of the file that it names. The others in place of what it says; where the values are not
        those of the scene, colors and opacities are chosen anew. Raises ValueError where the file is none.
        """
        with open(path, encoding="utf-8") as file:
            try:
                settings = json.load(file)
            except ValueError as error:
                raise ValueError(f"expected a scene in {os.fspath(path)!r}, found no JSON: {error}") from error
        if not isinstance(settings, dict) or not all(isinstance(settings.get(part), dict) for part in OF_THE_DATA):
            raise ValueError(f"expected a scene with {', '.join(OF_THE_DATA)} in {os.fspath(path)!r}, found "
                             + (", ".join(settings) if isinstance(settings, dict) else type(settings).__name__))
        try:
            what = settings["input"]
            if source is None and not what["file"]:
                raise ValueError(f"expected data to draw the scene {os.fspath(path)!r} of, found none: it names no file")
            kept = what["component"] if isinstance(what["component"], int) and array in (None, what["array"]) else None
            scene = cls(
                what["file"] if source is None else source, what["array"] if array is None else array,
                component=kept if component is None else component,
                levels=(what.get("levels") if levels is None else levels) if not isinstance(source, vtkOverlappingAMR)
                else None,
                log=bool(what["log10"]) if log is None else log, size=settings["picture"]["size"])
            same = (scene.array, scene.component, scene.log) == (what["array"], kept, bool(what["log10"]))
            scene.apply(settings, same)
            return scene
        except (KeyError, TypeError, IndexError) as error:
            raise ValueError(f"expected a whole scene in {os.fspath(path)!r}, found one without {error}") from error

    def apply(self, settings, with_values=True):
        """Sets what to_dict() gives, but for the data. `with_values`: also colors, opacities and iso-values."""
        picture = settings["picture"]
        camera = picture["camera"]
        self.camera.SetPosition(camera["position"])
        self.camera.SetFocalPoint(camera["focal"])
        self.camera.SetViewUp(camera["up"])
        self.camera.SetViewAngle(camera["view_angle"])
        self.camera.SetParallelProjection(camera["parallel"])
        self.camera.SetParallelScale(camera["parallel_scale"])
        look = picture["look"]
        view = settings.get("view", {})
        self.blend_mode = view.get("blend_mode", "composite")
        if with_values:
            self._apply_look(look)
        self.renderer.SetBackground(look["background"])
        method = settings["method"]
        self.mapper.SetReconstruction(RECONSTRUCTIONS.index(method["reconstruction"]))
        self.mapper.SetStepScale(method["step_scale"])
        self.mapper.SetErrorTolerance(method["error_tolerance"])
        if with_values:
            self.set_iso_values(view.get("iso_values", []))
        if view.get("slice"):
            self.set_slice(view["slice"]["origin"], view["slice"]["normal"])
        if "levels" in view:
            self.mapper.SetLevelRange(*view["levels"])
        self.mapper.RemoveAllClippingPlanes()
        for cut in view.get("clipping_planes", []):
            plane = vtkPlane()
            plane.SetOrigin(cut["origin"])
            plane.SetNormal(cut["normal"])
            self.mapper.AddClippingPlane(plane)
        self.mapper.SetCropping(bool(view.get("cropping")))
        if view.get("cropping"):
            self.mapper.SetCroppingRegionPlanes(*view["cropping"])
        self.volume_property.SetShade(bool(view.get("shaded")))
        self.mapper.SetVolumetricScatteringBlending(view.get("scattering", 0.0))
        self.mapper.SetGlobalIlluminationReach(view.get("shadow_reach", 0.0))
        self.renderer.ResetCameraClippingRange()

    def _apply_look(self, look):
        low, high = look["color_range"]
        if look.get("colors"):
            width = high - low or 1.0
            self._preset = ("RGB", [((value - low) / width, *color) for value, *color in look["colors"]])
            self.color_map = look["color_map"]
            self._spread_preset((low, high))
        else:
            colors = vtkColorTransferFunction()
            self._set_color_map(look["color_map"])
            vtkExaBricksFirstPicture.FillColorMap(self.color_map, (low, high), colors)
            self.volume_property.SetColor(colors)
        self.opacity = look["opacity"]
        self.volume_property.SetScalarOpacityUnitDistance(look["opacity_unit"])


def grab(window):
    """What a window shows, as a Picture."""
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.SetInputBufferTypeToRGB()
    image.ReadFrontBufferOff()
    image.ShouldRerenderOff()
    image.Update()
    return Picture(image.GetOutput())


def _items(collection):
    return [collection.GetItemAsObject(i) for i in range(collection.GetNumberOfItems())] if collection else []


def _choose_array(arrays, array, component):
    """The array, and of several components the one, or None for their magnitude."""
    if not arrays:
        raise ValueError("expected cell arrays, of which one is drawn, found none")
    if array is None:
        def preference(name):
            components, varies = arrays[name]
            return (components == 1, varies, vtkExaBricksFirstPicture.GetArrayPreference(name))

        array = max(arrays, key=preference)
    if array not in arrays:
        raise ValueError(f"expected an array of {', '.join(arrays)}, found {array!r}")
    components = arrays[array][0]
    if component is not None and not 0 <= component < components:
        raise ValueError(f"expected a component from 0 to {components - 1} of {array!r}, found {component!r}")
    return array, None if component is None else int(component)


def _varies(ranges):
    return any(high - low > 1e-6 * max(abs(low), abs(high)) for low, high in ranges if low <= high)
