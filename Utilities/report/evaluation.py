# SPDX-License-Identifier: BSD-3-Clause
"""What exabricks-benchmark measured: numbers that follow from it, and the tables of Documentation/Evaluation.md."""

import pathlib

import numpy
import pandas

from page import markdown, milliseconds, number, read_csv, span, three_digits

MADE_BY = "exabricks-benchmark --quick --output <folder>"
MEASURED = ("results.csv", "scenes.csv", "growth.csv", "changes.csv", "machine.csv", "features.csv", "motion.csv",
            "ranks.csv")

# What the renderer was asked to reach.
TARGET_SCENE = "rt_medium magvort, scene"
LEAST_DECIBELS = 51
PEER_TO_BEAT = ("resampled, vtkFixedPointVolumeRayCastMapper", 128)
MOST_OF_PEER = 0.8
MOST_OF_NATIVE = 2.0
MOST_OFF_TOLERANCE = 2.0
MOST_SAMPLES = 0.5

DEFAULT_STEP = 1.0
MAPPER = "vtkExaBricksVolumeMapper"
BY_TOLERANCE, OF_ALL_LEVELS = "basis, by tolerance", "by tolerance, all levels"
RANKS_TOLD = (1, 8, 64, 512, 4096)
MB = 1.048576  # of a MiB: the source writes memory in units of 10^6 bytes


def load(folder):
    """The measured tables, by the names of their files; empty where nothing was measured."""
    data = {
        "results": read_csv(folder, "results.csv", [
            "scene", "method", "role", "parameter", "note", "value", "wall_ms", "cpu_ms", "psnr",
            "psnr_rgba_drawn", "rmse_own", "samples"], made_by=MADE_BY),
        "changes": read_csv(folder, "changes.csv", ["scene", "change", "traversal", "total_ms", "kept"]),
        "machine": read_csv(folder, "machine.csv", ["name", "value"]),
        "features": read_csv(folder, "features.csv", ["feature", "method", "value", "wall_ms", "cpu_ms", "db"]),
        "motion": read_csv(folder, "motion.csv", [
            "scene", "method", "allowed_ms", "taken_ms", "cpu_ms", "taken_of_allowed", "least", "most", "db", "distance", "growth", "levels"]),
        "ranks": read_csv(folder, "ranks.csv", [
            "scene", "leaf_cells", "blocks", "ranks", "drawn_most", "drawn_mean", "held_most", "host_bytes_most",
            "device_bytes_most", "received_bytes_most", "cut_s", "exchange_s", "structure_s", "picture_s",
            "compositing_s"]),
    }
    for name in ("scenes", "growth"):
        data[name] = read_csv(folder, f"{name}.csv", [
            "scene", "group", "levels", "leaf_cells", "bricks", "regions", "active_regions", "structure_s", "gather_s",
            "ranges_s", "scalars_mib", "bricks_mib", "regions_device_mib", "regions_host_mib", "acceleration_mib",
            "surface_mib", "total_kd_tree_mib", "total_ray_query_mib", "host_mib", "frame_kd_tree_ms",
            "frame_ray_query_ms", "frame_by_tolerance_ms", "frame_of_all_levels_ms"])
    # The two tables of the method's source, and what ours are to reach. Their unit of time is not given.
    data["source"] = pandas.read_csv(pathlib.Path(__file__).with_name("wald2020.csv"))
    return data


# ---------------------------------------------------------------------------------------------------------------------
# Numbers that follow from what was measured. All return tables, which are written as CSV too.

def default_row(rows):
    """Of a scene's rows what a user gets who sets nothing: the faster traversal of the basis. None if there is none."""
    rows = rows[(rows.role == "ours") & rows.method.str.startswith("basis,") & (rows.value == DEFAULT_STEP)]
    return None if rows.empty else rows.loc[rows.wall_ms.idxmin()]


def peers(data):
    """Each peer beside the fastest of ours that is no further from the reference than it is."""
    lines = []
    for scene, rows in data["results"].groupby("scene", sort=False):
        ours = rows[(rows.role == "ours") & rows.psnr.notna()]
        # In a window, as its peers are; without it, the renderer alone.
        ours = ours[ours.method == MAPPER] if (ours.method == MAPPER).any() else ours
        at_default = ours[ours.value == DEFAULT_STEP].psnr
        for _, peer in rows[rows.role == "peer"].iterrows():
            near = ours[ours.psnr >= peer.psnr]
            best = near.loc[near.wall_ms.idxmin()] if len(near) else pandas.Series(dtype=float)
            lines.append({
                "scene": scene, "peer": peer.method, "grid_cells": peer.value, "frame_ms": peer.wall_ms,
                "db": peer.psnr, "ours": best.get("parameter"), "ours_value": best.get("value"), "ours_frame_ms": best.get("wall_ms"),
                "ours_db": best.get("psnr"), "times_less": peer.wall_ms / best.get("wall_ms", numpy.nan),
                "db_short_of_ours_at_step_1": (at_default.iloc[0] if len(at_default) else numpy.nan) - peer.psnr,
                "note": peer.note})
    return pandas.DataFrame(lines)


def frame_target(data):
    """Ours, accurate enough, beside the peer to beat, on the scene that was asked for."""
    rows = data["results"][data["results"].scene == TARGET_SCENE]
    peer = rows[(rows.method == PEER_TO_BEAT[0]) & (rows.value == PEER_TO_BEAT[1])]
    rows = rows[(rows.method.str.startswith("basis,") | (rows.method == MAPPER)) & (rows.psnr >= LEAST_DECIBELS)]
    if peer.empty or rows.empty:
        return pandas.DataFrame()
    best = rows.loc[rows.groupby("method", sort=False).wall_ms.idxmin()]
    peer = peer.iloc[0]
    return pandas.DataFrame({
        "ours": best.method, "parameter": best.parameter, "value": best.value, "db": best.psnr,
        "frame_ms": best.wall_ms, "peer_frame_ms": peer.wall_ms, "peer_db": peer.psnr, "ratio": best.wall_ms / peer.wall_ms})


def native(data):
    """Processor time of ours beside that of the same march as native code."""
    rows = data["results"][data["results"].value == DEFAULT_STEP]
    columns = ["scene", "cpu_ms", "wall_ms"]
    both = pandas.merge(rows[rows.method == "basis, k-d tree"][columns],
                        rows[rows.method == "native march, k-d tree"][columns], on="scene", suffixes=("", "_native"))
    both.insert(3, "ratio", both.cpu_ms / both.cpu_ms_native)
    return both


def samples(data):
    """Samples for the same accuracy by fixed steps and by an error tolerance."""
    def samples_at(rows, decibels):  # between the two values of the parameter around it
        rows = rows[rows.samples > 0].sort_values("psnr")
        if rows.empty or not rows.psnr.iloc[0] <= decibels <= rows.psnr.iloc[-1]:
            return numpy.nan
        return numpy.exp(numpy.interp(decibels, rows.psnr, numpy.log(rows.samples)))

    lines = []
    for scene, rows in data["results"].groupby("scene", sort=False):
        for decibels in (50, 60, 70):
            fixed = samples_at(rows[rows.method == "basis, k-d tree"], decibels)
            chosen = samples_at(rows[rows.method == BY_TOLERANCE], decibels)
            lines.append({"scene": scene, "db": decibels, "fixed_steps": fixed, "by_tolerance": chosen,
                          "ratio": chosen / fixed})
    return pandas.DataFrame(lines).dropna()


def tolerance(data):
    """The error that was asked for and the one got, over the drawn pixels."""
    rows = data["results"][data["results"].method == BY_TOLERANCE].dropna(subset=["psnr_rgba_drawn"])
    got = 10 ** (-rows.psnr_rgba_drawn / 20)
    return pandas.DataFrame({"scene": rows.scene, "asked_for": rows.value, "got": got, "ratio": got / rows.value})


def levels(data):
    """What finest levels left out save, where that saves samples."""
    columns = ["scene", "value", "cpu_ms", "samples", "psnr_rgba_drawn"]
    results = data["results"]
    both = pandas.merge(results[results.method == OF_ALL_LEVELS][columns],
                        results[results.method == BY_TOLERANCE][columns],
                        on=["scene", "value"], suffixes=("_all_levels", "_some_left_out"))
    # Estimates that begin at another level may end at another step: a few samples say nothing.
    both = both[both.samples_some_left_out < 0.9 * both.samples_all_levels]
    return both.assign(cpu_ratio=both.cpu_ms_some_left_out / both.cpu_ms_all_levels)


def orders(data):
    """Order of convergence against the integral of the method's own reconstruction: a slope of logarithms."""
    lines = []
    rows = data["results"]
    rows = rows[(rows.parameter == "step scale") & (rows.rmse_own > 0)]
    for (scene, method), steps in rows.groupby(["scene", "method"], sort=False):
        if len(steps) >= 3:
            slope = numpy.polyfit(numpy.log(steps.value), numpy.log(steps.rmse_own), 1)[0]
            lines.append({"scene": scene, "method": method, "rmse_at_longest": steps.loc[steps.value.idxmax()].rmse_own,
                          "rmse_at_shortest": steps.loc[steps.value.idxmin()].rmse_own, "order": slope})
    return pandas.DataFrame(lines)


def source_times(data):
    """A frame by cell location and by regions: theirs, ours, and the ratio that ours is to reach."""
    lines = []
    for _, source in data["source"].iterrows():
        rows = data["results"][data["results"].scene == source.scene]
        regions = default_row(rows)
        location = rows[rows.method.str.startswith("cell location") & (rows.value == DEFAULT_STEP)]
        if regions is not None and len(location):
            lines.append({
                "scene": source.scene, "source_cell_location": source.cell_location, "source_regions": source.regions,
                "source_ratio": source.cell_location / source.regions, "cell_location_ms": location.iloc[0].wall_ms,
                "regions_ms": regions.wall_ms, "ratio": location.iloc[0].wall_ms / regions.wall_ms,
                "target": source.least_time_ratio})
    return pandas.DataFrame(lines)


def source_memory(data):
    """Theirs, ours (in MB too), and the ratio of regions to scalars that ours is to keep to."""
    both = pandas.merge(data["source"].dropna(subset=["scalars_mb"]), data["scenes"], on="scene")
    return pandas.DataFrame({
        "scene": both.scene, "source_scalars_mb": both.scalars_mb, "source_bricks_mb": both.bricks_mb,
        "source_regions_mb": both.regions_mb, "source_total_mb": both.total_mb,
        "source_ratio": both.regions_mb / both.scalars_mb,
        "scalars_mb": MB * both.scalars_mib, "bricks_mb": MB * both.bricks_mib,
        "regions_host_mb": MB * both.regions_host_mib, "regions_device_mb": MB * both.regions_device_mib,
        "acceleration_mb": MB * both.acceleration_mib, "surface_mb": MB * both.surface_mib,
        "total_mb": MB * both.total_ray_query_mib, "ratio": both.regions_device_mib / both.scalars_mib,
        "ratio_on_host": both.regions_host_mib / both.scalars_mib, "target": both.most_memory_ratio})


def feature_costs(data):
    """What each thing that can be set costs: ours beside a plain picture, and beside the mappers of a resampled grid."""
    lines, plain = [], None
    for feature, rows in data["features"].groupby("feature", sort=False):
        default = rows[(rows.method == MAPPER) & (rows.value == DEFAULT_STEP)].iloc[0]
        ours = rows[rows.method.str.startswith(MAPPER)]  # by tolerance too
        plain = default.cpu_ms if plain is None else plain
        line = {"feature": feature, "wall_ms": default.wall_ms, "cpu_ms": default.cpu_ms, "db": default.db,
                "of_plain": default.cpu_ms / plain}
        for name, method in (("gpu", "resampled, vtkGPUVolumeRayCastMapper"), ("fixed_point", PEER_TO_BEAT[0])):
            peer = rows[rows.method == method]
            if len(peer):
                near = ours[ours.db >= peer.db.iloc[0]]
                line |= {f"{name}_ms": peer.wall_ms.iloc[0], f"{name}_db": peer.db.iloc[0],
                         f"of_{name}": (near.wall_ms.min() if len(near) else numpy.nan) / peer.wall_ms.iloc[0]}
        lines.append(line)
    return pandas.DataFrame(lines)


DERIVED = {f.__name__: f for f in (peers, frame_target, native, samples, tolerance, levels, orders, source_times,
                                   source_memory, feature_costs)}


# ---------------------------------------------------------------------------------------------------------------------
# Tables of the page, from the measured and the derived ones. None where nothing was measured.

def machine_table(data):
    lines = data["machine"].values.tolist()
    return markdown(["machine", ""], lines) if lines else None


def scenes_table(data):
    rows = [[s.scene, f"{s.levels:.0f}", f"{s.leaf_cells:.0f}", f"{s.bricks:.0f}",
             three_digits(s.leaf_cells / s.bricks), f"{s.regions:.0f}", f"{s.active_regions:.0f}", number(1e3 * s.structure_s, ".1f"),
             number(1e3 * (s.gather_s + s.ranges_s), ".1f"), number(s.total_kd_tree_mib, ".1f"),
             number(s.total_ray_query_mib, ".1f")] for s in data["scenes"].itertuples()]
    return markdown(["scene", "levels", "leaf cells", "bricks", "cells per brick", "regions", "of them active",
                     "structure, ms", "values and ranges, ms", "device MiB, k-d tree", "ray query"],
                    rows) if rows else None


def peers_table(data):
    if data["peers"].empty:
        return None
    rows = []
    for (peer, grid), lines in data["peers"].groupby(["peer", "grid_cells"], sort=False, dropna=False):
        drawn = lines.dropna(subset=["times_less"])
        if len(drawn):
            rows.append([peer, number(grid, "g") if grid == grid else "", str(len(drawn)),
                         number(drawn.times_less.median(), ".1f"), span(drawn.times_less, ".1f"),
                         span(drawn.db, ".1f"), span(drawn.db_short_of_ours_at_step_1, ".1f")])
    return markdown(["peer", "grid cells", "scenes", "ours: times less, median", "least to most", "dB of the peer",
                     "dB short of ours at step 1"], rows)


def verdict(kept):
    """Of a series of truths."""
    return "kept" if kept.all() else "missed" if not kept.any() else f"kept on {kept.sum()} of {len(kept)}"


def targets_table(data):
    rows = []

    def row(name, what, target, is_kept, measured):
        if not data[name].empty:
            rows.append([what, target, measured(data[name]), verdict(is_kept(data[name]))])

    def frame(table):
        best = table.loc[table.ratio.idxmin()]
        return (f"{best.ratio:.2f}: {milliseconds(best.frame_ms)} ms and {best.db:.1f} dB, "
                f"it {milliseconds(best.peer_frame_ms)} ms and {best.peer_db:.1f} dB")

    row("frame_target", f"frame of *{TARGET_SCENE}* with {LEAST_DECIBELS} dB or more, of the time that the fixed-point "
        "mapper takes on a grid of 128³", f"at most {MOST_OF_PEER:g}", lambda t: t.ratio <= MOST_OF_PEER, frame)
    row("native", "processor time at step 1, k-d tree, of that of the same march as native code",
        f"at most {MOST_OF_NATIVE:g}", lambda t: t.ratio <= MOST_OF_NATIVE, lambda t: span(t.ratio, ".2f"))
    row("samples", "samples by tolerance for 50, 60 and 70 dB, of those of fixed steps", f"at most {MOST_SAMPLES:g}",
        lambda t: t.ratio <= MOST_SAMPLES, lambda t: span(t.ratio, ".2f"))
    row("tolerance", "error got, of the one asked for", f"at most {MOST_OFF_TOLERANCE:g}",
        lambda t: t.ratio <= MOST_OFF_TOLERANCE, lambda t: span(t.ratio, ".2f"))
    row("source_times", "frame by cell location, of that by regions",
        "at least " + span(data["source"].least_time_ratio, "g"),
        lambda t: t.ratio >= t.target, lambda t: span(t.ratio, ".1f"))
    row("source_memory", "memory of regions on the device, of that of scalars",
        "at most " + span(data["source"].most_memory_ratio, "g"),
        lambda t: t.ratio <= t.target, lambda t: span(t.ratio, ".2g"))
    return markdown(["asked for", "target", "measured", ""], rows) if rows else None


def source_times_table(data):
    rows = [[s.scene, f"{s.source_cell_location:g}", f"{s.source_regions:g}", f"{s.source_ratio:.1f}",
             milliseconds(s.cell_location_ms), milliseconds(s.regions_ms), f"{s.ratio:.1f}", f"{s.target:.1f}",
             "kept" if s.ratio >= s.target else "missed"] for s in data["source_times"].itertuples()]
    return markdown(["scene", "source: cell location", "source: regions", "source: ratio", "ours: cell location, ms",
                     "ours: regions, ms", "ours: ratio", "target, at least", ""], rows) if rows else None


def source_memory_table(data):
    rows = []
    for s in data["source_memory"].itertuples():
        rows.append([s.scene, "source", f"{s.source_scalars_mb:g}", f"{s.source_bricks_mb:g}", "",
                     f"{s.source_regions_mb:g}", "", "", f"{s.source_total_mb:g}", f"{s.source_ratio:.2g}", "", ""])
        ours = (s.scalars_mb, s.bricks_mb, s.regions_host_mb, s.regions_device_mb, s.acceleration_mb, s.surface_mb,
                s.total_mb)
        rows.append(["", "ours", *map(three_digits, ours), f"{s.ratio:.2g}", f"{s.target:g}",
                     "kept" if s.ratio <= s.target else "missed"])
    return markdown(["scene", "", "scalars MB", "bricks MB", "regions on the host MB", "regions on the device MB",
                     "acceleration structure MB", "surface MB", "total MB", "regions / scalars, device",
                     "target, at most", ""], rows) if rows else None


def changes_table(data):
    changes, rows = data["changes"], []
    traversals = changes.traversal.unique()
    for change, lines in changes.groupby("change", sort=False):
        kept = ", ".join(dict.fromkeys(" ".join(lines.kept.dropna()).split()))
        row = [change]
        for traversal in traversals:
            times = lines[lines.traversal == traversal].total_ms
            row += [milliseconds(times.median()), f"{milliseconds(times.min())} to {milliseconds(times.max())}"]
        rows.append([*row, kept])
    header = ["change", *(text for way in traversals for text in (f"{way}, ms: median", "least to most")), "kept"]
    return markdown(header, rows) if rows else None


def features_table(data):
    def both(time, decibels):
        return f"{milliseconds(time)}, {decibels:.1f}" if time == time else "has none"

    def ratio(value):
        return f"{value:.2f}" if value == value else ""

    rows = [[s.feature, f"{milliseconds(s.wall_ms)}, {s.db:.1f}" if s.db < 100 else f"{milliseconds(s.wall_ms)}, exact",
             f"{s.of_plain:.2f}", both(s.gpu_ms, s.gpu_db), ratio(s.of_gpu), both(s.fixed_point_ms, s.fixed_point_db),
             ratio(s.of_fixed_point)] for s in data["feature_costs"].itertuples()]
    return markdown(["", "ours at step 1: ms, dB", "processor time, of plain", "GPU mapper, 128³: ms, dB",
                     "ours, no less accurate, of it", "fixed point, 128³: ms, dB", "ours, no less accurate, of it"],
                    rows) if rows else None


def motion_table(data):
    """How long pictures take of the time allowed, and how near they are, for each time allowed."""
    table = data["motion"]
    allowed = sorted(table.allowed_ms.unique(), reverse=True)
    rows = []
    for (scene, method), lines in table.groupby(["scene", "method"], sort=False):
        lines = lines.set_index("allowed_ms")
        cells = [f"{lines.taken_of_allowed[time]:.2f} ({lines.least[time]:.2f} to {lines.most[time]:.2f}), {lines.db[time]:.1f}"
                 if time in lines.index else "" for time in allowed]
        rows.append([scene, method, *cells])
    return markdown(["", "", *(f"{time:.0f} ms" for time in allowed)], rows) if rows else None


def ranks_table(data):
    """What several ranks cost, for some numbers of them."""
    def mebibytes(count):
        return three_digits(count / 2.0**20)

    table = data["ranks"]
    if table.empty:
        return None
    rows = [[s.scene, s.ranks, f"{s.drawn_most / 1e6:.3g}", f"{s.held_most / s.drawn_most:.2f}", mebibytes(s.host_bytes_most),
             mebibytes(s.device_bytes_most), mebibytes(s.received_bytes_most), *(f"{seconds:.2g}" for seconds in (
                 s.cut_s, s.exchange_s, s.structure_s, s.picture_s, s.compositing_s))]
            for s in table[table.ranks.isin(RANKS_TOLD)].itertuples()]
    return markdown(["scene", "ranks", "10⁶ cells to draw, most", "cells held, of them", "host MiB", "device MiB", "received MiB",
                     "seconds: cut", "exchange", "structure", "picture", "compositing"], rows)


TABLES = {"features": features_table, "motion": motion_table, "ranks": ranks_table, "machine": machine_table, "scenes": scenes_table, "targets": targets_table, "peers": peers_table,
          "source_times": source_times_table, "source_memory": source_memory_table, "changes": changes_table}
