# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The two assertions. The comparison itself is vtkLambentImageComparison's."""

import hashlib
import numbers
import os
import re
import sys

from .. import vtkLambentImageComparison
from .pictures import as_image, fits_png, png_of, write_file
from .runs import calling_file, current_run

METRICS = {
    "max": vtkLambentImageComparison.MAXIMUM_DIFFERENCE,
    "rmse": vtkLambentImageComparison.ROOT_MEAN_SQUARE,
    "ssim": vtkLambentImageComparison.STRUCTURAL_SIMILARITY,
}


def assert_images_equal(a, b, tolerance=0, metric="max"):
    """Fail unless picture `a` equals `b`, the one that is expected.

    `metric` is what must not exceed `tolerance`: "max", the largest difference of two values, or
    "rmse", the root of the mean square of all differences, both in units of the values (0 to 255
    for bytes); or "ssim", what the structural similarity lacks to 1 (VTK 9.4 or newer). With a
    tolerance of 0 each of them is exact.
    """
    __tracebackhide__ = True
    comparison = _comparison(tolerance, metric)
    picture, expected = as_image(a), as_image(b)
    _compare(comparison, picture, expected)
    run = current_run()
    result = {"outcome": "passed", "message": comparison.GetMessage()}
    if not comparison.GetPassed():
        result["outcome"] = "failed"
        _save(result, os.path.join(run.failures(), "images"), picture=picture, baseline=expected,
              difference=comparison.GetOutput())
    _conclude(run, result)


def assert_matches_baseline(image_or_filter, name, tolerance=0, metric="max"):
    """Fail unless a picture equals the baseline of this name: the file `name`.png in the folder
    `baselines` beside the test's file. A name may have folders, as "box/front".

    Without a baseline the test fails, too, and says how to accept the picture. A picture that
    passes never replaces its baseline. `tolerance` and `metric`: see assert_images_equal().
    """
    __tracebackhide__ = True
    comparison = _comparison(tolerance, metric)
    run = current_run()
    baseline = baseline_file(run.baselines(calling_file()), name)
    _refuse_baseline(image_or_filter, baseline)
    picture = as_image(image_or_filter)
    if not fits_png(picture):
        raise ValueError(
            "a baseline is a PNG, which holds 1 to 4 components of unsigned char or unsigned short;"
            " this picture has %d of %s; for the ray tracer's, SetOutputScalarTypeToUnsignedChar()"
            % (picture.GetNumberOfScalarComponents(), picture.GetScalarTypeAsString()))
    result = {"baseline": baseline, "message": _judge(run, comparison, picture, baseline)}
    if comparison.GetPassed():
        result["outcome"] = "passed"
    elif run.updates and baseline not in run.accepted:
        _accept(run, result, picture)
    else:
        result["outcome"] = "failed"
        result["accept"] = run.how_to_accept
        if baseline in run.accepted:
            result["message"] = ("this run has accepted another picture of this name; give each"
                                 " its own")
        stem = os.path.splitext(os.path.basename(baseline))[0]
        _save(result, os.path.join(run.failures(), stem), picture=picture,
              difference=comparison.GetOutput())
    result["message"] = "%s: %s" % (name, result["message"])
    _conclude(run, result)


def baseline_file(folder, name):
    """The file of a baseline. A name that could lead out of the folder, or that some system cannot
    have, is a ValueError."""
    if not isinstance(name, str):
        raise TypeError("the name of a baseline is a string, not %r" % (name,))
    parts = re.sub(r"\.png$", "", name).split("/")
    for part in parts:
        if not re.fullmatch(r'(?!\.)[^\\:*?"<>|\x00-\x1f]*(?<![. ])', part) or not part:
            raise ValueError(
                "%r cannot be the name of a baseline: it is a file's name, or several joined by"
                " '/', none of them empty, beginning or ending with a dot, or with one of"
                " \\:*?\"<>|"
                % name)
    return os.path.join(folder, *parts) + ".png"


def _comparison(tolerance, metric):
    """A comparison that is still to be made; until then nothing has passed."""
    if not isinstance(metric, str) or metric not in METRICS:
        raise ValueError("the metric is %r; it can be %s"
                         % (metric, ", ".join(map(repr, METRICS))))
    if not isinstance(tolerance, numbers.Real) or not 0 <= tolerance <= sys.float_info.max:
        raise ValueError("the tolerance is %r; it is a number, 0 or larger" % (tolerance,))
    if metric == "ssim" and not vtkLambentImageComparison.HasStructuralSimilarity():
        raise RuntimeError("this VTK cannot compute the structural similarity; VTK 9.4 can")
    comparison = vtkLambentImageComparison()
    comparison.SetMetric(METRICS[metric])
    comparison.SetTolerance(float(tolerance))
    comparison.HighlightOn()
    return comparison


def _compare(comparison, picture, expected):
    comparison.SetPictureData(picture)
    comparison.SetBaselineData(expected)
    comparison.Update()


def _judge(run, comparison, picture, baseline):
    """Compare with a file, if there is one; what is found, in one line."""
    if baseline in run.pending:
        _compare(comparison, picture, run.pending[baseline][0])
        return comparison.GetMessage()
    if not os.path.exists(baseline):
        return "there is no baseline yet"
    try:
        expected = as_image(baseline)
    except ValueError as error:  # such as a file that only stands for one in a large-file store
        return str(error)
    _compare(comparison, picture, expected)
    return comparison.GetMessage()


def _refuse_baseline(picture, baseline):
    """A file is always equal to itself."""
    if not isinstance(picture, (str, bytes, os.PathLike)):
        return
    path = os.fsdecode(picture)
    is_same = os.path.realpath(path) == os.path.realpath(baseline)
    try:
        is_same = is_same or os.path.samefile(path, baseline)
    except OSError:  # one of them is not there
        pass
    if is_same:
        raise ValueError("the picture '%s' is the baseline itself; give the one that is to be"
                         " compared with it" % path)


def _accept(run, result, picture):
    """Make the picture the baseline."""
    baseline = result["baseline"]
    is_new = not os.path.exists(baseline)
    content = png_of(picture)
    run.accept(baseline, picture, content)
    result.update(outcome="accepted", change="new" if is_new else "changed",
                  digest=hashlib.sha256(content).hexdigest())


def _save(result, stem, **images):
    """Write those of the pictures that a PNG can hold; name them in the result."""
    for role, image in images.items():
        if fits_png(image):
            result[role] = "%s.%s.png" % (stem, role)
            write_file(result[role], png_of(image))


def _conclude(run, result):
    """Hand the result over; if it is a failure, say what is wrong, and where to look."""
    __tracebackhide__ = True
    run.record(result)
    if result["outcome"] != "failed":
        return
    lines = [result["message"]]
    for role in ("picture", "baseline", "difference"):
        if role in result:
            lines.append("  %-11s %s" % (role + ":", result[role]))
    if "accept" in result:
        lines.append("If the picture is right, %s to accept it." % result["accept"])
    raise AssertionError("\n".join(lines))
