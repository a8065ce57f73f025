# SPDX-License-Identifier: BSD-3-Clause
"""Writes a stub of the compiled module beside it, by which editors and type checkers know its classes.

    python3 write_stubs.py <folder that the package is in>

VTK's wrappers put the signature of each method into its docstring, and nothing else is read here. VTK has a program
for this too, vtkmodules.generate_pyi, but it leaves out the docstrings and the modules of the arguments' types, and
Debian's package of VTK 9.1 comes without it.
"""

import importlib
import os
import re
import sys
import textwrap

NAME = "vtkRenderingVolumeExaBricks"
SIGNATURE = r"(?ms)^{name}\(([^\n]*(?:\n    [^\n]*)*?)\)\s+->\s+([^\n]+)\nC\+\+: .*?\n(?! )"


class Stub:
    """The text of a stub. Classes of other modules are called by their full names, and these modules imported."""

    def __init__(self, module):
        self.module = module
        self.imported = set()
        classes = [self.of_class(value) for value in vars(module).values() if isinstance(value, type)]
        self.text = "\n".join([
            f'"""Written by write_stubs.py from {module.__name__}."""\n',
            "# Overloads look alike where vtkmodules has no stubs.\n# mypy: disable-error-code=misc\n",
            "from typing import Any, MutableSequence, Sequence, Tuple, overload\n",
            *(f"import {name}" for name in sorted(self.imported)),
            *(f"\n{text}" for text in classes)])

    def of_class(self, cls):
        lines = docstring((cls.__doc__ or "").partition("\n\n")[2])
        members = sorted(vars(cls).items())
        enumerations = [value for _, value in members if isinstance(value, type)]
        properties = [name for name, value in members if type(value).__name__ == "getset_descriptor" and name[0] != "_"]
        lines += [f"class {value.__name__}(int): ..." for value in enumerations]
        lines += [f"{name}: {type(value).__name__}" for name, value in members if type(value) in enumerations]
        lines += [f"{name}: Any" for name in properties]
        if properties:  # since VTK 9.4, and then they are keywords too
            lines.append("def __init__(self, **properties: Any) -> None: ...")
        for name, value in members:
            if callable(value) and not isinstance(value, type):
                lines += self.of_method(name, value.__doc__ or "")
        return f"class {cls.__name__}({self.full_name(cls.__mro__[1].__name__)}):\n" + indented(lines)

    def of_method(self, name, doc):
        """`doc`: for each overload 'Name(self, argument:type) -> type', 'C++: ...'; then words."""
        overloads = list(re.finditer(SIGNATURE.format(name=name), doc))
        lines = []
        for overload in overloads:
            arguments = " ".join(overload.group(1).split())
            lines += ["@overload"] if len(overloads) > 1 else []
            lines += [] if arguments.split(",")[0] == "self" else ["@staticmethod"]
            arguments = self.types_in(arguments, lambda types: f"Sequence[{types[0]}]")
            result = self.types_in(overload.group(2), lambda types: f"Tuple[{', '.join(types)}]")
            words = docstring(doc[overloads[-1].end():])
            lines.append(f"def {name}({arguments}) -> {result}:")
            lines.append(indented(words + ["..."]).rstrip())
        return lines

    def types_in(self, text, of_tuple):
        """VTK's words for types in Python's: [int, int] is an array that is filled, (int, int) a tuple."""
        text = re.sub(r"\[(\w+)(, \w+)*\]", r"MutableSequence[\1]", text)
        text = re.sub(r"\((\w+(, \w+)*)\)", lambda match: of_tuple(match.group(1).split(", ")), text)
        text = re.sub(r"\bvtk\w+", lambda match: self.full_name(match.group()), text)
        return text.replace(":", ": ").replace("=", " = ")

    def full_name(self, name):
        if hasattr(self.module, name):
            return name
        for other, module in sorted(sys.modules.items()):
            if other.startswith("vtkmodules.vtk") and getattr(vars(module).get(name), "__module__", None) == other:
                self.imported.add(other)
                return f"{other}.{name}"
        return "Any"


def indented(lines):
    return textwrap.indent("\n".join(lines) or "...", "    ") + "\n"


def docstring(text):
    text = text.strip().replace("\\", "\\\\").replace('"', "'")
    return [f'"""{text}"""'] if text else []


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.path[0] = sys.argv[1]  # in place of this script's folder, where the package lies too, without the module
    stub = Stub(importlib.import_module(f"exabricks.{NAME}"))
    with open(os.path.join(sys.argv[1], "exabricks", f"{NAME}.pyi"), "w", encoding="utf-8") as file:
        file.write(stub.text)
