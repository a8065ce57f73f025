# SPDX-License-Identifier: BSD-3-Clause
"""Overlapping AMR of a data set of yt, for the codes that yt reads and VTK does not."""

from __future__ import annotations

import difflib
import operator
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, Optional, Sequence, Tuple, Union

from .arrays import amr_from_arrays

if TYPE_CHECKING:
    from vtkmodules.vtkCommonDataModel import vtkOverlappingAMR

Field = Union[str, Tuple[str, str]]


def amr_from_yt(
    dataset: Any, fields: Union[Field, Sequence[Field]], levels: Optional[int] = None
) -> vtkOverlappingAMR:
    """Makes a vtkOverlappingAMR of a yt data set of grids, such as those of AMReX, Enzo or FLASH.

        dataset = yt.load("DD0010/moving7_0010")
        amr = exabricks.amr_from_yt(dataset, ("gas", "density"))

    dataset: what yt.load() or yt.load_amr_grids() returns, three-dimensional and cartesian.
    fields: name of a cell field, ("gas", "density") or "density", or a list of them, also such as yt derives. Arrays
    carry the second name, or "gas_density" where several fields share that. The first one is the active scalar.
    levels: how many are taken, from the coarsest on, 1 at least. None: all.

    Lengths are in yt's code_length, values in the units that yt gives to the fields. All of them are read into memory.

    Raises ValueError for other data sets and fields: what was expected, and what was found.
    """
    grids = _grids_of(dataset)
    if levels is not None:
        levels = operator.index(levels)
        if levels < 1:
            raise ValueError(f"expected at least 1 level, found levels={levels}")
        grids = [grid for grid in grids if grid.Level < levels]
    single: Any = [fields] if isinstance(fields, (str, tuple)) else list(fields)
    names = _names_of(dataset, single)
    spacings = _spacings_of(grids, dataset)
    ratios = [_ratio(level, *spacings[level : level + 2]) for level in range(len(spacings) - 1)]
    left = [float(edge) for edge in dataset.domain_left_edge.to("code_length")]
    return amr_from_arrays(_blocks_of(grids, names), spacing=spacings[0], origin=left, ratio=ratios)


def _grids_of(dataset: Any) -> List[Any]:
    kind = type(dataset).__name__
    if dataset.dimensionality != 3:
        raise ValueError(f"expected a data set of 3 dimensions, found a {kind} of {dataset.dimensionality}")
    geometry = str(getattr(dataset.geometry, "value", dataset.geometry))
    if geometry != "cartesian":
        raise ValueError(f"expected cartesian coordinates, found a {kind} with {geometry} ones")
    grids = getattr(dataset.index, "grids", None)
    if grids is None:
        raise ValueError(
            f"expected a data set of grids, found a {kind} with {type(dataset.index).__name__}: octrees, particles and "
            f"unstructured meshes have none. Let yt resample a region to one, with dataset.arbitrary_grid() or "
            f"dataset.covering_grid(), and give it to amr_from_arrays()"
        )
    return list(grids)


def _names_of(dataset: Any, fields: List[Field]) -> Dict[str, Tuple[str, str]]:
    """yt's full name of each field, by the name of its array."""
    if not fields:
        raise ValueError("expected at least one field, found none")
    full = []
    for field in fields:
        name = _full_name(dataset, field)
        sampling = dataset.field_info[name].sampling_type
        if sampling != "cell":
            raise ValueError(
                f"expected fields of cells, found {name} of sampling type '{sampling}'. Fields of type 'deposit' are "
                f"sums of particles in cells"
            )
        if name not in full:
            full.append(name)
    short = [name for _, name in full]
    return {(name if short.count(name) == 1 else f"{kind}_{name}"): (kind, name) for kind, name in full}


def _full_name(dataset: Any, field: Field) -> Tuple[str, str]:
    dataset.index  # with which yt learns what fields there are
    known = dataset.derived_field_list  # those in the file too
    candidates: List[Any] = [field]
    if isinstance(field, str):
        preferred = (getattr(dataset, "default_fluid_type", "gas"), field)
        candidates = [preferred] + [name for name in known if name[1] == field]
    for name in candidates:
        if name in known:
            return name
    close = difflib.get_close_matches(str(candidates[0]), [str(name) for name in known], n=3)
    raise ValueError(
        f"expected a field of the data set, found {field!r}. "
        + (f"Near it are {', '.join(close)}" if close else "dataset.derived_field_list has those there are")
    )


def _spacings_of(grids: Sequence[Any], dataset: Any) -> List[List[float]]:
    """Lengths of a cell on each level. They are those of grids, as codes differ in what they call their ratio."""
    found = {}
    for grid in grids:
        if grid.Level not in found:
            found[int(grid.Level)] = [float(width) for width in grid.dds.to("code_length")]
    widths = dataset.domain_width.to("code_length") / dataset.domain_dimensions
    spacings = [[float(width) for width in widths]]
    for level in range(1, 1 + max(found, default=0)):
        # Of a level without grids nobody asks more than that it is finer.
        spacings.append(found.get(level, [width / dataset.refine_by for width in spacings[-1]]))
    return spacings


def _ratio(level: int, coarse: Sequence[float], fine: Sequence[float]) -> int:
    ratio = round(coarse[0] / fine[0])
    if any(abs(wide / narrow - ratio) > 1e-3 * ratio for wide, narrow in zip(coarse, fine)):
        raise ValueError(
            f"expected the same whole refinement ratio along all axes, found cells of {coarse} on level {level} and of "
            f"{fine} on level {level + 1}"
        )
    return ratio


def _blocks_of(grids: Sequence[Any], names: Dict[str, Tuple[str, str]]) -> Iterator[Tuple[int, List[int], Any]]:
    for grid in grids:
        corner = [int(index) for index in grid.get_global_startindex()]
        values = {name: grid[field].d for name, field in names.items()}
        grid.clear_data()  # yt would keep all values a second time
        yield int(grid.Level), corner, values
