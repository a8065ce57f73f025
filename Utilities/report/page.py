# SPDX-License-Identifier: BSD-3-Clause
"""CSV files in; Markdown tables, and pages that hold them, out."""

import re

import pandas


class InputError(Exception):
    """What was expected of the input, what was found, and what to do."""


def read_csv(folder, name, columns, made_by=None):
    """The table <folder>/<name>. Empty if the file is not there, unless `made_by` says what writes it."""
    path = folder / name
    if not path.exists():
        if made_by:
            raise InputError(f"'{folder}' has no {name}. Measure first: {made_by}")
        return pandas.DataFrame(columns=columns)
    try:
        table = pandas.read_csv(path)
    except (ValueError, OSError) as error:  # the parser's own errors are ValueErrors
        raise InputError(f"'{path}' is no CSV file: {error}") from error
    missing = [column for column in columns if column not in table]
    if missing:
        raise InputError(f"'{path}' has no column {', '.join(missing)}; found {', '.join(table.columns)}. "
                         "It may be of another version of the programs: measure anew.")
    return table


def number(value, form):
    """As text, such as number(2.345, ".1f"); "-" for what was not measured."""
    return "-" if pandas.isna(value) else format(value, form)


def span(values, form):
    """From the least to the greatest."""
    least, most = number(values.min(), form), number(values.max(), form)
    return least if least == most else f"{least} to {most}"


def three_digits(value):
    """Without an exponent."""
    return number(float(f"{value:.3g}"), "g")


def milliseconds(value):
    return number(value, ".3f" if value < 1 else ".1f" if value < 100 else ".0f")


def markdown(header, rows):
    """A table of texts."""
    lines = [header, ["---"] * len(header), *rows]
    return "".join("|" + "".join(f" {cell} |" if cell else " |" for cell in line) + "\n" for line in lines)


def tables_of(page):
    """Names of the tables that a page asks for: lines <!-- table: NAME --> ... <!-- end -->."""
    return re.findall(r"^<!-- table: (\S+) -->$", page, re.MULTILINE)


def charts_of(page, folder):
    """Names of the charts of that folder that a page shows."""
    return sorted(set(re.findall(r"\(" + re.escape(folder) + r"/([^)/]+)\.png\)", page)))


def splice(page, tables):
    """The page with each of its tables in its place."""
    def put(match):
        return f"{match[1]}{tables[match[2]]}\n<!-- end -->"
    return re.sub(r"^(<!-- table: (\S+) -->\n)(?:.*?)^<!-- end -->$", put, page, flags=re.MULTILINE | re.DOTALL)


def compose(title, tables, charts):
    """A page of everything there is."""
    shown = "".join(f"\n![{name}]({name}.png)\n" for name in charts)
    listed = "".join(f"\n## {name}\n\n{table}" for name, table in tables.items())
    return f"# {title}\n{shown}{listed}"
