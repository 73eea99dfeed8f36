# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the pictures of two renderers.

Each side is an array of bytes (backgrounds, height, width, 3): the same scene over two backgrounds. A pixel is
covered unless it shows the background both times. Coverage must be the same, and so must colours, within TOLERANCE,
but for pixels of edges:

* A silhouette is where a pixel is covered and one of its eight neighbours is not, or the other way round. Where
  both pictures have one, coverage may differ.
* Inner edges are where one surface hides another, creases, and limits between colours. There, each of the two colours
  must lie between those around the pixel in the other picture, or not far from them: just before a silhouette,
  colours change fast.

OpenGL rounds the corners of triangles to fractions of a pixel, so the renderers choose differently where an edge
passes close to the centre of a pixel. This happens to few pixels: at most SHARE of those of all edges. A picture
that is shifted by half a pixel fails.

Thin scenes, which consist of lines and small points, are all edges. More of these may differ, but one of the
neighbours must have the same colour. Blended scenes are those where OpenGL mixes the colour of thin lines with that
of what is behind. More pixels may differ there, too, and by twice as much: a line that passes half-way between two
pixels has at most half of its colour in each.
"""

from dataclasses import dataclass
from functools import partial

import numpy as np

TOLERANCE = 2  # of 255: both sides round, and OpenGL computes in float
CONTRAST = 16  # there is an edge where neighbours differ by more than this
MARGIN = 0.5  # of the range of the colours around a pixel, added on both of its sides
BLENDED_MARGIN = 1.0
SHARE = 0.02  # of the pixels of edges that may differ
THIN_SHARE = 0.5
THIN_TOLERANCE = 12


@dataclass
class Result:
    covered: int  # pixels, on either side
    at_edges: int  # pixels that differ and may
    most_at_edges: float
    wrong: np.ndarray  # pixels that differ and may not
    largest: int  # difference of the pixels that may not

    @property
    def is_same(self):
        return self.at_edges <= self.most_at_edges and not self.wrong.any()


def neighbourhoods(pictures):
    """Each pixel and its eight neighbours, as a new first axis; the border is repeated."""
    padded = np.pad(pictures, [(0, 0), (1, 1), (1, 1), (0, 0)], mode="edge")
    height, width = pictures.shape[1:3]
    return np.stack([padded[:, j:j + height, i:i + width] for j in range(3) for i in range(3)])


def coverage(pictures, backgrounds):
    shown = np.round(255 * np.array(backgrounds)).astype(int)[:, None, None, :]
    return (abs(pictures - shown) > 1).any(axis=(0, 3))


def silhouettes(is_covered):
    around = neighbourhoods(is_covered[None, :, :, None])
    return (around.any(0) & ~around.all(0))[0, :, :, 0]


def inner_edges(pictures):
    return (np.ptp(neighbourhoods(pictures), axis=0) > CONTRAST).any(axis=(0, 3))


def lies_between(pictures, others, extension):
    """Whether the colours of a pixel lie between, or close to, those around it in the other picture."""
    around = neighbourhoods(others)
    low, high = around.min(0), around.max(0)
    margin = TOLERANCE + extension * (high - low)
    return ((pictures >= low - margin) & (pictures <= high + margin)).all(axis=(0, 3))


def occurs(pictures, others):
    """Whether one pixel around this one in the other picture has the same colours."""
    return (abs(neighbourhoods(others) - pictures) <= THIN_TOLERANCE).all(axis=(1, 4)).any(0)


def compare(one, other, backgrounds, thin=""):
    """`thin` is "lines", "blended", or nothing."""
    one, other = one.astype(int), other.astype(int)
    first, second = coverage(one, backgrounds), coverage(other, backgrounds)
    difference = abs(one - other).max(axis=(0, 3))
    margin = BLENDED_MARGIN if thin == "blended" else MARGIN
    is_shown = occurs if thin == "lines" else partial(lies_between, extension=margin)
    differs = difference > TOLERANCE  # elsewhere, a surface may be too faint to see
    at_silhouette = differs & (first != second) & silhouettes(first) & silhouettes(second)
    at_edge = differs & (first == second) & is_shown(one, other) & is_shown(other, one)
    wrong = differs & ~at_silhouette & ~at_edge
    is_edge = silhouettes(first) | silhouettes(second) | inner_edges(one) | inner_edges(other)
    share = THIN_SHARE if thin else SHARE
    return Result(np.count_nonzero(first | second), np.count_nonzero(at_silhouette | at_edge),
                  share * np.count_nonzero(is_edge), wrong,
                  int(difference[~(at_silhouette | at_edge)].max(initial=0)))
