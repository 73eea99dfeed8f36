# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""A report of a run's pictures: one HTML file with all pictures inside, which needs no network."""

import base64
import html
import os
import string

from .pictures import write_file

ROLES = ("picture", "baseline", "difference")
HEADINGS = {"failed": "Different", "accepted": "Accepted as baselines", "passed": "As expected"}


def write_report(path, results):
    """Write the report of the results, dictionaries as lambent.testing records them."""
    parts = []
    for outcome, heading in HEADINGS.items():
        entries = [result for result in results if result["outcome"] == outcome]
        if entries:
            make = _row if outcome == "passed" else _section
            parts.append("<h2>%s: %d</h2>" % (heading, len(entries)))
            parts += map(make, entries)
    with open(os.path.join(os.path.dirname(__file__), "report.html"), encoding="utf-8") as file:
        page = string.Template(file.read())
    failed = sum(result["outcome"] == "failed" for result in results)
    summary = "%d of %d pictures differ" % (failed, len(results))
    content = page.substitute(summary=summary, body="\n".join(parts))
    write_file(os.path.abspath(path), content.encode("utf-8"))


def _row(result):
    return "<p><b>%s</b> %s</p>" % (html.escape(result["test"]), html.escape(result["message"]))


def _section(result):
    """A picture that wants to be looked at."""
    links = {role: _embedded(result[role]) for role in ROLES if role in result}
    lines = ["<section>", "<h3>%s</h3>" % html.escape(result["test"]),
             "<p>%s</p>" % html.escape(result["message"])]
    if result["outcome"] == "failed" and links.get("picture") and links.get("baseline"):
        lines.append(
            '<div class="slider"><div><img src="%(baseline)s" alt="baseline">'
            '<img src="%(picture)s" alt="picture"></div>'
            '<label>baseline <input type="range" value="50"> picture</label></div>' % links)
    lines.append('<div class="side-by-side">')
    for role, link in links.items():
        shown = '<img src="%s" alt="%s">' % (link, role) if link else "(not there)"
        lines.append("<figure>%s<figcaption>%s<br><code>%s</code></figcaption></figure>"
                     % (shown, role, html.escape(result[role])))
    return "\n".join(lines + ["</div>", "</section>"])


def _embedded(path):
    """A file's picture as a link that contains it; None if it cannot be read, as from afar."""
    try:
        with open(path, "rb") as file:
            return "data:image/png;base64," + base64.b64encode(file.read()).decode("ascii")
    except OSError:
        return None
