# SPDX-License-Identifier: BSD-3-Clause
"""While something moves, pictures are drawn in the time allowed, with fewer rays; then the whole one is the same again."""

import time

from Support import *

load_plugin()
collector = Collector()
scene = make_scene()
view = make_view(400, 300)
display = show(scene, view)
look_at(scene, view)
display.OpacityUnitDistance = 8.0
display.StepScale = 0.01  # so slow that no machine has the time
simple.Render(view)
still = picture(view, "still")
assert "a ray in" not in statistics(display), statistics(display)


def taken(draw):
    begin = time.perf_counter()
    draw()
    return time.perf_counter() - begin


whole = min(taken(view.SMProxy.StillRender) for _ in range(2))
view.SMProxy.InteractiveRender()
moving = min(taken(view.SMProxy.InteractiveRender) for _ in range(3))
print(f"still {whole:.3f} s, moving {moving:.3f} s: {statistics(display)}")
assert "a ray in" in statistics(display), statistics(display)
assert moving < 0.5 * whole, (moving, whole)
expect_alike(picture(view, "stillAgain"), still, 200.0, "still again")
collector.expect_silence()
