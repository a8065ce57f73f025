#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the tables and charts of what was measured, from its CSV files.

    python3 Utilities/report <folder> [<page>]

<folder> holds what exabricks-benchmark --output wrote, or the accuracy programs (Utilities/accuracy). Without a page all
there is to draw goes to <folder>, with report.md, which shows it. With a page (Documentation/Evaluation.md) its tables
are put in anew, between the lines <!-- table: NAME --> and <!-- end -->, and its charts and the CSV files go into the
folder of its name beside it (Documentation/Evaluation).

Takes Debian's python3-pandas and python3-matplotlib.
"""

import pathlib
import shutil
import sys


def subject_of(folder):
    """The modules that know what was measured there, and its charts."""
    import accuracy
    import accuracy_charts
    import evaluation
    import evaluation_charts
    from page import InputError

    for subject, charts in ((evaluation, evaluation_charts), (accuracy, accuracy_charts)):
        if (folder / subject.MEASURED[0]).exists():
            return subject, charts
    raise InputError(f"'{folder}' holds neither {evaluation.MEASURED[0]}, which {evaluation.MADE_BY} writes, nor "
                     f"{accuracy.MEASURED[0]}, which {accuracy.MADE_BY} writes.")


def none(_):
    """Draws a chart that is not known."""


def report(folder, page=None):
    import plot
    from page import InputError, charts_of, compose, splice, tables_of

    subject, drawing = subject_of(folder)
    data = subject.load(folder)
    derived = {name: derive(data) for name, derive in subject.DERIVED.items()}
    data.update(derived)
    tables = {name: text for name, make in subject.TABLES.items() if (text := make(data))}
    makers = drawing.charts(data)

    if page is None:
        target, path = folder, folder / "report.md"
        charts = {name: chart for name, make in makers.items() if (chart := make(data))}
        text = compose(folder.resolve().name, tables, charts)
    else:
        target, path = page.with_suffix(""), page
        text = page.read_text(encoding="utf-8")
        charts = {name: chart for name in charts_of(text, target.name) if (chart := makers.get(name, none)(data))}
        missing = sorted(set(charts_of(text, target.name)) - set(charts) | set(tables_of(text)) - set(tables))
        if missing:
            raise InputError(f"'{page}' shows {', '.join(missing)}, which was not measured: that takes a folder of AMR "
                             "data. The page is left as it was.")
        text = splice(text, tables)

    target.mkdir(exist_ok=True)
    if target.resolve() != folder.resolve():
        for name in subject.MEASURED:
            (target / name).unlink(missing_ok=True)
            if (folder / name).exists():
                shutil.copyfile(folder / name, target / name)
    for name, table in derived.items():
        (target / f"{name}.csv").unlink(missing_ok=True)
        if len(table):
            table.to_csv(target / f"{name}.csv", index=False, float_format="%.6g")
    for name, chart in charts.items():
        plot.save(chart, target / f"{name}.png")
    path.write_text(text, encoding="utf-8")
    print(f"report: {path}, {len(tables)} tables, {len(charts)} charts")


def main():
    arguments = sys.argv[1:]
    if arguments in (["-h"], ["--help"]):
        print(__doc__.strip())
        return
    if len(arguments) not in (1, 2) or arguments[0].startswith("-"):
        sys.exit(__doc__.strip())
    try:
        import matplotlib  # noqa: F401, to say what is missing
        import pandas  # noqa: F401
    except ImportError as error:
        sys.exit(f"report: {error}. Install Debian's python3-pandas and python3-matplotlib (Utilities/setup evaluation).")
    from page import InputError
    try:
        report(*map(pathlib.Path, arguments))
    except (InputError, OSError) as error:
        sys.exit(f"report: {error}")


if __name__ == "__main__":
    main()
