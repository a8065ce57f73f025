#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The example Minimal with a file whose header asks for more memory than there is: words, and no crash.

Usage: TestDamagedFile.py PROGRAM
"""

import os
import subprocess
import sys
import tempfile

from TestRenderProgram import write_vthb

# The sanitizers would end the program where memory runs out.
environment = dict(os.environ, ASAN_OPTIONS=os.environ.get("ASAN_OPTIONS", "") + ":allocator_may_return_null=1")

with tempfile.TemporaryDirectory() as folder:
    path = write_vthb(folder, 2**20)
    done = subprocess.run(
        [sys.argv[1], path, "density"], env=environment, stderr=subprocess.PIPE, text=True, timeout=300, check=False
    )
    words = "ended with %d and said %r" % (done.returncode, done.stderr)
    assert done.returncode == 1, words
    assert path + " is damaged" in done.stderr, words
