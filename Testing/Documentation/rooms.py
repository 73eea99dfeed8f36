# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The folders of the sources, and the other folders that each may include: data walks down this list.

    python3 Testing/Documentation/rooms.py        prints the map that Rendering/README.md shows
"""

import collections
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]

Room = collections.namedtuple("Room", "folder includes purpose")

BASE = "Filters/Base"
NORMALS = "Filters/Core"
CONTRACT, SCENE, FRAME, TILES, CAST, POINTS, LIGHT, FILM = (
    f"Rendering/Core/{name}" for name in
    ("Contract", "Scene", "Frame", "Tiles", "Cast", "SurfacePoints", "Light", "Film"))
CORE = "Rendering/Core"
FILTERS, RENDERING, COMPARISON, COMMAND = (
    "Filters", "Rendering", "Rendering/Comparison", "Rendering/CommandLine")

ROOMS = (
    Room(BASE, (), "arithmetic, elementary functions, spans, vectors, parallel loops"),
    Room(NORMALS, (BASE,), "checked faces of a mesh; normals of points, cells and corners"),
    Room(CONTRACT, (BASE,), "the image contract: what decides the bits of a pixel"),
    Room(SCENE, (BASE, NORMALS, CONTRACT), "surfaces, lights, camera; polygons become triangles"),
    Room(FRAME, (BASE, CONTRACT, SCENE), "the camera's frame, and primitives and rays in it"),
    Room(TILES, (BASE, CONTRACT, SCENE, FRAME), "which primitives each tile of the image tests"),
    Room(CAST, (BASE, CONTRACT, SCENE, FRAME, TILES), "what each sample of a tile sees"),
    Room(POINTS, (BASE, CONTRACT, SCENE, FRAME), "surface points: position and normal of a hit"),
    Room(LIGHT, (BASE, SCENE, POINTS), "the light model: the colour of a surface point"),
    Room(FILM, (BASE, CONTRACT, SCENE, FRAME), "colours become pixels"),
    Room(CORE, (BASE, CONTRACT, SCENE, FRAME, TILES, CAST, POINTS, LIGHT, FILM),
         "all of these steps, tile by tile"),
    Room(FILTERS, (BASE, NORMALS), "`vtkLambentNormals`; VTK's arrays and threads for the core"),
    Room(RENDERING, (BASE, NORMALS, CONTRACT, SCENE, FRAME, FILM, CORE, FILTERS),
         "`vtkLambentRayTracer`; VTK's cameras, lights, properties and meshes as a scene"),
    Room(COMPARISON, (), "`vtkLambentImageComparison`, `vtkLambentPNGReader`, image tests"),
    Room(COMMAND, (FILTERS, RENDERING, COMPARISON), "the command `lambent`"),
)


def sources(room):
    """The files of a room: of its folder, or of all below the command's."""
    folder = ROOT / room.folder
    every = folder.rglob("*") if room.folder == COMMAND else folder.glob("*")
    return sorted(path for path in every if path.suffix in (".h", ".cxx"))


def rooms_of_headers():
    """Maps each header name to the rooms that have a header of that name."""
    found = collections.defaultdict(set)
    for room in ROOMS:
        for path in sources(room):
            if path.suffix == ".h":
                found[path.name].add(room.folder)
    return found


def included(path):
    return re.findall(r'^#include "(?:[\w/]*/)?(\w+\.h)"', path.read_text(), re.MULTILINE)


def wrong_includes():
    """One line for each include that goes up or sideways."""
    headers = rooms_of_headers()
    lines = []
    for room in ROOMS:
        allowed = {room.folder, *room.includes}
        for path in sources(room):
            for header in included(path):
                if header in headers and not headers[header] & allowed:
                    lines.append(f"{path.relative_to(ROOT)} includes {header} of "
                                 f"{', '.join(sorted(headers[header]))}")
    return lines


def table():
    """The map, in Markdown."""
    short = lambda folder: f"`{folder.removeprefix('Rendering/Core/')}`"
    rows = ["| folder | contents | includes |", "|---|---|---|"]
    for room in ROOMS:
        rows.append(f"| `{room.folder}/` | {room.purpose} | {', '.join(map(short, room.includes))} |")
    return "\n".join(rows)


if __name__ == "__main__":
    print(table())
