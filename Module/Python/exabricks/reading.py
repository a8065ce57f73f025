# SPDX-License-Identifier: BSD-3-Clause
"""Reads AMR files with the readers of VTK: whole, where these read few levels and no arrays unless told to."""

from __future__ import annotations

import difflib
import math
import operator
import os
import re
import warnings
from typing import Any, Callable, Dict, Iterator, List, NamedTuple, Optional, Sequence, Tuple, Union

from vtkmodules.vtkCommonCore import vtkLogger, vtkObject, vtkOutputWindow, vtkStringOutputWindow, vtkVersion
from vtkmodules.vtkCommonDataModel import vtkOverlappingAMR

from .vtkRenderingVolumeExaBricks import vtkExaBricksFileCheck

Path = Union[str, "os.PathLike[str]"]

_GHOSTS = "vtkGhostType"  # by which VTK marks covered cells, no data of the file's


class ReadError(OSError):
    """A file that cannot be read: says what was expected, what was found and what to do."""


class ArrayInfo(NamedTuple):
    """What is known of a cell array: of each component the least and greatest finite value on the coarsest level.

    Both are NaN where no value is finite.
    """

    components: int
    ranges: Tuple[Tuple[float, float], ...]


def read(
    path: Path, levels: Optional[int] = None, arrays: Union[str, Sequence[str], None] = None
) -> vtkOverlappingAMR:
    """Reads an AMR data set.

        amr = exabricks.read("plt00216", arrays="density")

    path: the folder of an AMReX plotfile, an Enzo .hierarchy, a FLASH .hdf5, a .vthb or .vth, or a .vtkhdf (VTK 9.3
    or later).
    levels: how many are read, from the coarsest on, 1 at least. None: all. The finer ones stay without blocks.
    arrays: name of a cell array, or several, of which the first is the active scalar, so that a mapper needs no
    SelectScalarArray(). None: all, and none of them is.

    Raises ReadError if that is not to be had. What VTK warns of comes as RuntimeWarning.
    """
    if levels is not None:
        levels = operator.index(levels)
        if levels < 1:
            raise ReadError(f"Expected at least 1 level to read, found levels={levels}: leave it out to read all.")
    file = _AMRFile(path)
    if arrays is None:
        return file.read(levels)
    names = [arrays] if isinstance(arrays, str) else list(arrays)
    file.select(names)
    amr = file.read(levels)
    for block in _blocks(amr):
        block.GetCellData().SetActiveScalars(names[0])
    return amr


def list_arrays(path: Path) -> Dict[str, ArrayInfo]:
    """Cell arrays of an AMR data set, by name. The coarsest level is read for it.

        for name, (components, ranges) in exabricks.list_arrays("plt00216").items():
            print(name, components, ranges)

    path: as for read(). Raises ReadError if it cannot be read.
    """
    return arrays_of(_AMRFile(path).read(1))


def arrays_of(amr: vtkOverlappingAMR) -> Dict[str, ArrayInfo]:
    """Cell arrays of the blocks that are there, by name, with ranges over all of these."""
    found: Dict[str, ArrayInfo] = {}
    for block in _blocks(amr):
        cells = block.GetCellData()
        for i in range(cells.GetNumberOfArrays()):
            array = cells.GetArray(i)
            if array and array.GetName() and array.GetName() != _GHOSTS:
                _add_ranges(found, array)
    return found


def _add_ranges(found: Dict[str, ArrayInfo], array: Any) -> None:
    components = array.GetNumberOfComponents()
    nothing = ((math.nan, math.nan),) * components
    ranges = []
    for component, known in enumerate(found.get(array.GetName(), ArrayInfo(components, nothing)).ranges):
        least, greatest = array.GetFiniteRange(component)
        if least > greatest:  # VTK's way to say that there is none
            ranges.append(known)
        elif math.isnan(known[0]):
            ranges.append((least, greatest))
        else:
            ranges.append((min(least, known[0]), max(greatest, known[1])))
    found[array.GetName()] = ArrayInfo(components, tuple(ranges))


class _AMRFile:
    """A file and the reader for it, which has read what the file says of itself."""

    def __init__(self, path: Path):
        self.path = _without_slash(os.fsdecode(path))
        self.reader = _reader_for(self.path)
        # VTK's Enzo reader looks for files beside the name as it is given, and not in the folder that is the current one.
        name = os.path.abspath(self.path) if self.path.endswith(".hierarchy") else self.path
        self.warnings: List[str] = []
        self._run(lambda: self.reader.SetFileName(name))  # some readers open the file right away
        self._run(self.reader.UpdateInformation)
        self.selection = self.reader.GetCellDataArraySelection()
        self.selection.EnableAllArrays()

    def select(self, names: List[str]) -> None:
        """Switches these arrays on, and the others off."""
        known = [self.selection.GetArrayName(i) for i in range(self.selection.GetNumberOfArrays())]
        choice = "choose of " + ", ".join(known) if known else "it has none"
        if not names:
            raise ReadError(f"Expected the name of at least one cell array of '{self.path}', found none: {choice}.")
        for name in names:
            if name not in known:
                raise ReadError(
                    f"There is no cell array '{name}' in '{self.path}': {_did_you_mean(name, known)}{choice}."
                )
        self.selection.DisableAllArrays()
        for name in names:
            self.selection.EnableArray(name)

    def read(self, levels: Optional[int]) -> vtkOverlappingAMR:
        """Reads so many levels, or all."""
        if hasattr(self.reader, "SetMaxLevel"):
            self.reader.SetMaxLevel(1000000 if levels is None else levels - 1)
        elif hasattr(self.reader, "SetMaximumLevelsToReadByDefaultForAMR"):
            self.reader.SetMaximumLevelsToReadByDefaultForAMR(levels or 0)  # 0 is all, here and below
        else:
            self.reader.SetMaximumLevelsToReadByDefault(levels or 0)
        self._run(self.reader.Update)
        output = self.reader.GetOutputDataObject(0)
        if not isinstance(output, vtkOverlappingAMR):
            raise ReadError(
                f"'{self.path}' is not overlapping AMR: VTK {vtkVersion.GetVTKVersion()} read a "
                f"{output.GetClassName() if output else 'nothing'} from it."
            )
        if next(_blocks(output), None) is None:
            raise ReadError(_lines(f"'{self.path}' holds no blocks: there is nothing to draw.", self.warnings))
        if self.warnings:
            warnings.warn(_lines(f"Of '{self.path}' VTK says:", self.warnings), RuntimeWarning, stacklevel=3)
        return output

    def _run(self, work: Callable[[], Any]) -> None:
        """Lets the reader work, and keeps what it warns of."""
        with _Messages() as messages:
            work()
        if messages.errors:
            raise ReadError(_lines(f"'{self.path}' could not be read.", messages.errors))
        self.warnings += [text for text in messages.warnings if text not in self.warnings]


def _blocks(amr: vtkOverlappingAMR) -> Iterator[Any]:
    """The blocks that are there, from the coarsest level on."""
    count = amr.GetNumberOfBlocks if hasattr(amr, "GetNumberOfBlocks") else amr.GetNumberOfDataSets
    get = amr.GetDataSetAsCartesianGrid if hasattr(amr, "GetDataSetAsCartesianGrid") else amr.GetDataSet
    for level in range(amr.GetNumberOfLevels()):
        for index in range(count(level)):
            block = get(level, index)
            if block:
                yield block


def _did_you_mean(name: Any, known: List[str]) -> str:
    lower = {other.lower(): other for other in known}
    close = difflib.get_close_matches(str(name).lower(), lower, n=1)
    return f"did you mean '{lower[close[0]]}'? Else " if close else ""


# Which reader, and what is checked before it may read


def _without_slash(path: str) -> str:
    # A slash at the end would stay in the names that the AMReX reader makes.
    return path.rstrip("/" + os.sep) or path


def _reader_for(path: str) -> Any:
    if not os.path.exists(path):
        raise ReadError(f"There is no file or folder '{path}': check the path.")
    ending = os.path.splitext(path)[1]
    if os.path.isdir(path):
        _check_plotfile(path)
        reader = _class("vtkIOAMR", "vtkAMReXGridReader", "AMReX plotfiles")
    elif not os.access(path, os.R_OK):
        raise ReadError(f"The file '{path}' may not be read: check its permissions.")
    elif ending in (".vthb", ".vth"):
        reader = _class("vtkIOXML", "vtkXMLUniformGridAMRReader", f"{ending} files")
    elif ending == ".hierarchy":
        _check_hierarchy(path)
        reader = _class("vtkIOAMR", "vtkAMREnzoReader", "Enzo data sets")
    elif ending == ".hdf5":
        _check_hdf5(path)
        reader = _class("vtkIOAMR", "vtkAMRFlashReader", "FLASH files")
    elif ending == ".vtkhdf":
        _check_hdf5(path)
        reader = _class("vtkIOHDF", "vtkHDFReader", ".vtkhdf files")
        if not hasattr(reader, "SetMaximumLevelsToReadByDefaultForAMR"):
            raise ReadError(
                f"'{path}' cannot be read: AMR in .vtkhdf files needs VTK 9.3 or later, and this is VTK "
                f"{vtkVersion.GetVTKVersion()}."
            )
    else:
        raise ReadError(
            f"'{path}' is of no known kind. Expected a .vthb, .vth, .hierarchy, .hdf5 or .vtkhdf file, or the folder "
            f"of an AMReX plotfile."
        )
    fault = vtkExaBricksFileCheck.FindFault(path)
    if fault:
        kind = os.path.isdir(path)  # a plotfile may be whole, and 2-D
        raise ReadError(f"'{path}' is damaged{', or of a kind that is not read' if kind else ''}: {fault}. "
                        "Copy it anew, or write it once more.")
    return reader


def _class(module: str, name: str, what: str) -> Any:
    """An instance of a reader. Its module is imported now, as not every build of VTK has it."""
    import importlib

    try:
        return getattr(importlib.import_module(f"vtkmodules.{module}"), name)()
    except (ImportError, AttributeError):
        raise ReadError(f"This VTK cannot read {what}: its module {module} with {name} is not there.") from None


def _check_plotfile(folder: str) -> None:
    """An AMReX plotfile is a folder; its file Header begins with a line such as HyperCLaw-V1.1."""
    advice = "Give the folder of an AMReX plotfile, such as plt00216."
    names = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
    other = [name for name in names if name.endswith((".hierarchy", ".vthb", ".vth"))]
    if other:
        advice = f"Did you mean '{os.path.join(folder, other[0])}'?"
    try:
        with open(os.path.join(folder, "Header"), encoding="utf-8", errors="replace") as header:
            version = header.readline(1000)
            arrays = header.readline(1000).strip()
    except OSError:
        raise ReadError(f"The folder '{folder}' holds no readable file named Header. {advice}") from None
    if "-V" not in version or not arrays.isdigit() or int(arrays) < 1:
        raise ReadError(
            f"The file Header in '{folder}' is not that of a plotfile: it should begin with a version, such as "
            f"HyperCLaw-V1.1, and the number of arrays. {advice}"
        )


def _check_hdf5(path: str) -> None:
    """HDF5 prints a page of its own where a file is no HDF5 file, or shorter than its first bytes say."""
    with open(path, "rb") as file:
        head = file.read(96)
    if not head.startswith(b"\x89HDF\r\n\x1a\n") or len(head) < 48 or head[8] > 3:
        raise ReadError(f"'{path}' is not an HDF5 file: check that it was copied whole.")
    # Place of the end of the file in the superblock, which begins with the widths of an address.
    width, first = (head[9], 12) if head[8] >= 2 else (head[13], 28 if head[8] == 1 else 24)
    end = int.from_bytes(head[first + 2 * width : first + 3 * width], "little")
    size = os.path.getsize(path)
    if size < end:
        raise ReadError(f"'{path}' is damaged: expected {end} bytes, found {size}. Copy it anew.")


def _check_hierarchy(path: str) -> None:
    """Enzo: grids are listed in NAME.hierarchy, parameters are in NAME beside it."""
    with open(path, encoding="utf-8", errors="replace") as file:
        words = file.read(1000).split()
    if words[:1] != ["Grid"]:
        raise ReadError(f"'{path}' is not an Enzo hierarchy: it should begin with 'Grid = 1'.")
    parameters = os.path.splitext(path)[0]
    if not os.access(parameters, os.R_OK):
        raise ReadError(
            f"There is no readable file '{parameters}', which holds the parameters of this Enzo data set: copy it "
            f"there."
        )


# What VTK says


def _lines(head: str, messages: List[str], most: int = 5) -> str:
    more = len(messages) - most
    return "\n  ".join([head, *messages[:most]] + ([f"and {more} messages more"] if more > 0 else []))


class _Messages:
    """Collects errors and warnings of VTK, of whatever object, in place of its printing them.

    The output window is VTK's only one, for all threads.
    """

    def __enter__(self) -> _Messages:
        self.window = vtkStringOutputWindow()
        self.previous = vtkOutputWindow.GetInstance()
        vtkOutputWindow.SetInstance(self.window)
        self.shown = vtkObject.GetGlobalWarningDisplay()
        vtkObject.GlobalWarningDisplayOn()  # else there are no errors to collect
        # The log writes to stderr too. VTK tells the highest of the verbosities of stderr and of log files alone: where
        # there are such files, it is VTK's own default for stderr that is restored, at most.
        self.verbosity = vtkLogger.GetCurrentVerbosityCutoff()
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        if vtkLogger.GetCurrentVerbosityCutoff() == self.verbosity:
            self.verbosity = min(self.verbosity, vtkLogger.VERBOSITY_INFO)
        return self

    def __exit__(self, *exception: Any) -> None:
        vtkLogger.SetStderrVerbosity(self.verbosity)
        vtkObject.SetGlobalWarningDisplay(self.shown)
        vtkOutputWindow.SetInstance(self.previous)
        self.errors: List[str] = []
        self.warnings: List[str] = []
        echoes = False
        # Each message begins as 'ERROR: In file.cxx, line 7', most go on as 'vtkClass (0x123): words'.
        parts = re.split(r"(?m)^(ERROR|Warning|Generic Warning): In .*, line \d+\n", self.window.GetOutput())
        for kind, text in zip(parts[1::2], parts[2::2]):
            text = re.sub(r"\Avtk\w+ \(0x.*?\): ", "", text).strip()
            if "returned failure for request" in text:
                echoes = True  # of the pipeline, for what a filter has said in its own words
            elif text not in self.errors + self.warnings:
                (self.errors if kind == "ERROR" else self.warnings).append(text)
        if echoes and not self.errors:
            self.errors = ["A step of the pipeline failed and did not say why.", *self.warnings]
