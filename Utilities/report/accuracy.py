# SPDX-License-Identifier: BSD-3-Clause
"""What the accuracy programs measured: orders of convergence, and the tables of Documentation/Accuracy.md."""

import numpy
import pandas

from page import markdown, number, read_csv

MADE_BY = "AccuracyTable <folder>"
MEASURED = ("reconstruction_errors.csv", "level_change.csv", "integration_errors.csv", "picture_errors.csv",
            "held_error.csv", "stability.csv")

# Columns of stability.csv, and what they are called.
WAYS = {"basis_kd_db": "basis k-d", "basis_rq_db": "basis ray query", "nearest_kd_db": "nearest k-d",
        "nearest_rq_db": "nearest ray query"}
PEERS = {"multiblock": "VTK MultiBlock", "resampled": "VTK resampled", "amr": "VTK AMR"}


def load(folder):
    """The measured tables, by the names of their files; empty where nothing was measured."""
    return {
        "reconstruction_errors": read_csv(folder, "reconstruction_errors.csv", [
            "field", "ratio", "method", "zone", "coarse_width", "max", "rms"], made_by=MADE_BY),
        "level_change": read_csv(folder, "level_change.csv", ["method", "ratio", "x", "value"]),
        "integration_errors": read_csv(folder, "integration_errors.csv", [
            "transfer_function", "step_scale", "opacity_rms", "colour_rms"]),
        "picture_errors": read_csv(folder, "picture_errors.csv", [
            "field", "transfer_function", "method", "finest_width", "psnr"]),
        "held_error": read_csv(folder, "held_error.csv", ["data", "traversal", "step_scale", "psnr", "psnr_drawn"])
                      .query("traversal == 'k-d tree'"),
        "stability": read_csv(folder, "stability.csv", ["case", "elsewhere", *WAYS]),
    }


def slope(x, y):
    """Order p of errors y = c x^p: the slope of the line that fits their logarithms best."""
    return numpy.polyfit(numpy.log(x), numpy.log(y), 1)[0]


def reconstruction_orders(data):
    """Observed orders of the greatest and of the RMS error against the width of cells."""
    errors = data["reconstruction_errors"]
    errors = errors[(errors["max"] > 0) & (errors.rms > 0)]
    return pandas.DataFrame([
        {"field": field, "ratio": ratio, "method": method, "zone": zone,
         "order_max": slope(rows.coarse_width, rows["max"]), "order_rms": slope(rows.coarse_width, rows.rms)}
        for (field, ratio, method, zone), rows in errors.groupby(["field", "ratio", "method", "zone"], sort=False)])


def integration_orders(data):
    """Observed orders of opacity and colour against the distance of samples."""
    return pandas.DataFrame([
        {"transfer_function": name, "order_opacity": slope(rows.step_scale, rows.opacity_rms),
         "order_colour": slope(rows.step_scale, rows.colour_rms)}
        for name, rows in data["integration_errors"].groupby("transfer_function", sort=False)])


DERIVED = {"reconstruction_orders": reconstruction_orders, "integration_orders": integration_orders}


def held_error_table(data):
    """Over all pixels on the left, over drawn ones on the right, from the longest step to the shortest."""
    held = data["held_error"]
    steps = sorted(held.step_scale.unique(), reverse=True)
    rows = []
    for name in held.data.unique():
        line = held[held.data == name].set_index("step_scale")
        values = [line[column].get(step) for column in ("psnr", "psnr_drawn") for step in steps]
        rows.append([name, *(number(value, ".1f") for value in values)])
    return markdown(["data", *(f"{step:g}" for step in [*steps, *steps])], rows) if rows else None


def stability_table(data):
    def decibels(value):  # or words
        try:
            return f"{float(value):.1f}"
        except ValueError:
            return value

    table = data["stability"]
    ways = {**WAYS, **{column: name for column, name in PEERS.items() if column in table}}
    rows = [[row["case"], row["elsewhere"], *(decibels(row[way]) for way in ways)] for _, row in table.iterrows()]
    return markdown(["case", "what fails elsewhere", *ways.values()], rows) if rows else None


TABLES = {"held_error": held_error_table, "stability": stability_table}
