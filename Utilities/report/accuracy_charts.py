# SPDX-License-Identifier: BSD-3-Clause
"""The charts of Documentation/Accuracy.md. Each takes what accuracy.py loads, and returns a figure, or None where
there is nothing to draw."""

import textwrap

import plot

# Colour, marker and line of each reconstruction.
LOOKS = {
    "nearest": (plot.GREY, "D", "-"),
    "basis": (plot.BLACK, "o", "-"),
    "corrected": (plot.ORANGE, "^", "--"),
    "completed beyond bounds": (plot.GREEN, "P", "--"),
    "completed": (plot.BLUE, "s", "-"),
}


def parts(axis, places):
    """Ticks at 1/8, 1/16, ... of a side."""
    plot.logarithmic(axis, None)
    plot.ticks_at(axis, places, [f"1/{1 / place:g}" for place in places])


def reconstruction_error(data):
    """The greatest error of a Gaussian on two levels of ratio 2 against the width of cells."""
    errors = data["reconstruction_errors"]
    errors = errors[(errors.field == "Gaussian") & (errors.ratio == 2)].sort_values("coarse_width")
    if errors.empty:
        return None
    drawn, both = plot.figure(columns=2, width=9.2, height=3.6, sharey=True)
    # Inside a level the others are the basis. Guides of order 1 and 2 go beside the two methods named last.
    zones = (("interior", "inside a level", ("nearest", "basis"), ("nearest", "basis")),
             ("level boundary", "at the level boundary", ("nearest", "basis", "corrected", "completed"),
              ("basis", "completed")))
    for axes, (zone, title, methods, guided) in zip(both, zones):
        of_method = {method: errors[(errors.zone == zone) & (errors.method == method)] for method in methods}
        for method, rows in of_method.items():
            color, marker, line = LOOKS[method]
            if len(rows):
                axes.plot(rows.coarse_width, rows["max"], color=color, marker=marker, linestyle=line, label=method)
        for order, method in enumerate(guided, start=1):
            rows = of_method[method]
            if len(rows):
                plot.order_guide(axes, rows.coarse_width.tolist(), rows["max"].tolist(), order, 0.6)
        parts(axes.xaxis, sorted(errors.coarse_width.unique()))
        plot.logarithmic(axes.yaxis, None)
        plot.label(axes, title, "coarse cell width / side of the domain")
    both[0].set_ylabel("greatest error / range of values")
    plot.legend(both[1])
    return drawn


def linear_field_across_levels(data):
    table = data["level_change"]
    if table.empty:
        return None
    drawn, axes = plot.figure(width=6.8)
    axes.plot([-3, 3], [-3, 3], color=plot.BLACK, linewidth=1, label="exact")
    looks = {("basis", 2): (plot.VERMILION, "-"), ("basis", 3): (plot.BLUE, "--"), ("basis", 4): (plot.ORANGE, "-."),
             ("nearest", 2): (plot.GREY, ":")}
    for (method, ratio), (color, line) in looks.items():
        rows = table[(table.method == method) & (table.ratio == ratio)]
        axes.plot(rows.x, rows.value, color=color, linestyle=line, label=f"{method}, ratio {ratio}")
    axes.axvline(0, color=plot.GREY, linewidth=0.8)
    plot.label(axes, None, "distance from the face / fine cell width (coarse cells on the left)",
               "value / (slope × fine cell width)")
    plot.legend(axes)
    return drawn


def integration_error(data):
    errors = data["integration_errors"].sort_values("step_scale")
    if errors.empty:
        return None
    drawn, axes = plot.figure(width=7.0)
    looks = zip(("X", "d", "s", "o"), (plot.ORANGE, plot.BLUE, plot.VERMILION, plot.BLACK))
    names = sorted(errors.transfer_function.unique(),
                   key=lambda name: -errors[errors.transfer_function == name].opacity_rms.iloc[-1])
    for name, (marker, color) in zip(names, looks):
        rows = errors[errors.transfer_function == name]
        axes.plot(rows.step_scale, rows.opacity_rms, color=color, marker=marker, label=name)
    for name, order, factor in ((names[0], 1, 2.5), (names[-1], 2, 0.6)):
        rows = errors[errors.transfer_function == name]
        plot.order_guide(axes, rows.step_scale.tolist(), rows.opacity_rms.tolist(), order, factor)
    plot.logarithmic(axes.xaxis, None)
    plot.ticks_of_steps(axes.xaxis)
    plot.logarithmic(axes.yaxis, None)
    plot.label(axes, None, "distance of samples / finest cell width near the ray", "RMS error of opacity")
    plot.legend(axes)
    return drawn


def held_error(data):
    """Error over drawn pixels against the step, on each data set: the legend has the order of the lines."""
    held = data["held_error"].sort_values("step_scale")
    if held.empty:
        return None
    drawn, axes = plot.figure(width=7.6, height=4.2)
    names = sorted(held.data.unique(), key=lambda name: held[held.data == name].psnr_drawn.iloc[-1])
    colors = (plot.BLACK, plot.ORANGE, plot.BLUE, plot.VERMILION, plot.GREEN, plot.PURPLE)
    for i, name in enumerate(names):
        rows = held[held.data == name]
        axes.plot(rows.step_scale, 10 ** (-rows.psnr_drawn / 20), color=colors[i % len(colors)],
                  marker="osD^vPXdp*h<"[i % 12], linestyle="-" if i < len(colors) else "--", label=name)
    for step, decibels in ((1.0, 45), (0.25, 60)):
        axes.plot(step, 10 ** (-decibels / 20), color=plot.GREY, marker="_", markersize=18, markeredgewidth=2.5,
                  linestyle="", label="goals" if step == 1.0 else None)
    plot.logarithmic(axes.xaxis, None)
    plot.ticks_of_steps(axes.xaxis)
    plot.logarithmic(axes.yaxis, None)
    plot.label(axes, None, "step scale: distance of samples / finest cell width near the ray",
               "RMS error over drawn pixels")
    plot.legend(axes)
    return drawn


def pictures(data):
    """PSNR of pictures against that of the analytic field, by resolution: fields across, transfer functions down."""
    table = data["picture_errors"]
    if table.empty:
        return None
    fields, transfers = table.field.unique(), table.transfer_function.unique()
    drawn, grid = plot.figure(len(fields), len(transfers), width=1.8 + 2.6 * len(fields), height=2.6 * len(transfers),
                              sharex="col", sharey="row", squeeze=False)
    for transfer, row in zip(transfers, grid):
        for field, axes in zip(fields, row):
            rows = table[(table.field == field) & (table.transfer_function == transfer)].sort_values("finest_width")
            for method, (color, marker, line) in LOOKS.items():
                points = rows[rows.method == method]
                axes.plot(points.finest_width, points.psnr, color=color, marker=marker, linestyle=line, label=method)
            parts(axes.xaxis, sorted(rows.finest_width.unique()))
            axes.margins(x=0.12)
        row[0].set_ylabel(f"{transfer}: PSNR / dB")
    for field, axes in zip(fields, grid[0]):
        axes.set_title("\n".join(textwrap.wrap(field, 28)), loc="left")
    drawn.supxlabel("finest cell width / side of the domain", fontsize="medium")
    plot.legend(grid[0][-1])
    return drawn


def charts(_):
    """How each chart is drawn, by the name of its file."""
    return {f.__name__: f for f in (reconstruction_error, linear_field_across_levels, integration_error, held_error,
                                    pictures)}
