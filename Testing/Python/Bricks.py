# SPDX-License-Identifier: BSD-3-Clause
"""What the mapper makes of AMR, in numbers."""

import gc

import exabricks


def bricks_of(amr, name=None):
    """What the mapper makes of an array, or of the active scalars."""
    gc.collect()  # whatever else held on to the memory is gone
    mapper = exabricks.vtkExaBricksVolumeMapper()
    mapper.SetInputData(amr)
    if name:
        mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectScalarArray(name)
    mapper.Update()
    return mapper.GetBuilder().GetOutput()


def range_of(data):
    value_range = [0.0, 0.0]
    data.GetScalarRange(value_range)
    return value_range


def bounds_of(data):
    bounds = [0.0] * 6
    data.GetBounds(bounds)
    return bounds
