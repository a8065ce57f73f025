# SPDX-License-Identifier: BSD-3-Clause
"""Draws an array of a .vthb file on several processes, each of which reads and draws a part of it.

    mpiexec -n 4 python3 draw_on_ranks.py Testing/Data/rt_medium/rt_medium.vthb magvort picture.png
"""
import sys

import exabricks
import numpy
from mpi4py import MPI
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUniformGridAMRReader
from vtkmodules.vtkParallelCore import vtkMultiProcessController
from vtkmodules.vtkParallelMPI import vtkMPIController
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkVolume

if len(sys.argv) != 4:
    sys.exit("usage: draw_on_ranks.py FILE.vthb ARRAY PICTURE.png")
world = MPI.COMM_WORLD
controller = vtkMPIController()
controller.Initialize()
vtkMultiProcessController.SetGlobalController(controller)

# Some of the blocks on each process: whichever a reader deals them.
reader = vtkXMLUniformGridAMRReader()
reader.SetFileName(sys.argv[1])
reader.SetMaximumLevelsToReadByDefault(0)  # all of them
reader.UpdatePiece(world.rank, world.size, 0)

# Each process gets a box of its own, with the cells around it that count for what is seen in it.
redistribute = exabricks.vtkExaBricksRedistribute()
redistribute.SetInputDataObject(reader.GetOutputDataObject(0))
redistribute.Update()

mapper = exabricks.vtkExaBricksVolumeMapper()
mapper.SetInputDataObject(redistribute.GetOutputDataObject(0))
mapper.SetScalarModeToUseCellFieldData()
mapper.SelectScalarArray(sys.argv[2])
mapper.Update()
data = mapper.GetBuilder().GetOutput()
scalar_range = [0.0, 0.0]
data.GetScalarRange(scalar_range)  # of the array on all processes
least, greatest = scalar_range

volume = vtkVolume()
volume.SetMapper(mapper)
colors = vtkColorTransferFunction()
colors.AddRGBPoint(least, 0.2, 0.3, 0.8)
colors.AddRGBPoint(greatest, 1.0, 0.8, 0.3)
volume.GetProperty().SetColor(colors)
opacity = volume.GetProperty().GetScalarOpacity()
opacity.RemoveAllPoints()
opacity.AddPoint(least + 0.1 * (greatest - least), 0.0)
opacity.AddPoint(greatest, 0.2)
volume.GetProperty().SetInterpolationTypeToLinear()
spacing = [0.0, 0.0, 0.0]
data.GetFinestSpacing(spacing)
volume.GetProperty().SetScalarOpacityUnitDistance(2.0 * spacing[0])

# The same camera on all: it looks at all parts.
bounds = numpy.full(6, numpy.nan)
for process in range(world.size):
    part = [0.0] * 6
    redistribute.GetPartBounds(process, part)
    if part[0] <= part[1]:
        bounds[0::2] = numpy.fmin(bounds[0::2], part[0::2])
        bounds[1::2] = numpy.fmax(bounds[1::2], part[1::2])
if world.size == 1:
    bounds[:] = mapper.GetBounds()
renderer = vtkRenderer()
renderer.AddVolume(volume)
window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetSize(400, 400)
window.AddRenderer(renderer)
renderer.GetActiveCamera().Azimuth(30.0)
renderer.GetActiveCamera().Elevation(20.0)
renderer.ResetCamera(bounds)

# Each process's picture, and all of them one over the other, those in front first.
mapper.RenderToImageOn()
window.Render()
image = vtkImageData()
mapper.GetColorImage(image)
own = vtk_to_numpy(image.GetPointData().GetScalars()) / 255.0
own[own[:, 3] == 0.0] = 0.0  # white beyond the part
pictures = world.gather(own)
if world.rank == 0:
    order = vtkIdList()
    redistribute.GetFrontToBack(renderer.GetActiveCamera(), None, order)
    whole = numpy.zeros_like(own)
    for place in range(order.GetNumberOfIds()):
        whole += (1.0 - whole[:, 3:]) * pictures[order.GetId(place)]
    pixels = numpy.ascontiguousarray(numpy.rint(255.0 * whole[:, :3]).astype(numpy.uint8))
    picture = vtkImageData()
    picture.SetDimensions(400, 400, 1)
    picture.GetPointData().SetScalars(numpy_to_vtk(pixels))
    writer = vtkPNGWriter()
    writer.SetFileName(sys.argv[3])
    writer.SetInputData(picture)
    writer.Write()
controller.Finalize(1)
