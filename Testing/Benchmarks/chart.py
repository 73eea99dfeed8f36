# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Line charts with two logarithmic axes as SVG, for light and dark backgrounds."""

import math
from dataclasses import dataclass, field
from xml.sax.saxutils import escape

WIDTH, HEIGHT = 470, 400
LEFT, RIGHT, TOP, BOTTOM = 56, 18, 40, 52
LEGEND, NOTE = 70, 30
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")

STYLE = """
  svg { font: 13px system-ui, "DejaVu Sans", sans-serif; }
  text { fill: #24292f; } .faint { fill: #57606a; font-size: 12px; }
  .title { font-weight: 600; font-size: 14px; }
  .grid { stroke: #d0d7de; stroke-width: 1; } .fine { stroke: #d0d7de; stroke-width: 0.4; }
  .line { fill: none; stroke-width: 2; stroke-linejoin: round; stroke-linecap: round; }
  .dashed { stroke-dasharray: 2 5; }
  .ours { stroke: #cf4a00; stroke-width: 3; } .peer { stroke: #0969da; }
  .second { stroke: #1a7f6a; } .third { stroke: #8250df; }
  .dot.ours { fill: #cf4a00; } .dot.peer { fill: #0969da; }
  .dot.second { fill: #1a7f6a; } .dot.third { fill: #8250df; } .dot { stroke: none; }
  @media (prefers-color-scheme: dark) {
    text { fill: #e6edf3; } .faint { fill: #9198a1; }
    .grid { stroke: #3d444d; } .fine { stroke: #3d444d; }
    .ours { stroke: #ff8b3d; } .peer { stroke: #58a6ff; }
    .second { stroke: #3fc7a8; } .third { stroke: #bc8cff; }
    .dot.ours { fill: #ff8b3d; } .dot.peer { fill: #58a6ff; }
    .dot.second { fill: #3fc7a8; } .dot.third { fill: #bc8cff; }
  }
"""


@dataclass
class Series:
    key: str
    label: str
    style: str
    dashed: bool = False
    points: list = field(default_factory=list)

    def line_class(self):
        return f"line {self.style}" + (" dashed" if self.dashed else "")


class LogAxis:
    """Maps values to positions on an axis whose ends are powers of ten."""

    NEARLY = 0.02  # of a decade: values so close to a power do not need another decade

    def __init__(self, values, begin, end):
        self.low = math.floor(min(map(math.log10, values)) + self.NEARLY)
        self.high = max(math.ceil(max(map(math.log10, values)) - self.NEARLY), self.low + 1)
        self.begin, self.end = begin, end

    def place(self, value):
        part = (math.log10(value) - self.low) / (self.high - self.low)
        return self.begin + part * (self.end - self.begin)

    def decades(self):
        return range(self.low, self.high + 1)

    def between(self):
        """The multiples two to nine in each decade."""
        return [digit * 10.0**k for k in self.decades()[:-1] for digit in range(2, 10)]


def power(exponent):
    plain = {-1: "0.1", 0: "1", 1: "10", 2: "100"}
    return plain.get(exponent, "10" + str(exponent).translate(SUPERSCRIPTS))


def line(css, x1, y1, x2, y2):
    return f'<line class="{css}" x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}"/>'


def text(content, x, y, css="", anchor="middle", turned=False):
    turn = f' transform="rotate(-90 {x:.1f} {y:.1f})"' if turned else ""
    return (
        f'<text class="{css}" x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{turn}>'
        f"{escape(content)}</text>"
    )


@dataclass
class Panel:
    title: str
    x_label: str
    y_label: str
    series: list

    def draw(self):
        left, right, top, bottom = LEFT, WIDTH - RIGHT, TOP, HEIGHT - BOTTOM
        points = [point for series in self.series for point in series.points]
        x_axis = LogAxis([x for x, _ in points], left, right)
        y_axis = LogAxis([y for _, y in points], bottom, top)
        parts = [text(self.title, (left + right) / 2, top - 16, "title")]
        for value in x_axis.between():
            parts.append(line("fine", x_axis.place(value), top, x_axis.place(value), bottom))
        for value in y_axis.between():
            parts.append(line("fine", left, y_axis.place(value), right, y_axis.place(value)))
        for k in x_axis.decades():
            x = x_axis.place(10.0**k)
            parts += [line("grid", x, top, x, bottom), text(power(k), x, bottom + 18, "faint")]
        for k in y_axis.decades():
            y = y_axis.place(10.0**k)
            parts += [line("grid", left, y, right, y)]
            parts += [text(power(k), left - 8, y + 4, "faint", "end")]
        parts.append(text(self.x_label, (left + right) / 2, bottom + 40))
        parts.append(text(self.y_label, 14, (top + bottom) / 2, turned=True))
        for series in reversed(self.series):
            parts += self._curve(series, x_axis, y_axis)
        return "\n".join(parts)

    @staticmethod
    def _curve(series, x_axis, y_axis):
        places = [(x_axis.place(x), y_axis.place(y)) for x, y in series.points]
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
        parts = [f'<polyline class="{series.line_class()}" points="{path}"/>']
        if not series.dashed:
            dot = '<circle class="dot {}" cx="{:.1f}" cy="{:.1f}" r="3"/>'
            parts += [dot.format(series.style, x, y) for x, y in places]
        return parts


def legend(series, y, width):
    """Line samples and labels in two rows."""
    columns = (len(series) + 1) // 2
    parts = []
    for k, one in enumerate(series):
        x, row = LEFT + (k // 2) * (width - LEFT) / columns, y + 22 * (k % 2)
        parts.append(line(one.line_class(), x, row - 4, x + 30, row - 4))
        parts.append(text(one.label, x + 38, row, anchor="start"))
    return parts


def page(panels, note):
    """All panels side by side with one legend, since they have the same series."""
    width, height = WIDTH * len(panels), HEIGHT + LEGEND + NOTE
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
        f'width="{width}" height="{height}" role="img">',
        f"<style>{STYLE}</style>",
    ]
    for k, panel in enumerate(panels):
        parts.append(f'<g transform="translate({k * WIDTH} 0)">\n{panel.draw()}\n</g>')
    parts += legend(panels[0].series, HEIGHT + 22, width)
    parts.append(text(note, LEFT, HEIGHT + LEGEND + 12, "faint", "start"))
    return "\n".join(parts) + "\n</svg>\n"
