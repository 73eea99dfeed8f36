# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The table on the terminal, and an HTML page with the pictures beside it."""

import html
import os
import textwrap

import numpy as np

from lambent.testing.pictures import as_image, png_of

STYLE = os.path.join(os.path.dirname(__file__), "..", "..", "Rendering", "Comparison", "report.css")
FORMAT = "%-26s %8s %8s %8s %8s  %s"
CLASSES = {"same": "passed", "known": "accepted", "not yet": "accepted"}
BRIGHTER = 16  # factor of the differences in the pictures


def cells(row):
    if row.result is None:
        return "", "", "", ""
    result = row.result
    return result.covered, result.at_edges, np.count_nonzero(result.wrong), result.largest


def print_title():
    print(FORMAT % ("scene", "pixels", "at edges", "differ", "largest", "verdict"))


def print_row(row):
    print(FORMAT % ((row.name,) + cells(row) + (row.verdict,)), flush=True)
    if row.note and row.verdict != "not yet":
        print(textwrap.indent(textwrap.fill(row.note, 100), "    "))


def write_report(folder, rows):
    """Writes the page and its PNG files. Returns the page's path."""
    os.makedirs(folder, exist_ok=True)
    with open(STYLE, encoding="utf-8") as file:
        style = file.read()
    failed = sum(row.failed for row in rows)
    summary = "OpenGL and Lambent: %d of %d scenes differ unexpectedly" % (failed, len(rows))
    sections = "\n".join(section(folder, row) for row in rows)
    path = os.path.join(folder, "report.html")
    with open(path, "w", encoding="utf-8") as file:
        file.write('<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<title>%s</title>\n'
                   "<style>\n%s</style>\n</head>\n<body>\n<h1>%s</h1>\n%s\n</body>\n</html>\n"
                   % (summary, style, summary, sections))
    return path


def section(folder, row):
    pixels, at_edges, wrong, largest = cells(row)
    text = row.verdict
    if row.result:
        text += ": %s pixels, %s differ at edges, %s differ elsewhere; the largest difference is %s." % (
            pixels, at_edges, wrong, largest)
    pictures = {caption: each[0] for caption, each in row.pictures.items()}
    if len(pictures) > 1:
        one, other = list(pictures.values())[:2]
        difference = BRIGHTER * abs(one.astype(int) - other)
        pictures["difference × %d" % BRIGHTER] = np.clip(difference, 0, 255).astype(np.uint8)
    figures = []
    for number, (caption, picture) in enumerate(pictures.items()):
        name = "%s-%d.png" % (row.name, number)
        with open(os.path.join(folder, name), "wb") as file:
            file.write(png_of(as_image(picture[::-1])))
        figures.append('<figure><img alt="%s" src="%s"><figcaption>%s</figcaption></figure>'
                       % (caption, name, caption))
    return '<section class="%s">\n<h2>%s</h2>\n<div>%s</div>\n<div>%s</div>\n<div class="pictures">%s</div>\n' \
        "</section>" % (CLASSES.get(row.verdict, "failed"), row.name, text, html.escape(row.note),
                        "\n".join(figures))
