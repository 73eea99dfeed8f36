# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pillow images. As arrays, some of them do not hold RGB colours: palette images hold indices, and
others use the colour spaces of print and video."""

_PLAIN = ("L", "LA", "RGB", "RGBA", "I;16", "I;16L", "I;16B", "I;16N")
_NUMBERS = ("I", "F")  # rejected later, by the type of their arrays


def is_pillow(picture):
    return hasattr(picture, "getbands") and hasattr(picture, "mode")


def in_plain_colours(picture):
    """The same colours in a mode whose array holds them, with an alpha channel if some are
    transparent. Conversions that would round, and so could make two colours equal, are left to the
    caller."""
    mode = picture.mode
    is_transparent = "transparency" in picture.info
    if mode in ("P", "PA"):
        palette = getattr(picture.palette, "mode", "RGB")
        return picture.convert("RGBA" if mode == "PA" or is_transparent or palette == "RGBA"
                               else "RGB")
    if mode == "RGB" and is_transparent:
        return picture.convert("RGBA")
    if mode in ("1", "L") and is_transparent:
        return picture.convert("RGBA").convert("LA")
    if mode == "1":
        return picture.convert("L")
    if mode == "RGBX":
        return picture.convert("RGB")
    if mode not in _PLAIN + _NUMBERS:
        raise TypeError(
            "the image's mode is %s; convert it to RGB, for example with %s, since its values are not"
            " RGB colours" % (mode, "PIL.ImageCms" if mode == "LAB" else "convert('RGB')"))
    return picture
