# SPDX-License-Identifier: BSD-3-Clause
"""Pictures while something moves: the time allowed for each, the time taken, and how near they are: writes motion.csv.

    PYTHONPATH=<folder of exabricks> /usr/bin/python3 Motion.py <folder of results> [<height> [<frames> [<leaf cells>...]]]

The camera turns by 2 degrees from picture to picture, at several desired update rates of the window, each of which allows a
time. The shipped Rayleigh-Taylor data, beside VTK's mappers of a resampled grid of 128 cells along each axis, and clouds of so
many leaf cells. Errors are those of the pixels drawn in either picture beside ours with a quarter of the step, 8 bits a channel;
where VTK's mappers have theirs from the resampling too. The first picture at a rate does not count.
"""

import pathlib
import statistics
import sys
import time

from FeatureCosts import FINEST, Method, decibels, exabricks, make_peer, plain, read, resample, write_csv
from vtkmodules.vtkRenderingVolume import vtkFixedPointVolumeRayCastMapper
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkSmartVolumeMapper

RATES = (2, 5, 10, 15, 30)  # pictures a second
TURN = 2.0  # degrees
COMPARED = 4  # of the pictures at a rate
REFERENCE_STEP = 0.25


def ours_of(source, array):
    mapper = exabricks.vtkExaBricksVolumeMapper()
    if hasattr(source, "GetOutputPort"):
        mapper.SetInputConnection(source.GetOutputPort())
    else:
        mapper.SetInputDataObject(source)
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectScalarArray(array)
    mapper.SetReconstructionToBasis()
    return mapper


def rayleigh_taylor(height):
    amr = read()
    image = resample(amr, 128)
    smart = make_peer(image, vtkSmartVolumeMapper, plain, 128, height)
    fixed = make_peer(image, vtkFixedPointVolumeRayCastMapper, plain, 128, height)
    for peer in (smart, fixed):
        peer.mapper.AutoAdjustSampleDistancesOn()
    # Its steps below a second; by default a length of 1.
    fixed.mapper.SetInteractiveSampleDistance(2.0 * FINEST)
    smart.name, fixed.name = "vtkSmartVolumeMapper, 128^3", "vtkFixedPointVolumeRayCastMapper, 128^3"
    ours = Method("vtkExaBricksVolumeMapper", plain, ours_of(amr, "magvort"), 1.0, height)
    reference = Method("reference", plain, ours_of(amr, "magvort"), REFERENCE_STEP, height)
    return "rt_medium", [ours, smart, fixed], reference


def cloud(height, cells):
    source = exabricks.vtkExaBricksSceneSource()
    source.SetSceneToCloud()
    source.SetNumberOfLeafCells(cells)
    source.Update()
    methods = []
    for name in ("vtkExaBricksVolumeMapper", "reference"):
        method = Method(name, plain, ours_of(source, "value"), 1.0, height)
        source.InitializeProperty(method.volume.GetProperty())
        renderer = method.window.GetRenderers().GetFirstRenderer()
        source.InitializeCamera(renderer.GetActiveCamera())
        renderer.ResetCameraClippingRange()
        methods.append(method)
    return f"Cloud {cells:.0e}".replace("e+0", "e"), methods[:1], methods[1]


def camera_of(method):
    return method.window.GetRenderers().GetFirstRenderer().GetActiveCamera()


def move(method, reference, rate, frames):
    """Turns the camera, and back; returns the times of pictures in seconds, by the clock and of all processors, and decibels."""
    times, processor, nearness = [], [], []
    method.window.SetDesiredUpdateRate(rate)
    for frame in range(frames + 1):
        camera_of(method).Azimuth(TURN)
        begin, worked = time.perf_counter(), time.process_time()
        method.window.Render()
        times.append(time.perf_counter() - begin)
        processor.append(time.process_time() - worked)
        if frame > 0 and frame % max(frames // COMPARED, 1) == 0:
            found = method.picture()
            camera_of(reference).DeepCopy(camera_of(method))
            reference.window.Render()
            nearness.append(decibels(found, reference.picture()))
    camera_of(method).Azimuth(-TURN * (frames + 1))
    return times[1:], processor[1:], nearness


def main(folder, height=600, frames=24, *clouds):
    scenes = [lambda: rayleigh_taylor(height)]
    scenes += [lambda cells=cells: cloud(height, cells) for cells in clouds or (1000000, 10000000)]
    lines = []
    for make in scenes:
        scene, methods, reference = make()
        reference.mapper.SetStepScale(REFERENCE_STEP)
        for method in [*methods, reference]:
            method.window.SetSize(height * 4 // 3, height)
            method.window.Render()
        for rate in RATES:
            for method in methods:
                times, processor, nearness = move(method, reference, rate, frames)
                ordered = sorted(taken * rate for taken in times)
                ours = method is methods[0]
                lines.append({
                    "scene": scene, "method": method.name, "allowed_ms": round(1e3 / rate, 1),
                    "taken_ms": round(1e3 * statistics.median(times), 1),
                    "cpu_ms": round(1e3 * statistics.median(processor), 1),
                    "taken_of_allowed": round(statistics.median(ordered), 3),
                    "least": round(ordered[len(ordered) // 10], 3), "most": round(ordered[-1 - len(ordered) // 10], 3),
                    "db": round(statistics.median(nearness), 2),
                    "distance": round(method.mapper.GetUsedImageSampleDistance(), 2) if ours else "",
                    "growth": round(method.mapper.GetUsedStepGrowth(), 2) if ours else "",
                    "levels": method.mapper.GetLevelsLeftOut() if ours else ""})
                print(*lines[-1].values(), sep=", ", flush=True)
    write_csv(pathlib.Path(folder) / "motion.csv", lines)


if __name__ == "__main__":
    main(sys.argv[1], *map(int, sys.argv[2:]))
