# SPDX-License-Identifier: BSD-3-Clause
"""What each thing that can be set costs, in ours and in VTK's mappers of a resampled grid: writes features.csv.

    PYTHONPATH=<folder of exabricks> /usr/bin/python3 FeatureCosts.py <folder of results> [<pixels> [<grid cells> [<rounds>]]]

The shipped Rayleigh-Taylor data. All methods draw in turn, in windows of their own; medians of the rounds, after one that
does not count. The camera turns by half a degree from one round to the next and back, so that what is chosen for a view is
chosen anew. Errors are those of the pixels drawn in either picture, 8 bits a channel, beside ours with a tenth of the
step, which the tests hold against brute force.
"""

import csv
import math
import pathlib
import statistics
import sys
import time

try:
    import numpy
except ImportError:
    print("takes numpy (Debian: python3-numpy)")
    sys.exit(125)
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction, vtkPlane
from vtkmodules.vtkFiltersCore import vtkResampleToImage
from vtkmodules.vtkIOXML import vtkXMLUniformGridAMRReader
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction,
    vtkRenderer,
    vtkRenderWindow,
    vtkVolume,
    vtkVolumeProperty,
)
from vtkmodules.vtkRenderingVolume import vtkFixedPointVolumeRayCastMapper, vtkGPUVolumeRayCastMapper

import exabricks

DATA = pathlib.Path(__file__).resolve().parent.parent / "Data" / "rt_medium" / "rt_medium.vthb"
STEPS = (4.0, 2.0, 1.0, 0.5)
TOLERANCES = (0.1, 0.05, 0.02, 0.01, 0.005, 0.002)
REFERENCE = 0.1
FINEST = 1.0 / 192.0  # spacing


def read():
    reader = vtkXMLUniformGridAMRReader()
    reader.SetFileName(str(DATA))
    reader.SetMaximumLevelsToReadByDefault(0)  # all
    reader.Update()
    amr = reader.GetOutputDataObject(0)
    for level in range(amr.GetNumberOfLevels()):
        for index in range(amr.GetNumberOfDataSets(level)):
            cells = amr.GetDataSet(level, index).GetCellData()
            four = vtkFloatArray()
            four.SetName("four")
            four.SetNumberOfComponents(4)
            four.SetNumberOfTuples(cells.GetNumberOfTuples())
            for component in range(4):
                four.CopyComponent(component, cells.GetArray(("magvort", "density")[component % 2]), 0)
            cells.AddArray(four)
    return amr


def resample(amr, cells):
    """The cells' arrays on a grid of as many cells along each axis, as points in their middles."""
    sample = vtkResampleToImage()
    sample.SetInputDataObject(amr)
    sample.UseInputBoundsOff()
    size = (0.5, 0.5, 1.0)
    half = [0.5 * extent / cells for extent in size]
    sample.SetSamplingBounds(*(edge for extent, h in zip(size, half) for edge in (h, extent - h)))
    sample.SetSamplingDimensions(cells, cells, cells)
    sample.Update()
    return sample.GetOutput()


def function(nodes):
    opacity = vtkPiecewiseFunction()
    for node in nodes:
        opacity.AddPoint(*node)
    return opacity


def make_property():
    result = vtkVolumeProperty()
    result.SetInterpolationTypeToLinear()
    for component in range(4):
        vorticity = component % 2 == 0
        colors = vtkColorTransferFunction()
        nodes = ((0.5, 0.1, 0.2, 0.8), (6.0, 1.0, 0.9, 0.6), (18.0, 1.0, 0.2, 0.1)) if vorticity else \
            ((1.0, 0.1, 0.3, 0.9), (2.0, 0.9, 0.5, 0.1))
        for node in nodes:
            colors.AddRGBPoint(*node)
        result.SetColor(component, colors)
        result.SetScalarOpacity(component, function(
            ((0.5, 0.0), (3.0, 0.1), (10.0, 0.5)) if vorticity else ((1.4, 0.0), (1.5, 0.3), (1.6, 0.0))))
        result.SetScalarOpacityUnitDistance(component, 0.02)
    return result


# What is set beside the plain volume: of the property, of the mapper, and the array that is drawn.

def plain(_, mapper):
    mapper.SetBlendModeToComposite()


def shaded(properties, mapper):
    properties.ShadeOn()
    properties.SetAmbient(0.3)
    properties.SetDiffuse(0.8)
    properties.SetSpecular(0.0)


def gradient_opacity(properties, mapper):
    properties.SetGradientOpacity(function(((0.0, 0.0), (0.5, 1.0))))


def maximum(properties, mapper):
    mapper.SetBlendModeToMaximumIntensity()
    properties.SetScalarOpacity(function(((0.0, 0.0), (15.0, 1.0))))


def additive(properties, mapper):
    mapper.SetBlendModeToAdditive()
    properties.SetScalarOpacity(function(((0.0, 1.0),)))
    properties.SetScalarOpacityUnitDistance(0.15)


def isosurface(properties, mapper):
    mapper.SetBlendModeToIsoSurface()
    properties.GetIsoSurfaceValues().SetValue(0, 3.0)
    properties.GetIsoSurfaceValues().SetValue(1, 8.0)
    properties.SetScalarOpacity(function(((3.0, 0.4), (8.0, 1.0))))
    shaded(properties, mapper)


def slice_plane(properties, mapper):
    plane = vtkPlane()
    plane.SetOrigin(0.25, 0.25, 0.4)
    plane.SetNormal(0.4, -1.0, 0.3)
    mapper.SetBlendModeToSlice()
    properties.SetSliceFunction(plane)
    properties.SetScalarOpacity(function(((0.0, 1.0),)))


def clipped(_, mapper):
    plane = vtkPlane()
    plane.SetOrigin(0.25, 0.25, 0.4)
    plane.SetNormal(-1.0, 1.0, 0.2)
    mapper.AddClippingPlane(plane)


def cropped(_, mapper):
    mapper.CroppingOn()
    mapper.SetCroppingRegionPlanes(0.25, 1.0, -1.0, 0.25, 0.42, 2.0)
    mapper.SetCroppingRegionFlags(0x7FFFFFF & ~(1 << 1 + 3 * 1 + 9 * 1))


def four_components(_, mapper):
    pass


FEATURES = (plain, shaded, gradient_opacity, maximum, additive, isosurface, slice_plane, clipped, cropped, four_components)
# What the fixed-point mapper has.
FIXED_POINT = (plain, shaded, gradient_opacity, maximum, clipped, cropped, four_components)


class Method:
    """A mapper in a window of its own."""

    def __init__(self, name, feature, mapper, value, pixels):
        self.name, self.value, self.mapper = name, value, mapper
        properties = make_property()
        feature(properties, mapper)
        self.volume = vtkVolume()
        self.volume.SetMapper(mapper)
        self.volume.SetProperty(properties)
        renderer = vtkRenderer()
        renderer.AddVolume(self.volume)
        camera = renderer.GetActiveCamera()
        camera.SetFocalPoint(0.25, 0.25, 0.4)
        camera.SetPosition(0.8, -1.2, 1.0)
        camera.SetViewUp(0.0, 0.0, 1.0)
        self.window = vtkRenderWindow()
        self.window.SetMultiSamples(0)
        self.window.SetSize(pixels, pixels)
        self.window.SetDesiredUpdateRate(0.0001)
        self.window.AddRenderer(renderer)
        renderer.ResetCamera(0.0, 0.5, 0.0, 0.5, 0.28, 0.56)
        camera.Zoom(1.35)
        renderer.ResetCameraClippingRange()
        self.camera, self.turns = camera, 0.5  # degrees
        self.wall, self.cpu = [], []

    def draw(self):
        self.turns = -self.turns
        self.camera.Azimuth(self.turns)
        wall, cpu = time.perf_counter(), time.process_time()
        self.window.Render()
        self.wall.append(1e3 * (time.perf_counter() - wall))
        self.cpu.append(1e3 * (time.process_time() - cpu))

    def picture(self):
        if self.turns < 0.0:
            self.draw()
        width, height = self.window.GetSize()
        pixels = vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, width - 1, height - 1, 0, pixels, 0)
        return vtk_to_numpy(pixels).reshape(height, width, -1)[..., :3].astype(float) / 255.0


def make_ours(amr, feature, step, pixels, tolerance=0.0):
    mapper = exabricks.vtkExaBricksVolumeMapper()
    mapper.SetInputDataObject(amr)
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectScalarArray("four" if feature is four_components else "magvort")
    mapper.SetReconstructionToBasis()
    mapper.SetStepScale(step)
    mapper.SetErrorTolerance(tolerance)
    if tolerance > 0.0:
        return Method("vtkExaBricksVolumeMapper, by tolerance", feature, mapper, tolerance, pixels)
    return Method("vtkExaBricksVolumeMapper", feature, mapper, step, pixels)


def make_peer(image, kind, feature, cells, pixels):
    grid = vtkImageData()
    grid.CopyStructure(image)
    grid.GetPointData().SetScalars(
        image.GetPointData().GetArray("four" if feature is four_components else "magvort"))
    mapper = kind()
    mapper.SetInputData(grid)
    mapper.AutoAdjustSampleDistancesOff()
    mapper.SetSampleDistance(FINEST)
    if kind is vtkGPUVolumeRayCastMapper:
        mapper.UseJitteringOff()
        name = "vtkGPUVolumeRayCastMapper"
    else:
        if kind is vtkFixedPointVolumeRayCastMapper:
            mapper.SetImageSampleDistance(1.0)
        name = kind.__name__
    return Method(f"resampled, {name}", feature, mapper, cells, pixels)


def decibels(picture, truth):
    drawn = (picture.max(axis=-1) > 0.0) | (truth.max(axis=-1) > 0.0)
    error = float(numpy.mean((picture - truth)[drawn] ** 2)) if drawn.any() else 0.0
    return math.inf if error == 0.0 else -10.0 * math.log10(error)


def write_csv(path, lines):
    """Of lines with the same keys, which head the columns."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, lines[0].keys())
        writer.writeheader()
        writer.writerows(lines)


def main(folder, pixels=512, cells=128, rounds=5):
    amr = read()
    image = resample(amr, cells)
    lines = []
    for feature in FEATURES:
        truth = make_ours(amr, feature, REFERENCE, pixels)
        truth.draw()
        truth = truth.picture()  # of the view that all have at last
        methods = [make_ours(amr, feature, step, pixels) for step in STEPS]
        methods += [make_ours(amr, feature, 1.0, pixels, tolerance) for tolerance in TOLERANCES]
        methods.append(make_peer(image, vtkGPUVolumeRayCastMapper, feature, cells, pixels))
        if feature in FIXED_POINT:
            methods.append(make_peer(image, vtkFixedPointVolumeRayCastMapper, feature, cells, pixels))
        for _ in range(rounds + 1):
            for method in methods:
                method.draw()
        for method in methods:
            lines.append({
                "feature": feature.__name__.replace("_", " "), "method": method.name, "value": method.value,
                "wall_ms": round(statistics.median(method.wall[1:rounds + 1]), 3),
                "cpu_ms": round(statistics.median(method.cpu[1:rounds + 1]), 3),
                "db": round(decibels(method.picture(), truth), 3)})
            print(*lines[-1].values(), sep=", ", flush=True)
    write_csv(pathlib.Path(folder) / "features.csv", lines)


if __name__ == "__main__":
    main(sys.argv[1], *map(int, sys.argv[2:]))
