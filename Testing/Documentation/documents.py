# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Markdown pages of the source tree, and their parts: sections, links, quoted code, tables."""

import os
import posixpath
import re
import textwrap

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
# <!-- file: PATH --> or <!-- file: PATH | TEXT | TEXT -->. The latter quotes from the first line that
# contains the first text to the next line that contains the second.
QUOTE = re.compile(r"(<!-- file: (\S+)(?: \| (.+?) \| (.+?))? -->\n```\w+\n)(.*?)(```\n)", re.DOTALL)
FENCED = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)
LICENCE = re.compile(r"\A(?:(?://|#) SPDX-.*\n)+\n?")


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def pages():
    """The paths of all Markdown files, relative to the root and with slashes, without hidden folders and
    builds."""
    found = []
    for folder, children, files in os.walk(ROOT):
        children[:] = [name for name in children
                       if not name.startswith((".", "build")) and name != "__pycache__"]
        found += [os.path.relpath(os.path.join(folder, name), ROOT).replace(os.sep, "/")
                  for name in files if name.lower().endswith(".md")]
    return sorted(found)


def readmes():
    return [page for page in pages() if posixpath.basename(page) == "README.md"]


def example(path, first="", last=""):
    """The text of an example without the lines about its licence, or the lines between two texts."""
    lines = LICENCE.sub("", read(path)).splitlines(keepends=True)
    if not first:
        return "".join(lines)
    start = next((i for i, line in enumerate(lines) if first in line), None)
    if start is None:
        raise ValueError("%s has no line with '%s'" % (path, first))
    end = next((i for i in range(start, len(lines)) if last in lines[i]), None)
    if end is None:
        raise ValueError("%s has no line with '%s' after '%s'" % (path, last, first))
    return textwrap.dedent("".join(lines[start:end + 1]))


def update():
    """Copy the examples into the pages that quote them."""
    for page in pages():
        old = read(page)
        new = QUOTE.sub(lambda match: match[1] + example(match[2], match[3], match[4]) + match[6], old)
        if new != old:
            with open(os.path.join(ROOT, page), "w", encoding="utf-8") as file:
                file.write(new)


def section(text, title):
    """The text after a heading, up to the next heading of its level or above."""
    level = re.search(r"^(#+) %s$" % re.escape(title), text, re.MULTILINE)
    if not level:
        raise ValueError("there is no heading '%s'" % title)
    rest = text[level.end():]
    following = re.search(r"^#{1,%d} " % len(level.group(1)), rest, re.MULTILINE)
    return rest[:following.start()] if following else rest


def links(page):
    """The targets of the links and images of a page."""
    text = FENCED.sub("", read(page))
    return (re.findall(r"\]\(([^)\s]*)\)", text) + re.findall(r'\b(?:src|href)="([^"]*)"', text)
            + re.findall(r"^\[[^\]]+\]: (\S+)", text, re.MULTILINE))


def target(page, link):
    """The path that a relative link leads to, relative to the root, and its anchor."""
    path, _, anchor = link.partition("#")
    return posixpath.normpath(posixpath.join(posixpath.dirname(page), path)) if path else page, anchor


def anchors(page):
    """The anchors that GitHub gives to the headings of a page."""
    titles = re.findall(r"^#+ (.*)$", FENCED.sub("", read(page)), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.strip().lower()).replace(" ", "-") for title in titles}


def table(text, heading):
    """The rows below the first table header that begins with this text, as lists of cells."""
    lines = text.splitlines()
    start = next(i for i, line in enumerate(lines) if line.startswith("| " + heading))
    rows = []
    for line in lines[start + 2:]:
        if not line.startswith("|"):
            break
        rows.append([cell.strip() for cell in line.strip("| ").split(" |")])
    return rows
