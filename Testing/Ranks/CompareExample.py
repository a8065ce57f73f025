# SPDX-License-Identifier: BSD-3-Clause
"""The example's picture of four processes is that of one."""
import os
import subprocess
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

try:
    import mpi4py
    from vtkmodules.vtkParallelMPI import vtkMPIController
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(125)

mpiexec, example, data = sys.argv[1:]


def draw(processes):
    picture = os.path.abspath(f"processes{processes}.png")
    command = [mpiexec, "-n", str(processes), sys.executable, example, data, "magvort", picture]
    subprocess.run(command, check=True)
    reader = vtkPNGReader()
    reader.SetFileName(picture)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)


one, four = draw(1), draw(4)
drawn = numpy.maximum(one, four).max(axis=1) > 5
most = numpy.abs(one - four).max()
print(f"drawn {drawn.mean():.3f}, most {most} of 255")
assert drawn.mean() > 0.05
assert most <= 2, most
