# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The two assertions. vtkLambentImageComparison does the comparison."""

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
    """Fail unless picture `a` equals the expected picture `b`.

    `metric` must not exceed `tolerance`. It is "max", the largest difference between two values;
    "rmse", the root mean square of all differences, both in units of the values (0 to 255 for
    bytes); or "ssim", 1 minus the structural similarity (VTK 9.4 or newer). With a tolerance of
    0 no value may differ, whatever the metric.
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
    """Fail unless a picture equals its baseline: the file `name`.png in the folder `baselines`
    beside the test's file. A name may contain folders, such as "box/front".

    Without a baseline the test fails, too, and says how to accept the picture. A picture that
    passes never replaces its baseline. For `tolerance` and `metric` see assert_images_equal().
    """
    __tracebackhide__ = True
    comparison = _comparison(tolerance, metric)
    run = current_run()
    baseline = baseline_file(run.baselines(calling_file()), name)
    _refuse_baseline(image_or_filter, baseline)
    picture = as_image(image_or_filter)
    if not fits_png(picture):
        raise ValueError(
            "a baseline is a PNG, which holds 1 to 4 components of unsigned char or unsigned short,"
            " but this picture has %d of %s; with the ray tracer, call"
            " SetOutputScalarTypeToUnsignedChar()"
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
            result["message"] = ("this run has accepted another picture under this name; give each"
                                 " its own name")
        stem = os.path.splitext(os.path.basename(baseline))[0]
        _save(result, os.path.join(run.failures(), stem), picture=picture,
              difference=comparison.GetOutput())
    result["message"] = "%s: %s" % (name, result["message"])
    _conclude(run, result)


def baseline_file(folder, name):
    """The path of a baseline. Raises ValueError for a name that could lead out of the folder, or
    that some systems do not allow."""
    if not isinstance(name, str):
        raise TypeError("the name of a baseline must be a string, not %r" % (name,))
    parts = re.sub(r"\.png$", "", name).split("/")
    for part in parts:
        if not re.fullmatch(r'(?!\.)[^\\:*?"<>|\x00-\x1f]*(?<![. ])', part) or not part:
            raise ValueError(
                "%r cannot be the name of a baseline: a name has one or more parts joined by '/';"
                " no part may be empty, begin with a dot, end with a dot or a space, or contain any of"
                " \\:*?\"<>|"
                % name)
    return os.path.join(folder, *parts) + ".png"


def _comparison(tolerance, metric):
    """A comparison with these settings, not run yet."""
    if not isinstance(metric, str) or metric not in METRICS:
        raise ValueError("the metric is %r; it must be one of %s"
                         % (metric, ", ".join(map(repr, METRICS))))
    if not isinstance(tolerance, numbers.Real) or not 0 <= tolerance <= sys.float_info.max:
        raise ValueError("the tolerance is %r; it must be a number, 0 or larger" % (tolerance,))
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
    """Compare a picture with its baseline, if there is one. Return the result in one line."""
    if baseline in run.pending:
        _compare(comparison, picture, run.pending[baseline][0])
        return comparison.GetMessage()
    if not os.path.exists(baseline):
        return "there is no baseline yet"
    try:
        expected = as_image(baseline)
    except ValueError as error:  # such as a pointer into a large-file store
        return str(error)
    _compare(comparison, picture, expected)
    return comparison.GetMessage()


def _refuse_baseline(picture, baseline):
    """Raise ValueError if the picture is its own baseline, which would always be equal."""
    if not isinstance(picture, (str, bytes, os.PathLike)):
        return
    path = os.fsdecode(picture)
    is_same = os.path.realpath(path) == os.path.realpath(baseline)
    try:
        is_same = is_same or os.path.samefile(path, baseline)
    except OSError:  # one of them is missing
        pass
    if is_same:
        raise ValueError("the picture '%s' is the baseline itself; pass the picture to compare"
                         " with it" % path)


def _accept(run, result, picture):
    """Make the picture the baseline."""
    baseline = result["baseline"]
    is_new = not os.path.exists(baseline)
    content = png_of(picture)
    run.accept(baseline, picture, content)
    result.update(outcome="accepted", change="new" if is_new else "changed",
                  digest=hashlib.sha256(content).hexdigest())


def _save(result, stem, **images):
    """Write the pictures that a PNG can hold, and add their paths to the result."""
    for role, image in images.items():
        if fits_png(image):
            result[role] = "%s.%s.png" % (stem, role)
            write_file(result[role], png_of(image))


def _conclude(run, result):
    """Record the result. If it is a failure, raise an error that describes it."""
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
