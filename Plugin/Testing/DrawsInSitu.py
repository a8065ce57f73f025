# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a simulation that hands its blocks to Catalyst, rank by rank: those of four ranks are those of one.

Runs Examples/InSitu, as it is, in pvbatch.
"""

import pathlib
import subprocess

from Support import *

EXAMPLE = pathlib.Path(__file__).resolve().parent.parent.parent / "Examples" / "InSitu"
STEPS = 3


def simulate(ranks):
    """The pictures of all steps."""
    folder = pathlib.Path(f"ranks{ranks}").resolve()
    folder.mkdir(exist_ok=True)
    for old in folder.glob("pictures/*.png"):
        old.unlink()
    command = [os.environ["EXABRICKS_MPIEXEC"], "-n", str(ranks), os.environ["EXABRICKS_PVBATCH"], "--sym",
               str(EXAMPLE / "simulation.py"), str(EXAMPLE / "catalyst_script.py"), str(STEPS)]
    done = subprocess.run(command, cwd=folder, env=environment_of_ranks(), stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)
    print(done.stdout)
    assert done.returncode == 0, done.returncode
    assert "ExaBricks" not in done.stdout, "ExaBricks says something"
    return [read_picture(str(folder / "pictures" / f"step{step:02d}.png")) for step in range(STEPS)]


one, four = simulate(1), simulate(4)
for step in range(STEPS):
    shown = (one[step].max(axis=-1) > 0.02) | (four[step].max(axis=-1) > 0.02)
    error = float(numpy.mean((one[step] - four[step])[shown] ** 2))
    quality = -10.0 * math.log10(max(error, 1e-12))
    most = round(255.0 * float(numpy.abs(one[step] - four[step]).max()))
    print(f"step {step}: {quality:.1f} dB over drawn pixels, most {most} of 255, drawn {float(shown.mean()):.3f}")
    # ParaView blends the ranks' pictures in 8 bits and cuts what is below: three times here, in a dim picture.
    assert quality >= 47.0 and most <= 4, step
    assert shown.mean() > 0.02, step
# The shell grows.
assert drawn(one[0]) < drawn(one[1]) < drawn(one[2]), [drawn(picture) for picture in one]
