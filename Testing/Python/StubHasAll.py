# SPDX-License-Identifier: BSD-3-Clause
"""The stub of the compiled module: editors and type checkers find in it all that its classes have, with types."""

import ast
import os
import sys

import exabricks.vtkRenderingVolumeExaBricks as compiled

source = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Module", "Python")
sys.path.append(source)
from write_stubs import Stub

text = Stub(compiled).text
classes = {node.name: node for node in ast.parse(text).body if isinstance(node, ast.ClassDef)}
assert set(classes) == {name for name, value in vars(compiled).items() if isinstance(value, type)}
for name, node in classes.items():
    members = {member.name for member in node.body if isinstance(member, (ast.FunctionDef, ast.ClassDef))}
    members |= {member.target.id for member in node.body if isinstance(member, ast.AnnAssign)}
    missing = {member for member in vars(getattr(compiled, name)) if not member.startswith("_")} - members
    assert not missing, (name, missing)
    assert ast.get_docstring(node), name

mapper = ast.unparse(classes["vtkExaBricksVolumeMapper"])
for definition in (
    "class vtkExaBricksVolumeMapper(vtkmodules.vtkRenderingVolume.vtkVolumeMapper)",
    "NEAREST: ReconstructionType",
    "def GetBuilder(self) -> vtkExaBricksBuilder",
    "def SetStepScale(self, _arg: float) -> None",
    "@overload\n    def SetInputData(self, amr: vtkmodules.vtkCommonDataModel.vtkOverlappingAMR) -> None",
    "@overload\n    def SetLevelRange(self, _arg: Sequence[int]) -> None",
    "@staticmethod\n    def GetDevices(lines: vtkmodules.vtkCommonCore.vtkStringArray) -> None",
    "@overload\n    def GetBounds(self, bounds: MutableSequence[float]) -> None",
    "def GetLevelRange(self) -> Tuple[int, int]",
):
    assert definition in mapper, definition
for module in ("vtkCommonCore", "vtkCommonDataModel", "vtkRenderingVolume"):
    assert f"\nimport vtkmodules.{module}\n" in text, module
