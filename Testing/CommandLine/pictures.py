# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Strict readers of the picture files that the command writes: they accept no unexpected byte.

Pictures are rows of pixels, the top row first; a pixel is a tuple of its channels."""

import re
import struct
import zlib


def rows_of(values, width, channels):
    pixels = [tuple(values[k:k + channels]) for k in range(0, len(values), channels)]
    return [pixels[k:k + width] for k in range(0, len(pixels), width)]


def read_png(content):
    """Rows of a PNG of 8 bits per channel, without palette and interlacing."""
    at, data = 8, b""
    while at < len(content):
        length, = struct.unpack(">I", content[at:at + 4])
        kind, body = content[at + 4:at + 8], content[at + 8:at + 8 + length]
        assert zlib.crc32(kind + body) == struct.unpack(">I", content[at + 8 + length:][:4])[0]
        if kind == b"IHDR":
            width, height, depth, color, *rest = struct.unpack(">2I5B", body)
            assert depth == 8 and rest == [0, 0, 0], (depth, rest)
            channels = {0: 1, 2: 3, 4: 2, 6: 4}[color]
        data += body if kind == b"IDAT" else b""
        at += 12 + length
    lines = zlib.decompress(data)
    size = width * channels
    assert len(lines) == height * (size + 1)
    above, values = bytes(size), []
    for j in range(height):
        line = bytearray(lines[j * (size + 1) + 1:(j + 1) * (size + 1)])
        for k in range(size):
            left, corner = (line[k - channels], above[k - channels]) if k >= channels else (0, 0)
            line[k] = (line[k] + predicted(lines[j * (size + 1)], left, above[k], corner)) % 256
        values += line
        above = line
    return rows_of(values, width, channels)


def predicted(method, left, above, corner):
    if method == 4:
        guess = left + above - corner
        return min((left, above, corner), key=lambda value: abs(guess - value))
    return (0, left, above, (left + above) // 2)[method]


# Tags of TIFF 6.0.
WIDTH, HEIGHT, BITS, COMPRESSION, COLOURS, STRIPS, TURNED, SAMPLES, ROWS, SIZES = (
    256, 257, 258, 259, 262, 273, 274, 277, 278, 279)
X_RESOLUTION, Y_RESOLUTION, PLANES, UNIT, EXTRA, FORMAT = 282, 283, 284, 296, 338, 339


def tiff_tags(content):
    """The tags of the only picture of a TIFF, with their values."""
    order = {b"II": "<", b"MM": ">"}[content[:2]]
    magic, first = struct.unpack(order + "HI", content[2:8])
    assert magic == 42 and first % 2 == 0
    count, = struct.unpack(order + "H", content[first:first + 2])
    tags = {}
    for k in range(count):
        tag, kind, number, place = struct.unpack(
            order + "HHII", content[first + 2 + 12 * k:first + 14 + 12 * k])
        assert tag > max(tags, default=0), "tags are in ascending order"
        form = order + {3: "%dH" % number, 4: "%dI" % number, 5: "%dI" % (2 * number)}[kind]
        size = struct.calcsize(form)
        start = first + 2 + 12 * k + 8 if size <= 4 else place
        assert start % 2 == 0 and start + size <= len(content)
        tags[tag] = struct.unpack(form, content[start:start + size])
    assert content[first + 2 + 12 * count:][:4] == bytes(4), "there is one picture"
    return order, tags


def read_tiff(content):
    """Rows of a TIFF written by the command: strips of bytes or floats, the top row first."""
    order, tags = tiff_tags(content)
    one = {tag: values[0] for tag, values in tags.items() if len(set(values)) == 1}
    channels = one[SAMPLES]
    is_float = one[BITS] == 32
    assert len(tags[BITS]) == channels and one[BITS] in (8, 32)
    assert (one[COMPRESSION], one[TURNED], one[PLANES], one[UNIT]) == (1, 1, 1, 1)
    assert one[X_RESOLUTION] == one[Y_RESOLUTION] == 1
    assert one[COLOURS] == (1 if channels == 1 else 2)
    assert tags.get(FORMAT) == ((3,) * channels if is_float else None)
    assert tags.get(EXTRA) == (None if channels < 4 else (0,) if is_float else (2,))
    row = one[WIDTH] * channels * one[BITS] // 8
    left = [min(one[ROWS], one[HEIGHT] - k) * row for k in range(0, one[HEIGHT], one[ROWS])]
    assert list(tags[SIZES]) == left
    data, end = b"", 8  # the strips follow the header without gaps
    for start, size in zip(tags[STRIPS], tags[SIZES]):
        assert start == end
        data += content[start:start + size]
        end = start + size
    assert len(data) == one[HEIGHT] * row
    values = struct.unpack(order + ("%df" % (len(data) // 4) if is_float else "%dB" % len(data)), data)
    return rows_of(values, one[WIDTH], channels)


def unpack_lz4(data):
    """The content of an LZ4 block."""
    out, at = bytearray(), 0

    def length(part):
        nonlocal at
        more = 255 if part == 15 else 0
        while more == 255:
            more, at = data[at], at + 1
            part += more
        return part

    while at < len(data):
        token, at = data[at], at + 1
        literals = length(token >> 4)
        out += data[at:at + literals]
        at += literals
        if at < len(data):
            offset, at = data[at] | data[at + 1] << 8, at + 2
            for _ in range(length(token & 15) + 4):
                out.append(out[-offset])
    return bytes(out)


def read_vti(content):
    """Name -> rows of each point array of a VTK image written by the command, and the name of the
    scalars."""
    head, _, data = content.partition(b'<AppendedData encoding="raw">')
    head, data = head.decode(), data[data.index(b"_") + 1:]
    assert 'header_type="UInt32"' in head and "vtkLZ4DataCompressor" in head
    width = int(re.search(r'WholeExtent="0 (\d+) 0 \d+ 0 0"', head).group(1)) + 1
    arrays = {}
    for tag in re.findall("<DataArray (.*?)>", head):
        field = dict(re.findall(r'(\w+)="(.*?)"', tag))
        at = int(field["offset"])
        blocks, size, last = struct.unpack("<3I", data[at:at + 12])
        packed = struct.unpack("<%dI" % blocks, data[at + 12:at + 12 + 4 * blocks])
        at += 12 + 4 * blocks
        values = b""
        for length in packed:
            values += unpack_lz4(data[at:at + length])
            at += length
        assert len(values) == (blocks - 1) * size + last if last else blocks * size
        kind = {"UInt8": "B", "Float32": "f", "Float64": "d", "Int64": "q"}[field["type"]]
        values = struct.unpack("<%d%s" % (len(values) // struct.calcsize(kind), kind), values)
        rows = rows_of(values, width, int(field.get("NumberOfComponents", 1)))
        arrays[field["Name"]] = rows[::-1]
    return arrays, re.search('PointData Scalars="(.*?)"', head).group(1)
