# SPDX-License-Identifier: BSD-3-Clause
"""The charts of Documentation/Evaluation.md. Each takes what evaluation.py loads and derives, and returns a figure,
or None where there is nothing to draw."""

import re

import numpy
from matplotlib.lines import Line2D

import plot
from evaluation import BY_TOLERANCE, MAPPER, MOST_OFF_TOLERANCE, MOST_SAMPLES, TARGET_SCENE

# Of each method: what it is called, colour, marker, line.
LOOKS = {
    "basis, k-d tree": ("basis, k-d tree", plot.BLACK, "o", "-"),
    "basis, ray query": ("basis, ray query", plot.GREY, "o", "-"),
    BY_TOLERANCE: ("basis, by tolerance", plot.BLUE, "s", "-"),
    f"{MAPPER}, by tolerance": ("the mapper, by tolerance", plot.BLUE, "s", "-"),
    MAPPER: ("the mapper, in a window", plot.SKY, "D", "-"),
    "nearest, k-d tree": ("nearest", plot.GREY, "D", "-"),
    "completed, k-d tree": ("completed", plot.ORANGE, "P", "-"),
    "cell location": ("cell location", plot.GREEN, "^", "-"),
    "vtkMultiBlockVolumeMapper, all blocks": ("MultiBlock, all blocks", plot.PURPLE, "X", "--"),
    "vtkMultiBlockVolumeMapper, covered cells blanked": ("MultiBlock, blanked", plot.PURPLE, "v", "--"),
    "vtkAMRVolumeMapper": ("AMR mapper", plot.GREY, "X", "--"),
    "resampled, vtkGPUVolumeRayCastMapper": ("resampled, GPU mapper", plot.VERMILION, "d", "--"),
    "resampled, vtkFixedPointVolumeRayCastMapper": ("resampled, fixed point", plot.ORANGE, "p", "--"),
    "naive walk": ("naive walk", plot.GREY, "x", "-"),
    "native march, k-d tree": ("native march", plot.SKY, "*", "-"),
    "no opacity correction": ("no opacity correction", plot.VERMILION, "X", "--"),
    "midpoint": ("midpoint", plot.ORANGE, "s", "--"),
    "left end": ("left end", plot.PURPLE, "v", "--"),
    "unfitted steps": ("unfitted steps", plot.BLUE, "d", "--"),
    "no skipping": ("no skipping", plot.GREEN, "P", "--"),
    "finest steps": ("finest steps", plot.SKY, "p", "--"),
}
FRAME, PSNR = "frame / ms", "PSNR / dB"


def file_name(scene):
    """Letters, digits and points, "_" for all else."""
    return re.sub(r"[^A-Za-z0-9.]+", "_", scene)


def curve(axes, rows, method, x, y):
    """The method's rows in the order of its parameter. Whether there was anything to draw."""
    rows = rows[rows.method == method].dropna(subset=[x, y]).sort_values("value")
    if rows.empty:
        return False
    name, color, marker, line = LOOKS.get(method, (method, plot.GREY, ".", "-"))
    axes.plot(rows[x], rows[y], color=color, marker=marker, linestyle=line if len(rows) > 1 else "", label=name)
    return True


def main_scene(data):
    """That of the targets; else one with peers, real data if there are."""
    with_peers = data["peers"].dropna(subset=["db"]).scene.unique() if len(data["peers"]) else []
    scenes = data["scenes"][data["scenes"].scene.isin(with_peers)]
    if TARGET_SCENE in set(scenes.scene):
        return TARGET_SCENE
    scenes = scenes.sort_values("group", key=lambda group: group != "data", kind="stable")
    return None if scenes.empty else scenes.scene.iloc[0]


def front(points):
    """Those of (frame time, dB) that no other point beats in both, by more than rounding."""
    best, kept = -numpy.inf, []
    for time, decibels in sorted(points, key=lambda point: (point[0], -point[1])):
        if decibels > best + 0.05:
            best = decibels
            kept.append((time, decibels))
    return kept


def accuracy(data, scene):
    """Frame time against accuracy: ours, cell location, VTK's mappers."""
    rows = data["results"][data["results"].scene == scene]
    is_field = (data["scenes"][data["scenes"].scene == scene].group == "field").any()
    shown = ["basis, k-d tree", BY_TOLERANCE, MAPPER, "nearest, k-d tree", "cell location",
             *rows[rows.role == "peer"].method.unique()]
    if is_field:  # against the integral of the basis, completed levels have no error that says anything
        shown.insert(3, "completed, k-d tree")
    drawn, axes = plot.figure(width=7.4)
    some = rows[rows.method.isin(shown)].dropna(subset=["wall_ms", "psnr"])
    best = front(zip(some.wall_ms, some.psnr))
    axes.plot(*zip(*best) if best else ((), ()), color="#FFE28A", linewidth=9, solid_capstyle="round",
              solid_joinstyle="round", label="nothing beats in both", zorder=1)
    if sum(curve(axes, rows, method, "wall_ms", "psnr") for method in shown) < 2:
        plot.pyplot.close(drawn)
        return None
    plot.logarithmic(axes.xaxis)
    plot.label(axes, scene, FRAME, PSNR)
    plot.legend(axes)
    return drawn


def main(data):
    scene = main_scene(data)
    return accuracy(data, scene) if scene else None


def ablations(data, scene=None):
    """Ours with something taken away: what it costs, and the error against the length of the step."""
    scene = scene or main_scene(data)
    rows = data["results"][data["results"].scene == scene]
    # The naive walk is tens of times slower than all others.
    baselines = [m for m in rows[rows.role == "baseline"].method.unique() if m != "naive walk"]
    if len(baselines) < 3:
        return None
    drawn, (left, right) = plot.figure(columns=2, width=9.2, height=3.7)
    for method in ["basis, k-d tree", "basis, ray query", *baselines]:
        curve(left, rows, method, "wall_ms", "psnr")
    plot.logarithmic(left.xaxis)
    plot.label(left, f"{scene}: cost", FRAME, PSNR)
    # Those that take the samples of the basis, found otherwise, have its errors.
    steps = rows[(rows.parameter == "step scale") & (rows.rmse_own > 0)]
    same = {"native march, k-d tree", "cell location", "finest steps"}
    for method in ["basis, k-d tree", *(m for m in baselines if m not in same)]:
        curve(right, steps, method, "value", "rmse_own")
    basis = steps[steps.method == "basis, k-d tree"]
    plot.order_guide(right, basis.value.tolist(), basis.rmse_own.tolist(), 2, 0.5)
    plot.logarithmic(right.xaxis, None)
    plot.ticks_of_steps(right.xaxis)
    plot.logarithmic(right.yaxis, None)
    plot.label(right, "error against step", "step scale", "RMSE against the integral of the own field")
    handles = {text: line for axes in (left, right) for line, text in zip(*axes.get_legend_handles_labels())}
    plot.legend(right, handles=list(handles.values()))
    return drawn


def peers(data):
    """How much faster ours is at no less accuracy, and what peers cannot reach."""
    table = data["peers"]
    table = table.dropna(subset=["times_less"]) if len(table) else table
    if table.empty:
        return None
    scenes = table.scene.unique()
    drawn, (left, right) = plot.figure(columns=2, width=9.2, height=1.2 + 0.42 * len(scenes), sharey=True)
    methods = table.peer.unique()
    for i, method in enumerate(methods):
        rows = table[table.peer == method]
        name, color, marker, _ = LOOKS.get(method, (method, plot.GREY, ".", "-"))
        place = [list(scenes).index(scene) + 0.16 * (i - 0.5 * (len(methods) - 1)) for scene in rows.scene]
        size = 22 * numpy.where(rows.grid_cells.isna(), 1.5, numpy.log2(rows.grid_cells.fillna(128) / 64))
        for axes, value in ((left, rows.times_less), (right, rows.db_short_of_ours_at_step_1)):
            axes.scatter(value, place, s=size, color=color, marker=marker, label=name, linewidths=0, alpha=0.9)
    left.set_yticks(range(len(scenes)), scenes)
    left.invert_yaxis()
    plot.logarithmic(left.xaxis)
    for axes, even in ((left, 1), (right, 0)):
        axes.axvline(even, color=plot.BLACK, linewidth=0.8)
        axes.grid(axis="y", visible=False)
        for boundary in range(len(scenes) - 1):
            axes.axhline(boundary + 0.5, color="#E2E2E2", linewidth=0.6)
    plot.label(left, "frame time", "of the peer / of ours at no less accuracy")
    plot.label(right, "accuracy", "dB short of ours at step 1")
    handles = [Line2D([], [], linestyle="", marker=LOOKS[m][2], color=LOOKS[m][1], label=LOOKS[m][0]) for m in methods
               if m in LOOKS]
    handles += [Line2D([], [], linestyle="", marker="o", color=plot.GREY, markersize=numpy.sqrt(22 * power),
                       label=f"grid of {64 * 2 ** power}³ cells") for power in (1, 2, 3)]
    plot.legend(right, handles=handles)
    return drawn


GROUPS = {"made": ("made by code", plot.ORANGE, "D"), "stand-in": ("stand-ins", plot.BLUE, "o"),
          "data": ("real data", plot.VERMILION, "s"), "field": ("analytic fields", plot.GREEN, "^"),
          "input": ("input", plot.BLACK, "o")}


def tolerance(data):
    """The error asked for and the one got; and the samples that it takes beside fixed steps."""
    got, taken = data["tolerance"], data["samples"]
    if got.empty:
        return None
    group = data["scenes"].set_index("scene").group
    scenes = taken.scene.unique() if len(taken) else []
    drawn, (left, right) = plot.figure(columns=2, width=9.2, height=max(3.2, 1.0 + 0.23 * len(scenes)))
    ends = numpy.array([got.asked_for.min() / 1.3, got.asked_for.max() * 1.3])
    left.fill_between(ends, ends / MOST_OFF_TOLERANCE, ends * MOST_OFF_TOLERANCE, color="#EFEFEF",
                      label="within a factor of 2")
    left.plot(ends, ends, color=plot.GREY, linewidth=0.8)
    for key, (name, color, marker) in GROUPS.items():
        rows = got[got.scene.map(group) == key]
        if len(rows):
            left.scatter(rows.asked_for, rows.got, s=18, color=color, marker=marker, label=name, alpha=0.8,
                         linewidths=0)
    places = sorted(got.asked_for.unique())
    plot.logarithmic(left.xaxis, None)
    plot.ticks_at(left.xaxis, places, [f"{place:g}" for place in places])
    plot.logarithmic(left.yaxis)
    left.legend(loc="upper left")
    plot.label(left, "error got", "ErrorTolerance", "RMS error over drawn pixels")
    for decibels, color, marker in ((50, plot.BLUE, "o"), (60, plot.ORANGE, "s"), (70, plot.VERMILION, "^")):
        rows = taken[taken.db == decibels] if len(taken) else taken
        if len(rows):
            right.scatter(rows.ratio, [list(scenes).index(scene) for scene in rows.scene], s=22, color=color,
                          marker=marker, label=f"for {decibels} dB", linewidths=0)
    if len(scenes):
        right.set_yticks(range(len(scenes)), scenes)
        right.invert_yaxis()
        right.axvline(1, color=plot.BLACK, linewidth=0.8)
        right.axvline(MOST_SAMPLES, color=plot.GREY, linewidth=0.8, linestyle="--", label="target")
        right.set_xlim(0, 1.08)
        right.legend(loc="upper right")
    plot.label(right, "samples taken", "samples by tolerance / by fixed steps")
    return drawn


def features(data):
    """Time against accuracy of what is not plain, one picture each."""
    table = data["features"]
    shown = [name for name in ("shaded", "isosurface", "maximum", "four components") if name in set(table.feature)]
    if not shown:
        return None
    drawn, grid = plot.figure(len(shown), width=1.2 + 2.5 * len(shown), height=3.1, sharey=True, squeeze=False)
    for axes, feature in zip(grid[0], shown):
        rows = table[table.feature == feature]
        for method in rows.method.unique():
            curve(axes, rows, method, "wall_ms", "db")
        plot.logarithmic(axes.xaxis)
        plot.label(axes, feature, FRAME)
    plot.label(grid[0][0], shown[0], FRAME, PSNR)
    plot.legend(grid[0][-1])
    return drawn


def motion(data):
    """The time allowed for a picture while something moves, and how near it is."""
    table = data["motion"]
    if table.empty:
        return None
    scenes = table.scene.unique()
    drawn, grid = plot.figure(len(scenes), width=1.2 + 2.9 * len(scenes), height=3.1, sharey=True, squeeze=False)
    looks = {MAPPER: (plot.BLACK, "o"), "vtkSmartVolumeMapper, 128^3": (plot.ORANGE, "^"),
             "vtkFixedPointVolumeRayCastMapper, 128^3": (plot.BLUE, "s")}
    for axes, scene in zip(grid[0], scenes):
        for method, lines in table[table.scene == scene].groupby("method", sort=False):
            color, marker = looks[method]
            axes.plot(lines.allowed_ms, lines.db, color=color, marker=marker, label=method)
        axes.set_xscale("log")
        axes.minorticks_off()
        allowed = sorted(table.allowed_ms.unique())
        axes.set_xticks(allowed, [f"{time:.0f}" for time in allowed])
        plot.label(axes, scene, "time allowed / ms")
    plot.label(grid[0][0], scenes[0], "time allowed / ms", PSNR)
    for method, (color, marker) in looks.items():  # all of them beside the last scene, which may lack some
        if method in set(table.method) - set(table[table.scene == scenes[-1]].method):
            grid[0][-1].plot([], [], color=color, marker=marker, label=method)
    plot.legend(grid[0][-1])
    return drawn


def growth(data, rows_of_axes, height):
    """One column for each scene, one row for each group of curves: (unit, [(name, value, colour, marker)])."""
    table = data["growth"]
    if table.empty:
        return None
    scenes = table.scene.unique()
    drawn, grid = plot.figure(len(scenes), len(rows_of_axes), width=1.8 + 2.5 * len(scenes), height=height,
                              sharex=True, sharey="row", squeeze=False)
    for (unit, curves), row in zip(rows_of_axes, grid):
        for axes, scene in zip(row, scenes):
            lines = table[table.scene == scene]
            for name, value, color, marker, style in curves:
                values = value(lines)
                if values.notna().any():
                    axes.plot(lines.leaf_cells, values, color=color, marker=marker, linestyle=style, label=name)
            plot.logarithmic(axes.xaxis, None)
            plot.logarithmic(axes.yaxis, None)
        plot.label(row[0], y=unit)
        plot.legend(row[-1])
    for axes, scene in zip(grid[0], scenes):
        axes.set_title(scene, loc="left")
    for axes in grid[-1]:
        axes.set_xlabel("leaf cells")
    return drawn


def growth_time(data):
    return growth(data, [
        ("frame / ms", [
            ("ray query, step 1", lambda t: t.frame_ray_query_ms, plot.ORANGE, "^", "-"),
            ("k-d tree, step 1", lambda t: t.frame_kd_tree_ms, plot.BLACK, "o", "-"),
            ("tolerance 0.01, all levels", lambda t: t.frame_of_all_levels_ms, plot.SKY, "s", "--"),
            ("tolerance 0.01, levels left out", lambda t: t.frame_by_tolerance_ms, plot.BLUE, "s", "-")]),
        ("set-up / s", [
            ("leaf boxes, bricks, regions", lambda t: t.structure_s, plot.VERMILION, "D", "-"),
            ("values", lambda t: t.gather_s, plot.GREEN, "v", "-"),
            ("value ranges", lambda t: t.ranges_s, plot.PURPLE, "P", "-")])], 5.0)


def growth_memory(data):
    return growth(data, [("memory / MiB", [
        ("host, all", lambda t: t.host_mib, plot.GREY, "o", "--"),
        ("scalars", lambda t: t.scalars_mib, plot.BLACK, "o", "-"),
        ("acceleration structure", lambda t: t.acceleration_mib, plot.ORANGE, "^", "-"),
        ("regions on the host", lambda t: t.regions_host_mib, plot.BLUE, "s", "--"),
        ("regions on the device", lambda t: t.regions_device_mib, plot.BLUE, "s", "-"),
        ("bricks", lambda t: t.bricks_mib, plot.VERMILION, "D", "-")])], 3.1)


def ranks(data):
    """Time and memory of a rank against their number: one column for each scene."""
    table = data["ranks"]
    if table.empty:
        return None
    scenes = table.scene.unique()
    drawn, grid = plot.figure(len(scenes), 2, width=1.8 + 3.0 * len(scenes), height=5.6, sharex=True, sharey="row", squeeze=False)
    times = (("cutting, on each rank", "cut_s", plot.VERMILION, "D"), ("exchange", "exchange_s", plot.GREEN, "v"),
             ("structure", "structure_s", plot.PURPLE, "P"), ("picture, step 1", "picture_s", plot.BLACK, "o"),
             ("compositing", "compositing_s", plot.SKY, "s"))
    memory = (("host", "host_bytes_most", plot.GREY, "o"), ("device", "device_bytes_most", plot.BLUE, "s"),
              ("received", "received_bytes_most", plot.GREEN, "v"))
    for column, scene in enumerate(scenes):
        lines = table[table.scene == scene]
        for name, what, color, marker in times:
            some = lines[lines[what] > 0.0]
            grid[0][column].plot(some.ranks, some[what], color=color, marker=marker, label=name)
        for name, what, color, marker in memory:
            some = lines[lines[what] > 0.0]
            grid[1][column].plot(some.ranks, some[what] / 2.0**20, color=color, marker=marker, label=name)
        first = lines.iloc[0]
        grid[1][column].plot(lines.ranks, first.device_bytes_most / 2.0**20 / lines.ranks, color=plot.BLUE, linestyle=":",
                             label="device, without cells around")
        grid[0][column].set_title(f"{scene}, {first.leaf_cells / 1e6:.0f} million cells", loc="left")
        grid[1][column].set_xlabel("ranks")
        for axes in (grid[0][column], grid[1][column]):
            plot.logarithmic(axes.xaxis, None)
            plot.logarithmic(axes.yaxis, None)
    plot.label(grid[0][0], f"{scenes[0]}, {table.leaf_cells.iloc[0] / 1e6:.0f} million cells", y="time of the slowest / s")
    plot.label(grid[1][0], y="memory of the largest / MiB")
    plot.legend(grid[0][-1])
    plot.legend(grid[1][-1])
    return drawn


PAGE_CHARTS = {"main": main, "features": features, "motion": motion, "ranks": ranks, "peers": peers, "tolerance": tolerance, "ablations": ablations, "growth_time": growth_time,
               "growth_memory": growth_memory}


def charts(data):
    """All that there may be, by the names of their files: of the page, and of single scenes."""
    made = dict(PAGE_CHARTS)
    for scene in data["results"].scene.unique():
        made[f"{file_name(scene)}_accuracy"] = lambda data, scene=scene: accuracy(data, scene)
        made[f"{file_name(scene)}_ablations"] = lambda data, scene=scene: ablations(data, scene)
    return made
