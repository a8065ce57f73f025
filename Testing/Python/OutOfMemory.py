# SPDX-License-Identifier: BSD-3-Clause
"""A scene that the process has no memory for ends in one error and an empty output, and is made once there is some."""

import sys

import exabricks

try:
    import resource

    with open("/proc/self/statm", encoding="ascii") as statm:
        statm.read()
except (ImportError, OSError):
    print("there is no way here to limit the memory of a process")
    sys.exit(125)

errors = []


def collect(caller, event, message):
    errors.append(message)


collect.CallDataType = "string0"


def update(source, more_megabytes):
    """Runs the source with little more memory than the process has now."""
    with open("/proc/self/statm", encoding="ascii") as statm:
        now = int(statm.read().split()[0]) * resource.getpagesize()
    soft, hard = resource.getrlimit(resource.RLIMIT_AS)
    resource.setrlimit(resource.RLIMIT_AS, (now + more_megabytes * 1000000, hard))
    source.Update()
    resource.setrlimit(resource.RLIMIT_AS, (soft, hard))


first = exabricks.vtkExaBricksSceneSource()
first.Update()  # threads are started with all the memory there is

source = exabricks.vtkExaBricksSceneSource()
source.AddObserver("ErrorEvent", collect)
source.SetSceneToImpact5K()
source.SetNumberOfLeafCells(2000000)
for megabytes in (10, 40, 80):
    update(source, megabytes)
    assert source.GetOutput().GetNumberOfLevels() == 0
    assert len(errors) == 1, errors  # it is said once as long as it stays
for word in ("Out of memory on the host", "2000000 leaf cells", "10000000 bytes", "smaller NumberOfLeafCells"):
    assert word in errors[0], (word, errors[0])

source.Update()
assert len(errors) == 1, errors
assert source.GetOutput().GetNumberOfLevels() == 4, source.GetOutput().GetNumberOfLevels()
