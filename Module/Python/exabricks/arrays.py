# SPDX-License-Identifier: BSD-3-Clause
"""Overlapping AMR of numpy arrays, for data that come from no file that VTK reads."""

from __future__ import annotations

import math
import operator
from typing import TYPE_CHECKING, Any, Dict, Iterable, List, Mapping, NamedTuple, Sequence, Tuple, Union

from vtkmodules import vtkCommonCore
from vtkmodules.vtkCommonDataModel import vtkAMRBox, vtkOverlappingAMR, vtkUniformGrid

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

Values = Union["ArrayLike", Mapping[str, "ArrayLike"]]
Block = Tuple[int, Sequence[int], Values]

# What VTK stores as it is, by numpy's names of kind and size.
_VTK_TYPES = {
    "f4": vtkCommonCore.VTK_TYPE_FLOAT32,
    "f8": vtkCommonCore.VTK_TYPE_FLOAT64,
    "i1": vtkCommonCore.VTK_TYPE_INT8,
    "i2": vtkCommonCore.VTK_TYPE_INT16,
    "i4": vtkCommonCore.VTK_TYPE_INT32,
    "i8": vtkCommonCore.VTK_TYPE_INT64,
    "u1": vtkCommonCore.VTK_TYPE_UINT8,
    "u2": vtkCommonCore.VTK_TYPE_UINT16,
    "u4": vtkCommonCore.VTK_TYPE_UINT32,
    "u8": vtkCommonCore.VTK_TYPE_UINT64,
}
_XYZ_GRID = 8  # three dimensions, as VTK numbers them; the constant's name depends on the version


class _Grid(NamedTuple):
    level: int
    corner: Sequence[int]  # of three, as the next
    cells: Sequence[int]
    arrays: Mapping[str, Any]  # vtkDataArray of each name, x varies fastest


def amr_from_arrays(
    blocks: Iterable[Block],
    spacing: Union[float, Sequence[float]] = 1.0,
    origin: Sequence[float] = (0.0, 0.0, 0.0),
    ratio: Union[int, Sequence[int]] = 2,
) -> vtkOverlappingAMR:
    """Makes a vtkOverlappingAMR of boxes of cells.

    A coarse cube of 8^3 cells whose middle is refined:

        coarse = numpy.random.rand(8, 8, 8)
        fine = numpy.random.rand(8, 8, 8)  # from cell (4, 4, 4) of level 1 on
        amr = exabricks.amr_from_arrays([(0, (0, 0, 0), coarse), (1, (4, 4, 4), fine)])

    blocks: (level, corner, values) of each. `corner` is the index (i, j, k) of the block's first cell among all
    cells of its level, where cell (0, 0, 0) begins at `origin` on every level; it may be negative. `values` is an
    array indexed [x, y, z] or [x, y, z, component], or a dict of such arrays by name, the same names and components
    in every block; an array without a name becomes "values". The first one is the active scalar, so that a mapper
    needs no SelectScalarArray().

    spacing: length of a cell of level 0, one for all axes or one for each.
    origin: of the lattice, in the same unit.
    ratio: how many cells of the next finer level fit into a cell along each axis; one whole number of at least 2 for
    all levels, or one for each level but the finest.

    Levels may have any number of blocks, also none. Blocks need not cover those of other levels, and where blocks of
    one level overlap, the mapper draws the first.

    VTK uses the memory of an array, without a copy, where x varies fastest in it, and the components of a cell lie
    together: `a.T` of a scalar array indexed [z, y, x], or one in Fortran's order. Others are copied once. The memory
    is kept until VTK needs it no more; whoever changes values in it calls Modified() on the VTK array and its block.
    Types stay as they are, but for half precision, which becomes single, and bytes in another machine's order.

    Raises ValueError or TypeError for anything else: what was expected, and what was found where.
    """
    spacing = _lengths("spacing", [spacing] * 3 if _is_number(spacing) else spacing)
    if min(spacing) <= 0.0:
        raise ValueError(f"expected a spacing above zero, found {spacing}")
    origin = _lengths("origin", origin)
    grids = []
    for number, block in enumerate(blocks):
        grids.append(_grid_of(number, block))
        _check_same_arrays(number, grids[-1], grids[0])
    if not grids:
        raise ValueError("expected at least one block (level, corner, values), found none")

    levels = 1 + max(grid.level for grid in grids)
    ratios = _ratios(ratio, levels)
    blocks_of = [[grid for grid in grids if grid.level == level] for level in range(levels)]
    amr = vtkOverlappingAMR()
    counts = [len(those) for those in blocks_of]
    if hasattr(amr, "GetOverlappingAMRMetaData"):  # VTK 9.6
        amr.Initialize(counts)
    else:
        amr.Initialize(levels, counts)
    amr.SetGridDescription(_XYZ_GRID)
    amr.SetOrigin(origin)
    for level, those in enumerate(blocks_of):
        scale = math.prod(ratios[:level])
        widths = [length / scale for length in spacing]
        amr.SetSpacing(level, widths)
        amr.SetRefinementRatio(level, ratios[level])
        for index, grid in enumerate(those):
            last = [grid.corner[axis] + grid.cells[axis] - 1 for axis in range(3)]
            amr.SetAMRBox(level, index, vtkAMRBox(grid.corner, last))
            amr.SetDataSet(level, index, _uniform_grid(grid, origin, widths, scalars=next(iter(grids[0].arrays))))
    return amr


def _uniform_grid(grid: _Grid, origin: Sequence[float], widths: Sequence[float], scalars: str) -> vtkUniformGrid:
    result = vtkUniformGrid()
    result.SetOrigin([origin[axis] + grid.corner[axis] * widths[axis] for axis in range(3)])
    result.SetSpacing(widths)
    result.SetDimensions([cells + 1 for cells in grid.cells])
    for array in grid.arrays.values():
        result.GetCellData().AddArray(array)
    result.GetCellData().SetActiveScalars(scalars)
    return result


def _grid_of(number: int, block: Block) -> _Grid:
    where = f"blocks[{number}]"
    try:
        level, corner, values = block
        corner = tuple(corner)
    except (TypeError, ValueError):
        raise TypeError(
            f"{where}: expected (level, corner, values) with a corner (i, j, k), found {_short(block)}"
        ) from None
    level = _whole(f"{where}, level", level)
    if level < 0:
        raise ValueError(f"{where}: expected a level from 0 on, found {level}")
    if len(corner) != 3:
        raise ValueError(f"{where}: expected a corner of three cell indices (i, j, k), found {corner}")
    first = [_whole(f"{where}, corner", index) for index in corner]
    cells, arrays = _arrays_of(where, values)
    for start, count in zip(first, cells):
        if start < -(2**31) or start + count >= 2**31:
            raise ValueError(
                f"{where}: expected cell indices that fit 32 bits, found {start} and {count} cells from there on"
            )
    return _Grid(level, first, cells, arrays)


def _arrays_of(where: str, values: Values) -> Tuple[Sequence[int], Dict[str, Any]]:
    """How many cells there are along x, y and z, and the VTK arrays of them."""
    arrays: Dict[str, Any] = {}
    cells: Sequence[int] = ()
    for name, given in (values if isinstance(values, Mapping) else {"values": values}).items():
        if not isinstance(name, str) or not name:
            raise TypeError(f"{where}: expected names of arrays as text, found {name!r}")
        array = _checked(f"{where}, array '{name}'", given)
        cells = cells or array.shape[:3]
        if array.shape[:3] != cells:
            raise ValueError(
                f"{where}: expected all arrays to have {_times(cells)} cells, as '{next(iter(arrays))}' has, found "
                f"{_times(array.shape[:3])} in '{name}'"
            )
        arrays[name] = _vtk_array(name, array)
    if not arrays:
        raise ValueError(f"{where}: expected at least one array, found none")
    return cells, arrays


def _checked(where: str, values: ArrayLike) -> Any:
    """The numpy array, of a type that VTK has and of native bytes."""
    import numpy

    if isinstance(values, numpy.ma.MaskedArray) and numpy.ma.is_masked(values):
        raise TypeError(
            f"{where}: expected an array without a mask, found one with {numpy.ma.count_masked(values)} masked "
            f"values. Give values.filled(numpy.nan): cells of NaN are not drawn"
        )
    array = numpy.asarray(values)
    if array.ndim not in (3, 4) or array.size == 0:
        raise ValueError(
            f"{where}: expected an array indexed [x, y, z] or [x, y, z, component] with at least one cell, found "
            f"shape {array.shape}"
        )
    if array.dtype.kind == "f" and array.dtype.itemsize == 2:
        return array.astype(numpy.float32, order="K")
    if array.dtype.str[1:] not in _VTK_TYPES:
        raise TypeError(
            f"{where}: expected whole numbers of 8 to 64 bits, or floating-point ones of 16 to 64, found "
            f"{array.dtype}.{_advice(array.dtype.kind)}"
        )
    return array if array.dtype.isnative else array.astype(array.dtype.newbyteorder("="), order="K")


def _advice(kind: str) -> str:
    return {
        "b": " Give values.view(numpy.uint8), which are 0 and 1",
        "c": " Give values.real, values.imag or abs(values)",
        "f": " Give values.astype(numpy.float64)",
        "O": " Give values.astype(float), if they are numbers of one length",
    }.get(kind, "")


def _vtk_array(name: str, values: Any) -> Any:
    """A VTK array of the values, in the same memory where they lie there as VTK wants them."""
    import numpy

    components = values.shape[3] if values.ndim == 4 else 1
    fastest_first = numpy.moveaxis(values, 3, 0) if values.ndim == 4 else values
    flat = fastest_first.ravel(order="F")  # copies only where it has to
    array = vtkCommonCore.vtkDataArray.CreateDataArray(_VTK_TYPES[flat.dtype.str[1:]])
    array.SetName(name)
    array.SetNumberOfComponents(components)
    array.SetVoidArray(flat, flat.size, 1)
    # VTK does not own this memory. The observer, which goes with the array, does.
    array.AddObserver("DeleteEvent", lambda caller, event, owner=flat: None)
    return array


def _check_same_arrays(number: int, grid: _Grid, first: _Grid) -> None:
    def described(arrays):
        return {name: array.GetNumberOfComponents() for name, array in arrays.items()}

    expected, found = described(first.arrays), described(grid.arrays)
    if expected != found:
        raise ValueError(
            f"blocks[{number}]: expected the arrays of blocks[0] with as many components, {expected}, found {found}"
        )


def _ratios(ratio: Union[int, Sequence[int]], levels: int) -> Sequence[int]:
    """One for each level; that of the finest has no meaning, but VTK wants one."""
    given: Any = ratio
    if _is_number(given):
        ratios = [given] * levels
    else:
        ratios = list(given)
        if len(ratios) != levels - 1:
            raise ValueError(
                f"expected one ratio, or one for each of the {levels - 1} steps between the {levels} levels there are, "
                f"found {ratios}"
            )
        ratios.append(ratios[-1] if ratios else 2)
    ratios = [_whole("ratio", value) for value in ratios]
    if min(ratios) < 2:
        raise ValueError(f"expected refinement ratios of at least 2, found {min(ratios)}")
    return ratios


def _is_number(value: Any) -> bool:
    return hasattr(value, "__float__") and not getattr(value, "shape", ())


def _whole(what: str, value: Any) -> int:
    try:
        return operator.index(value)
    except TypeError:
        raise TypeError(f"{what}: expected a whole number, found {value!r}") from None


def _lengths(what: str, values: Any) -> List[float]:
    try:
        lengths = [float(value) for value in values]
    except (TypeError, ValueError):
        lengths = []
    if len(lengths) != 3 or not all(math.isfinite(length) for length in lengths):
        raise ValueError(f"expected three finite numbers as {what}, found {_short(values)}")
    return lengths


def _times(cells: Sequence[int]) -> str:
    return " x ".join(str(count) for count in cells)


def _short(value: Any) -> str:
    text = " ".join(repr(value).split())
    return text if len(text) <= 80 else text[:77] + "..."
