#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A program that draws in a window, where there is no X server: it says what it needs, and does not crash.

Usage: TestWithoutDisplay.py VTK_VERSION PROGRAM [ARGUMENT...]
"""

import os
import subprocess
import sys

version, command = tuple(int(part) for part in sys.argv[1].split(".")[:2]), sys.argv[2:]

for display in (None, ":987654"):  # not set, and one that does not answer
    environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
    if display:
        environment["DISPLAY"] = display
    done = subprocess.run(
        command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=300, check=False
    )
    words = "DISPLAY=%s: ended with %d and said %r" % (display, done.returncode, done.stderr)
    # From 9.4 on VTK draws without a display, where it finds EGL or OSMesa.
    if version >= (9, 4) and done.returncode == 0:
        continue
    assert done.returncode == 1, words
    assert "needs a display" in done.stderr and "xvfb-run -a" in done.stderr, words
