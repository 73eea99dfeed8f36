# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""A report of a run's pictures: a single HTML page with embedded pictures, which needs no network.
It looks like the report of the command `lambent`."""

import base64
import html
import os
import string
import struct

from .pictures import write_file

MARK = b"<!DOCTYPE html>\n<!-- report of lambent.testing -->\n"


def write_report(path, results):
    """Write the report of results, which are dictionaries as lambent.testing records them.
    Overwrites an older report or an empty file; raises OSError for any other file."""
    if os.path.isfile(path) and os.path.getsize(path):
        with open(path, "rb") as file:
            if file.read(len(MARK)) != MARK:
                raise FileExistsError("'%s' exists and is not a report; choose another name" % path)
    page = string.Template(_text("report.html"))
    failed = sum(result["outcome"] == "failed" for result in results)
    content = page.substitute(
        style=_text("report.css"),
        summary="%d of %d pictures differ" % (failed, len(results)),
        sections="\n".join(map(_section, results)))
    write_file(path, content.encode("utf-8"))


def _text(name):
    with open(os.path.join(os.path.dirname(__file__), name), encoding="utf-8") as file:
        return file.read()


def _section(result):
    """The section of one comparison, without pictures if it has passed."""
    outcome = result["outcome"]
    lines = ["<h2>%s</h2>" % html.escape(result["test"]),
             "<div>%s</div>" % html.escape(result["message"])]
    if outcome != "passed":
        if "baseline" in result:
            what = "accepted as the baseline" if outcome == "accepted" else "the baseline"
            lines.append("<div>%s: %s</div>" % (what, html.escape(result["baseline"])))
        lines.append('<div class="pictures">%s</div>' % "\n".join(_figures(result)))
    return '<section class="%s">\n%s\n</section>' % (outcome, "\n".join(lines))


def _figures(result):
    """Picture and baseline under a slider, and the difference; or whichever of them exist."""
    found = {role: _read(result[role]) for role in ("picture", "baseline", "difference")
             if role in result}
    found = {role: png for role, png in found.items() if png}
    if len(found) == 3:
        picture, baseline = found.pop("picture"), found.pop("baseline")
        yield ('<figure style="width: %dpx"><div class="slide">%s%s</div>'
               '<input type="range" aria-label="picture or baseline">'
               '<figcaption><span>picture</span><span>baseline</span></figcaption></figure>'
               % (_width(picture), _tag(picture, "picture"), _tag(baseline, "baseline")))
    for role, png in found.items():
        yield ('<figure style="width: %dpx">%s<figcaption>%s</figcaption></figure>'
               % (_width(png), _tag(png, role), role))


def _read(path):
    """The bytes of a PNG file; None if it is missing, as when a worker runs on another machine."""
    try:
        with open(path, "rb") as file:
            content = file.read()
    except OSError:
        return None
    return content if content[12:16] == b"IHDR" else None


def _width(png):
    """The display width of a picture; small ones are enlarged by an integer factor."""
    width, = struct.unpack(">I", png[16:20])
    return width * max(1, 360 // width)


def _tag(png, role):
    return ('<img alt="%s" src="data:image/png;base64,%s">'
            % (role, base64.b64encode(png).decode("ascii")))
