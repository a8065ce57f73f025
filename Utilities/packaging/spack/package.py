# SPDX-License-Identifier: BSD-3-Clause
"""A Spack package, for a repository of one's own: its syntax is checked; it was not built with Spack."""

from spack.package import *


class Exabricks(CMakePackage):
    """Volume rendering of overlapping AMR in VTK by active brick regions, with Vulkan."""

    license("BSD-3-Clause")
    version("main", branch="main")

    variant("python", default=True, description="Build the Python package and the viewer")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.22:", type="build")
    depends_on("ninja", type="build")
    depends_on("vtk@9.1:")
    depends_on("vtk+python", when="+python")
    depends_on("vulkan-headers", type="build")
    depends_on("vulkan-loader", type="run")
    depends_on("glslang", type="build")
    depends_on("glm", type="build")
    depends_on("cli11", type="build")
    depends_on("nlohmann-json", type="build")
    extends("python", when="+python")
    depends_on("py-numpy", type="run", when="+python")

    def cmake_args(self):
        args = [
            self.define_from_variant("EXABRICKS_BUILD_PYTHON", "python"),
            self.define("EXABRICKS_BUILD_TESTING", False),
        ]
        if self.spec.satisfies("+python"):
            args.append(self.define("EXABRICKS_PYTHON_DIR", python_platlib))
            args.append(self.define("Python3_EXECUTABLE", python.path))
        return args
