# SPDX-License-Identifier: BSD-3-Clause
"""How all charts look. Colours are those of Okabe and Ito (2008), which can be told apart with any eyes;
series differ in marker and line too."""

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot, ticker  # noqa: E402, after the choice of what draws

BLACK, ORANGE, SKY, GREEN = "#000000", "#E69F00", "#56B4E9", "#009E73"
BLUE, VERMILION, PURPLE, GREY = "#0072B2", "#D55E00", "#CC79A7", "#8A8A8A"

pyplot.rcParams.update({
    "figure.dpi": 160,
    "figure.constrained_layout.use": True,
    "font.size": 9,
    "axes.titlesize": 9.5,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#E2E2E2",
    "grid.linewidth": 0.6,
    "lines.linewidth": 1.5,
    "lines.markersize": 5,
    "legend.frameon": False,
    "legend.handlelength": 2.4,
})


def figure(columns=1, rows=1, width=6.4, height=3.9, **options):
    """A figure and its axes."""
    return pyplot.subplots(rows, columns, figsize=(width, height), **options)


def label(axes, title=None, x=None, y=None):
    axes.set_title(title or "", loc="left")
    if x:
        axes.set_xlabel(x)
    if y:
        axes.set_ylabel(y)


def logarithmic(axis, digits=(1, 2, 5), form="{x:g}"):
    """Ticks at these digits of each decade, written out; `digits` None: at powers of ten."""
    axis.axes.set(**{f"{axis.axis_name}scale": "log"})
    if digits:
        axis.set_major_locator(ticker.LogLocator(subs=digits, numticks=20))
        axis.set_major_formatter(ticker.StrMethodFormatter(form))
    axis.set_minor_locator(ticker.LogLocator(subs=range(2, 10), numticks=20))
    axis.set_minor_formatter(ticker.NullFormatter())


def ticks_at(axis, places, texts):
    axis.set_major_locator(ticker.FixedLocator(places))
    axis.set_major_formatter(ticker.FixedFormatter(texts))
    axis.set_minor_locator(ticker.NullLocator())


def ticks_of_steps(axis):
    """Powers of two, of a logarithmic axis of step scales."""
    places = [2.0 ** power for power in range(-4, 5)]
    limits = axis.get_view_interval()
    ticks_at(axis, places, [f"{place:g}" for place in places])
    axis.set_view_interval(*limits, ignore=True)


def legend(axes, **options):
    """Right of the axes."""
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), **options)


def order_guide(axes, x, y, order, factor):
    """A line c x^order beside the measured points (x, y), through `factor` times that of the greatest x."""
    last = max(range(len(x)), key=lambda i: x[i])
    ends = [min(x), x[last]]
    axes.plot(ends, [factor * y[last] * (end / x[last]) ** order for end in ends], color=GREY, linewidth=1,
              linestyle="--" if order == 1 else ":", label=f"order {order}")


def save(drawn, path):
    """Whole or not at all, and the same bytes for the same numbers."""
    part = path.with_name("." + path.name + ".part")
    drawn.savefig(part, format="png", metadata={"Software": None})
    part.replace(path)
    pyplot.close(drawn)
