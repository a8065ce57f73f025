# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of Documentation/Gallery.md, into the folder of this script or the one that is named:

    PYTHONPATH=$(echo build/lib/python3.*/dist-packages) xvfb-run -a /usr/bin/python3 Documentation/Gallery/pictures.py

Each function is one picture: what it sets is all that differs from a plain volume.
"""

import pathlib
import sys

from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction, vtkPlane
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUniformGridAMRReader
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkVolume,
    vtkWindowToImageFilter,
)
from vtkmodules.vtkFiltersSources import vtkSphereSource

import exabricks

HERE = pathlib.Path(__file__).resolve().parent
DATA = HERE.parent.parent / "Testing" / "Data" / "rt_medium" / "rt_medium.vthb"
MIDDLE = (0.25, 0.25, 0.4)


class Scene:
    """The Rayleigh-Taylor data: rings of vorticity around a mushroom of dense fluid."""

    def __init__(self, array="magvort"):
        self.reader = vtkXMLUniformGridAMRReader()
        self.reader.SetFileName(str(DATA))
        self.reader.SetMaximumLevelsToReadByDefault(0)  # all
        self.mapper = exabricks.vtkExaBricksVolumeMapper()
        self.mapper.SetInputConnection(self.reader.GetOutputPort())
        self.mapper.SetScalarModeToUseCellFieldData()
        self.mapper.SelectScalarArray(array)
        self.mapper.SetReconstructionToCompleted()
        self.mapper.SetErrorTolerance(0.004)
        self.volume = vtkVolume()
        self.volume.SetMapper(self.mapper)
        self.property = self.volume.GetProperty()
        self.property.SetScalarOpacityUnitDistance(0.02)
        if array == "magvort":
            self.colors([(0.5, 0.1, 0.2, 0.8), (6.0, 1.0, 0.9, 0.6), (18.0, 1.0, 0.2, 0.1)])
            self.opacity([(0.5, 0.0), (3.0, 0.1), (10.0, 0.5)])
        else:
            self.colors([(1.0, 0.1, 0.3, 0.9), (1.5, 0.9, 0.9, 0.8), (2.0, 0.9, 0.5, 0.1)])
            self.opacity([(1.05, 0.0), (1.3, 0.25), (1.7, 0.25), (1.95, 0.0)])
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(1.0, 1.0, 1.0)
        self.renderer.AddVolume(self.volume)
        camera = self.renderer.GetActiveCamera()
        camera.SetFocalPoint(*MIDDLE)
        camera.SetPosition(0.8, -1.2, 1.0)
        camera.SetViewUp(0.0, 0.0, 1.0)

    def colors(self, nodes):
        function = vtkColorTransferFunction()
        for node in nodes:
            function.AddRGBPoint(*node)
        self.property.SetColor(function)

    def opacity(self, nodes):
        function = vtkPiecewiseFunction()
        for node in nodes:
            function.AddPoint(*node)
        self.property.SetScalarOpacity(function)

    def material(self, ambient, diffuse, specular, power):
        self.property.ShadeOn()
        self.property.SetAmbient(ambient)
        self.property.SetDiffuse(diffuse)
        self.property.SetSpecular(specular)
        self.property.SetSpecularPower(power)


def composite():
    return Scene()


def shaded():
    scene = Scene()
    scene.material(0.3, 0.8, 0.3, 20.0)
    scene.opacity([(2.0, 0.0), (5.0, 0.3), (10.0, 0.9)])
    return scene


def shadows():
    scene = Scene()
    scene.mapper.SetVolumetricScatteringBlending(2.0)
    scene.mapper.SetGlobalIlluminationReach(1.0)
    scene.material(0.35, 0.9, 0.0, 10.0)
    scene.opacity([(0.5, 0.0), (3.0, 0.1), (10.0, 0.6)])
    sun = vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetPosition(3.0, -0.5, 2.0)
    sun.SetFocalPoint(*MIDDLE)
    scene.renderer.AddLight(sun)
    return scene


def gradient_opacity():
    scene = Scene("density")
    scene.opacity([(1.0, 0.6), (2.0, 0.6)])
    function = vtkPiecewiseFunction()
    for gradient, opacity in ((0.0, 0.0), (0.02, 0.0), (0.1, 1.0)):
        function.AddPoint(gradient, opacity)
    scene.property.SetGradientOpacity(function)
    scene.material(0.3, 0.8, 0.1, 10.0)
    return scene


def maximum():
    scene = Scene()
    scene.mapper.SetBlendModeToMaximumIntensity()
    scene.opacity([(0.0, 0.0), (15.0, 1.0)])
    return scene


def average():
    scene = Scene("density")
    scene.mapper.SetBlendModeToAverageIntensity()
    scene.opacity([(1.0, 1.0)])
    return scene


def additive():
    scene = Scene()
    scene.mapper.SetBlendModeToAdditive()
    scene.opacity([(0.0, 1.0)])
    scene.property.SetScalarOpacityUnitDistance(0.15)
    return scene


def isosurfaces():
    scene = Scene("density")
    scene.mapper.SetBlendModeToIsoSurface()
    for number, value in enumerate((1.2, 1.5, 1.8)):
        scene.property.GetIsoSurfaceValues().SetValue(number, value)
    scene.opacity([(1.2, 0.35), (1.5, 0.35), (1.8, 1.0)])
    scene.material(0.2, 0.8, 0.3, 30.0)
    return scene


def slice_plane():
    scene = Scene()
    plane = vtkPlane()
    plane.SetOrigin(*MIDDLE)
    plane.SetNormal(0.4, -1.0, 0.3)
    scene.mapper.SetBlendModeToSlice()
    scene.property.SetSliceFunction(plane)
    scene.opacity([(0.0, 1.0)])
    return scene


def clipped():
    scene = Scene()
    for normal in ((-1.0, 1.0, 0.0), (0.3, 0.0, -1.0)):
        plane = vtkPlane()
        plane.SetOrigin(0.25, 0.25, 0.55)
        plane.SetNormal(*normal)
        scene.mapper.AddClippingPlane(plane)
    return scene


def cropped():
    scene = shaded()
    scene.mapper.CroppingOn()
    scene.mapper.SetCroppingRegionPlanes(0.25, 1.0, -1.0, 0.25, 0.42, 2.0)
    scene.mapper.SetCroppingRegionFlags(0x7FFFFFF & ~(1 << 1 + 3 * 1 + 9 * 1))
    return scene


def two_components():
    scene = Scene()
    # The array "both" has the two others as its components.
    scene.reader.Update()
    amr = scene.reader.GetOutputDataObject(0)
    for level in range(amr.GetNumberOfLevels()):
        for index in range(amr.GetNumberOfDataSets(level)):
            cells = amr.GetDataSet(level, index).GetCellData()
            both = vtkFloatArray()
            both.SetName("both")
            both.SetNumberOfComponents(2)
            both.SetNumberOfTuples(cells.GetNumberOfTuples())
            both.CopyComponent(0, cells.GetArray("magvort"), 0)
            both.CopyComponent(1, cells.GetArray("density"), 0)
            cells.AddArray(both)
    scene.mapper.SetInputData(amr)
    scene.mapper.SelectScalarArray("both")
    scene.mapper.SetErrorTolerance(0.0)
    blue = vtkColorTransferFunction()
    blue.AddRGBPoint(1.0, 0.2, 0.5, 0.9)
    layer = vtkPiecewiseFunction()
    for density, opacity in ((1.4, 0.0), (1.5, 0.3), (1.6, 0.0)):
        layer.AddPoint(density, opacity)
    scene.property.SetColor(1, blue)
    scene.property.SetScalarOpacity(1, layer)
    scene.property.SetScalarOpacityUnitDistance(1, 0.02)
    return scene


def with_geometry():
    scene = Scene()
    for x, opacity in ((0.12, 1.0), (0.38, 0.4)):
        ball = vtkSphereSource()
        ball.SetCenter(x, 0.12, 0.5)
        ball.SetRadius(0.08)
        ball.SetThetaResolution(48)
        ball.SetPhiResolution(32)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(ball.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(0.2, 0.7, 0.3)
        actor.GetProperty().SetOpacity(opacity)
        scene.renderer.AddActor(actor)
    scene.renderer.SetUseDepthPeeling(True)
    scene.renderer.SetUseDepthPeelingForVolumes(True)
    return scene


PICTURES = (composite, shaded, gradient_opacity, maximum, average, additive, isosurfaces, slice_plane, clipped,
            cropped, two_components, with_geometry, shadows)


def draw(scene, path, size=280):
    window = vtkRenderWindow()
    window.SetMultiSamples(0)
    window.SetAlphaBitPlanes(True)
    window.SetSize(size, size)
    window.AddRenderer(scene.renderer)
    scene.renderer.ResetCamera(0.0, 0.5, 0.0, 0.5, 0.28, 0.56)
    scene.renderer.GetActiveCamera().Zoom(1.35)
    scene.renderer.ResetCameraClippingRange()
    window.Render()
    assert scene.mapper.GetDrawn(), path
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else HERE
    folder.mkdir(parents=True, exist_ok=True)
    for picture in PICTURES:
        draw(picture(), folder / f"{picture.__name__}.png")
        print(picture.__name__)
