# SPDX-License-Identifier: BSD-3-Clause
"""A simulation of its own blocks of an AMR on each rank, which hands them to ParaView Catalyst at each step.

    mpiexec -n 4 pvbatch --sym Examples/InSitu/simulation.py Examples/InSitu/catalyst_script.py 3

A shell that grows in a box of 64^3 cells, in blocks of 16^3; the blocks that it passes are refined. Rank r has every fourth
block of four ranks. Takes no file. What is drawn, and where pictures go, the script says.
"""

import itertools
import os
import sys

import numpy
from paraview.catalyst import bridge
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkAMRBox, vtkOverlappingAMR, vtkUniformGrid
from vtkmodules.vtkParallelCore import vtkMultiProcessController

BLOCK = 16  # cells along an axis
XYZ_GRID = 8  # VTK_XYZ_GRID, which has no name in Python
WIDTHS = (1.0 / 64, 1.0 / 128)  # of cells, by level


def density(x, y, z, time):
    distance = numpy.sqrt((x - 0.5) ** 2 + (y - 0.5) ** 2 + (z - 0.5) ** 2)
    return numpy.exp(-(((distance - 0.1 - 0.1 * time) / 0.03) ** 2)) * (1.2 + numpy.sin(25.0 * x) * numpy.sin(25.0 * y))


def values_of(level, corner, time):
    """Of the cells of a block, x fastest."""
    axes = [(corner[axis] + numpy.arange(BLOCK) + 0.5) * WIDTHS[level] for axis in range(3)]
    return density(axes[0][None, None, :], axes[1][None, :, None], axes[2][:, None, None], time).astype(numpy.float32)


def corners_at(time):
    """Of the blocks of each level: all of the coarse one, and eight where a coarse block has the shell."""
    coarse = [tuple(BLOCK * i for i in place) for place in itertools.product(range(4), repeat=3)]
    fine = [tuple(2 * corner[axis] + BLOCK * offset[axis] for axis in range(3))
            for corner in coarse if values_of(0, corner, time).max() > 0.1
            for offset in itertools.product(range(2), repeat=3)]
    return coarse, fine


def make_amr(time, rank, ranks):
    """All boxes, and the values of the rank's own blocks."""
    levels = corners_at(time)
    amr = vtkOverlappingAMR()
    counts = [len(corners) for corners in levels]
    if hasattr(amr, "GetOverlappingAMRMetaData"):  # VTK 9.6
        amr.Initialize(counts)
    else:
        amr.Initialize(len(levels), counts)
    amr.SetGridDescription(XYZ_GRID)
    amr.SetOrigin((0.0, 0.0, 0.0))
    for level, corners in enumerate(levels):
        amr.SetSpacing(level, (WIDTHS[level],) * 3)
        amr.SetRefinementRatio(level, 2)
        for number, corner in enumerate(corners):
            amr.SetAMRBox(level, number, vtkAMRBox(corner, [first + BLOCK - 1 for first in corner]))
            if number % ranks != rank:
                continue
            grid = vtkUniformGrid()
            grid.SetOrigin([first * WIDTHS[level] for first in corner])
            grid.SetSpacing((WIDTHS[level],) * 3)
            grid.SetDimensions((BLOCK + 1,) * 3)
            array = numpy_to_vtk(values_of(level, corner, time).ravel(), deep=True)
            array.SetName("density")
            grid.GetCellData().SetScalars(array)
            amr.SetDataSet(level, number, grid)
    return amr


def main(script, steps):
    controller = vtkMultiProcessController.GetGlobalController()
    rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
    bridge.initialize()
    bridge.add_pipeline(os.path.abspath(script), 2)
    for step in range(steps):
        bridge.coprocess(float(step), step, make_amr(float(step), rank, ranks), name="mesh")
    bridge.finalize()


if len(sys.argv) != 3:
    sys.exit("usage: simulation.py SCRIPT STEPS")
main(sys.argv[1], int(sys.argv[2]))
