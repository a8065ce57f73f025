# SPDX-License-Identifier: BSD-3-Clause
"""A volume of AMR with all that is set of it, and the same as a file: what show(), the viewer and exabricks-render share."""

import json
import os

from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
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
from .reading import list_arrays, read
from .vtkRenderingVolumeExaBricks import vtkExaBricksFirstPicture, vtkExaBricksVolumeMapper

RECONSTRUCTIONS = ("basis", "nearest", "completed")
BLEND_MODES = {
    "composite": vtkExaBricksVolumeMapper.COMPOSITE_BLEND,
    "maximum": vtkExaBricksVolumeMapper.MAXIMUM_INTENSITY_BLEND,
    "minimum": vtkExaBricksVolumeMapper.MINIMUM_INTENSITY_BLEND,
    "average": vtkExaBricksVolumeMapper.AVERAGE_INTENSITY_BLEND,
    "additive": vtkExaBricksVolumeMapper.ADDITIVE_BLEND,
    "isosurface": vtkExaBricksVolumeMapper.ISOSURFACE_BLEND,
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
    `levels`: how many are read, from the coarsest on. `log`: whether logarithms are drawn; None: where they show more.
    Raises ReadError where nothing can be read, and ValueError for arguments that do not fit.

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
        self.component = component
        self.levels = levels
        self.size = tuple(size)
        self.path = None
        self.color_map = color_map
        self._set_color_map(color_map)
        self.array = self._load(source, array)
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

    def _load(self, source, array):
        """Reads what is drawn, and returns the array's name."""
        if isinstance(source, vtkOverlappingAMR):
            self.arrays = _arrays_of(source)
        else:
            self.path = os.fspath(source)
            self.arrays = {
                name: (info.components, _varies(info.ranges)) for name, info in list_arrays(self.path).items()}
        chosen = self._choose_array(array)
        if self.path is None:
            self.amr = source
        else:
            fractions = [name for name in self.arrays if vtkExaBricksFirstPicture.IsVolumeFraction(name)]
            self.amr = read(self.path, self.levels, [chosen, *(name for name in fractions if name != chosen)])
        if not vtkExaBricksFirstPicture.IsVolumeFraction(chosen):
            vtkExaBricksFirstPicture.HideCoveredCells(self.amr)
        return chosen

    def _choose_array(self, array):
        if not self.arrays:
            raise ValueError("expected cell arrays, of which one is drawn, found none")
        if array is None:
            def preference(name):
                components, varies = self.arrays[name]
                return (components == 1, varies, vtkExaBricksFirstPicture.GetArrayPreference(name))

            array = max(self.arrays, key=preference)
        if array not in self.arrays:
            raise ValueError(f"expected an array of {', '.join(self.arrays)}, found {array!r}")
        components = self.arrays[array][0]
        if self.component is not None and not 0 <= self.component < components:
            raise ValueError(f"expected a component from 0 to {components - 1} of {array!r}, found {self.component!r}")
        return array

    def set_array(self, array, log=None):
        """Draws another array of the file or data, with colors and opacities chosen anew. The camera stays."""
        self.component = None
        self.array = self._load(self.path if self.path is not None else self.amr, array)
        self._draw_array(log)

    def set_source(self, path):
        """Draws another file with the same array, colors, opacities and camera: another time step."""
        log = self.log
        self.path = os.fspath(path)
        self.array = self._load(self.path, self.array)
        self._select(log)
        self.mapper.Update()

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
        data = self.data
        if data.GetNumberOfLeafCells() <= data.GetNumberOfAbsentCells() or not self.first.Choose(data):
            raise ValueError(f"expected cells with values of {self.array!r}, found none"
                             + (" above zero: draw it without logarithms" if self.log else ""))
        self.first.InitializeProperty(self.volume_property)

    def set_color_map(self, name):
        """Spreads another color map over the range that the colors have."""
        self._set_color_map(name)
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
        colors = self.volume_property.GetRGBTransferFunction()
        low, high = self.color_range
        begin, end = points[0], points[-4]
        colors.RemoveAllPoints()
        spaces = {"RGB": colors.SetColorSpaceToRGB, "Lab": colors.SetColorSpaceToLab, "HSV": colors.SetColorSpaceToHSV,
                  "Diverging": colors.SetColorSpaceToDiverging}
        spaces.get(found[0].get("ColorSpace", "RGB"), colors.SetColorSpaceToRGB)()
        for i in range(0, len(points), 4):
            part = (points[i] - begin) / (end - begin) if end > begin else 0.0
            colors.AddRGBPoint(low + part * (high - low), *points[i + 1:i + 4])
        self.color_map = found[0].get("Name", os.fspath(path))

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
        """Draws off screen, and returns a Picture. `size`: width and height in pixels."""
        ensure_drawing()
        window = vtkRenderWindow()
        window.SetOffScreenRendering(1)
        window.SetMultiSamples(0)
        window.SetSize(*(size or self.size))
        window.AddRenderer(self.renderer)
        try:
            self.renderer.ResetCameraClippingRange()
            window.Render()
            return grab(window)
        finally:
            window.RemoveRenderer(self.renderer)
            self.volume.ReleaseGraphicsResources(window)

    # As a file

    def to_dict(self):
        """What is set, as what exabricks-render --stats writes of it. Lengths are those of the data."""
        camera = self.camera
        planes = self.mapper.GetClippingPlanes()
        planes = [planes.GetItem(i) for i in range(planes.GetNumberOfItems())] if planes else []
        return {
            "input": {"file": self.path, "array": self.array, "component": self.component, "log10": self.log},
            "picture": {
                "size": list(self.size),
                "camera": {
                    "position": list(camera.GetPosition()), "focal": list(camera.GetFocalPoint()),
                    "up": list(camera.GetViewUp()), "view_angle": camera.GetViewAngle(),
                    "parallel": bool(camera.GetParallelProjection()), "parallel_scale": camera.GetParallelScale()},
                "look": {
                    "color_map": self.color_map, "color_range": list(self.color_range),
                    "opacity": [list(point) for point in self.opacity],
                    "opacity_unit": self.volume_property.GetScalarOpacityUnitDistance(),
                    "background": list(self.renderer.GetBackground())}},
            "method": {
                "reconstruction": RECONSTRUCTIONS[self.mapper.GetReconstruction()],
                "step_scale": self.mapper.GetStepScale(), "error_tolerance": self.mapper.GetErrorTolerance()},
            "view": {
                "blend_mode": next(name for name, mode in BLEND_MODES.items() if mode == self.mapper.GetBlendMode()),
                "iso_values": [self.volume_property.GetIsoSurfaceValues().GetValue(i)
                               for i in range(self.volume_property.GetIsoSurfaceValues().GetNumberOfContours())],
                "levels": list(self.mapper.GetLevelRange()),
                "clipping_planes": [{"origin": list(plane.GetOrigin()), "normal": list(plane.GetNormal())}
                                    for plane in planes],
                "cropping": list(self.mapper.GetCroppingRegionPlanes()) if self.mapper.GetCropping() else None,
                "shaded": bool(self.volume_property.GetShade())},
        }

    def save(self, path):
        """Writes the scene, as JSON."""
        with open(path, "w", encoding="utf-8") as file:
            json.dump(self.to_dict(), file, indent=2)
            file.write("\n")

    @classmethod
    def load(cls, path, source=None):
        """Opens a scene that save() or exabricks-render --stats wrote. `source`: data in place of the file it names.

        Raises ValueError where the file is none.
        """
        with open(path, encoding="utf-8") as file:
            try:
                settings = json.load(file)
            except ValueError as error:
                raise ValueError(f"expected a scene in {os.fspath(path)!r}, found no JSON: {error}") from error
        if not isinstance(settings, dict) or not all(isinstance(settings.get(part), dict) for part in OF_THE_DATA):
            raise ValueError(f"expected a scene with {', '.join(OF_THE_DATA)} in {os.fspath(path)!r}, found "
                             + (", ".join(settings) if isinstance(settings, dict) else type(settings).__name__))
        what = settings["input"]
        component = what.get("component")
        scene = cls(what.get("file") if source is None else source, what.get("array"),
                    component=component if isinstance(component, int) else None, log=bool(what.get("log10")),
                    size=settings["picture"].get("size", (800, 600)))
        scene.apply(settings)
        return scene

    def apply(self, settings):
        """Sets what to_dict() gives, but for the data."""
        picture = settings["picture"]
        camera = picture["camera"]
        self.camera.SetPosition(camera["position"])
        self.camera.SetFocalPoint(camera["focal"])
        self.camera.SetViewUp(camera["up"])
        self.camera.SetViewAngle(camera["view_angle"])
        self.camera.SetParallelProjection(camera["parallel"])
        self.camera.SetParallelScale(camera["parallel_scale"])
        look = picture["look"]
        colors = vtkColorTransferFunction()
        if look["color_map"] in color_map_names():
            self._set_color_map(look["color_map"])
        vtkExaBricksFirstPicture.FillColorMap(self.color_map, look["color_range"], colors)
        self.volume_property.SetColor(colors)
        self.opacity = look["opacity"]
        self.volume_property.SetScalarOpacityUnitDistance(look["opacity_unit"])
        self.renderer.SetBackground(look["background"])
        method = settings["method"]
        self.mapper.SetReconstruction(RECONSTRUCTIONS.index(method["reconstruction"]))
        self.mapper.SetStepScale(method["step_scale"])
        self.mapper.SetErrorTolerance(method["error_tolerance"])
        view = settings.get("view", {})
        self.mapper.SetBlendMode(BLEND_MODES[view.get("blend_mode", "composite")])
        values = view.get("iso_values", [])
        contours = self.volume_property.GetIsoSurfaceValues()
        contours.SetNumberOfContours(len(values))
        for number, value in enumerate(values):
            contours.SetValue(number, value)
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
        self.renderer.ResetCameraClippingRange()


def grab(window):
    """What a window shows, as a Picture."""
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.SetInputBufferTypeToRGB()
    image.ReadFrontBufferOff()
    image.ShouldRerenderOff()
    image.Update()
    return Picture(image.GetOutput())


def _varies(ranges):
    return any(high - low > 1e-6 * max(abs(low), abs(high)) for low, high in ranges if low <= high)


def _arrays_of(amr):
    """Cell arrays of the first block that is there: how many components each has, and whether it varies in any block."""
    found = {}
    blocks = amr.NewIterator()
    blocks.InitTraversal()
    first = True
    while not blocks.IsDoneWithTraversal():
        cells = blocks.GetCurrentDataObject().GetCellData()
        for i in range(cells.GetNumberOfArrays()):
            array = cells.GetArray(i)
            if array is None or isinstance(array, vtkUnsignedCharArray) and array.GetName() == "vtkGhostType":
                continue
            components = array.GetNumberOfComponents()
            ranges = [array.GetFiniteRange(k) for k in range(components)]
            if first or array.GetName() in found:
                known = found.get(array.GetName(), (components, []))[1]
                found[array.GetName()] = (components, known + ranges)
        first = False
        blocks.GoToNextItem()
    result = {}
    for name, (components, ranges) in found.items():
        lows, highs = zip(*ranges)
        result[name] = (components, _varies([(min(lows), max(highs))]))
    return result
