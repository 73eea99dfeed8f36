# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scenes, by subject. known.py lists those that the two renderers draw differently."""

import materials as m
from meshes import (
    balls, blocks, bowl, coarse, coincident, cube, far_away, ghosts, layers, mixed, polygons, sphere, strips, wave,
    with_long_normals, with_normals, with_own_table, without_polygons)
from scene import Actor, Colours, matrix, scene

FLAT, GOURAUD, PHONG = range(3)
POINTS, WIREFRAME, SURFACE = range(3)
HEADLIGHT, CAMERA_LIGHT, SCENE_LIGHT = 1, 2, 3
HEIGHT = (-1.4, 2.2)  # about the range of the array "height"
FLAT_FACES = {"Interpolation": FLAT}
PARALLEL = {"ParallelProjection": True, "ParallelScale": 1.2}
INTO_THE_BOWL = {"Position": (2.8, -1.7, 1.5)}


def light(**values):
    return {"LightType": SCENE_LIGHT, "Position": (1.5, 2, 3), **values}


def point_light(**values):
    return light(Positional=True, **{"ConeAngle": 90, "Position": (0.5, 0.4, 1.2), **values})


LIGHTS = [
    scene("light-headlight", sphere),
    scene("light-directional", wave, lights=(light(),)),
    scene("light-from-below", sphere, lights=(light(Position=(0, -3, 0.5)),)),
    scene("light-point", wave, lights=(point_light(),)),
    scene("light-cone", wave, lights=(point_light(ConeAngle=25, Exponent=1, FocalPoint=(0.2, 0.1, 0)),)),
    scene("light-cone-exponent", wave, lights=(point_light(ConeAngle=40, Exponent=6),)),
    scene("light-attenuation", wave, lights=(point_light(AttenuationValues=(0.4, 0.3, 0.5)),)),
    scene("light-coloured", wave, lights=(light(Color=(1, 0.5, 0.1), Intensity=0.8),)),
    scene("light-several", sphere, lights=(
        light(Color=(1, 0.2, 0.2)), light(Color=(0.2, 1, 0.2), Position=(-3, 1, 1)), point_light(
            Color=(0.3, 0.3, 1), Position=(0, -1.5, 1.5)), {"LightType": HEADLIGHT, "Intensity": 0.2})),
    scene("light-of-camera", sphere, lights=({"LightType": CAMERA_LIGHT, "Position": (1, 1, 1)},)),
    scene("light-of-camera-point", wave, lights=(
        {"LightType": CAMERA_LIGHT, "Positional": True, "ConeAngle": 90, "Position": (0.2, 0.1, 0.4)},)),
    scene("light-off", wave, lights=(light(), light(Position=(-3, 1, 1), Switch=False))),
    scene("light-none-is-on", sphere, lights=(light(Switch=False),)),
    scene("light-headlight-dim", sphere, lights=(
        {"LightType": HEADLIGHT, "Intensity": 0.5, "Color": (1, 0.7, 0.4)},)),
    scene("light-cone-of-120", wave, lights=(point_light(ConeAngle=120, Exponent=3),)),
    scene("light-headlight-point", wave, lights=(
        {"LightType": HEADLIGHT, "Positional": True, "ConeAngle": 90},)),
    scene("light-transformed", wave, lights=(
        point_light(TransformMatrix=matrix(0, -1, 0, 0.2, 1, 0, 0, 0.1, 0, 0, 1, 0.3)),)),
    scene("light-bright", sphere, lights=(light(Intensity=2.5),)),
    scene("ambient", sphere, {"Ambient": 0.3, "Diffuse": 0.6, "AmbientColor": (0.2, 0.4, 1)}),
    scene("ambient-dim", sphere, {"Ambient": 0.3, "Diffuse": 0.6}, lights=(light(Intensity=0.5),)),
    scene("ambient-several", sphere, {"Ambient": 0.3, "Diffuse": 0.6},
          lights=(light(), light(Position=(-3, 0, 0), Color=(1, 0, 0)))),
]

SHADING = [
    scene("flat", coarse, {"Interpolation": FLAT}),
    scene("flat-of-cell-normals", lambda: cube(normals=True), {"Interpolation": FLAT}),
    scene("flat-with-point-normals", lambda: sphere(16), {"Interpolation": FLAT}),
    scene("phong", lambda: sphere(12), {"Interpolation": PHONG}),
    scene("gouraud", lambda: sphere(12), {"Interpolation": GOURAUD}),
    scene("unlit", sphere, {"Lighting": False, "Color": (0.3, 0.7, 0.4)}),
    scene("unlit-coloured", wave, {"Lighting": False}, Colours("height", range=HEIGHT)),
    scene("unlit-with-coefficients", sphere,
          {"Lighting": False, "Ambient": 0.3, "Diffuse": 0.6, "AmbientColor": (0.2, 0.4, 1)}),
    scene("normals-of-any-length", with_long_normals),
    scene("normals-against-the-winding", lambda: with_normals(lambda normals: -normals)),
    scene("normals-missing", lambda: coarse(normals=False)),
    scene("normals-missing-cube", cube),
    scene("normals-of-cells-only", lambda: cube(normals=True)),
    scene("back-two-sided", bowl, camera=INTO_THE_BOWL),
    scene("back-one-sided", bowl, camera=INTO_THE_BOWL, two_sided=False, lights=(light(),)),
]

CELLS = [
    scene("quads", lambda: wave(13, quads=True)),
    scene("polygons", polygons, FLAT_FACES, Colours("region", cells=True, range=(0, 6))),
    scene("strips", strips, None, Colours("region", cells=True, range=(0, 4))),
    scene("faces-of-a-cube", cube, FLAT_FACES, Colours("region", cells=True, range=(0, 5))),
    scene("polygons-and-strips", lambda: mixed(thin=False), FLAT_FACES, Colours("number", cells=True, range=(0, 0.5))),
    scene("coincident", coincident, FLAT_FACES, Colours("region", cells=True, range=(0, 2))),
    scene("overlapping", layers, FLAT_FACES, Colours("region", cells=True, range=(0, 2))),
    scene("several-actors", [
        Actor(sphere, {"Color": (0.9, 0.3, 0.2)}),
        Actor(wave, {"Color": (0.3, 0.4, 0.9)}, matrix=matrix(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0.3)),
        Actor(cube, {"Interpolation": FLAT}, matrix=matrix(.6, 0, 0, 1, 0, .6, 0, 0.5, 0, 0, .6, 0.6))]),
]

COLOURS = [
    scene("colours-of-points", wave, None, Colours("height", range=HEIGHT)),
    scene("colours-of-cells", coarse, FLAT_FACES, Colours("region", cells=True, range=(0, 4))),
    scene("colours-default-table", wave, None, Colours("height", range=(0.0, 1.0))),
    scene("colours-default-range", wave, None, Colours("height")),
    scene("colours-of-the-arrays-table", with_own_table, None, Colours("height", table=m.table)),
    scene("colours-of-points-flat", coarse, FLAT_FACES, Colours("height", range=HEIGHT)),
    scene("colours-table-range", wave, None, Colours("height", table=lambda: m.table(TableRange=HEIGHT))),
    scene("colours-component", wave, None, Colours("vector", component=1, table=m.table, range=(-1, 1))),
    scene("colours-magnitude", wave, None, Colours("vector", component=-1, table=m.table, range=(0, 2.5))),
    scene("colours-magnitude-of-one", wave, None, Colours("height", component=-1, table=m.table, range=HEIGHT)),
    scene("colours-rgb", wave, None, Colours("rgb")),
    scene("colours-rgb-of-cells", coarse, FLAT_FACES, Colours("cell rgb", cells=True)),
    scene("colours-grey", wave, None, Colours("grey")),
    scene("colours-log", wave, None, Colours("positive", table=m.logarithmic, range=(0.02, 30))),
    scene("colours-log-before", wave, None, Colours("positive", table=m.logarithmic, range=(0.02, 30), before=True)),
    scene("colours-limits-of-cells", coarse, FLAT_FACES,
          Colours("number", cells=True, table=m.limited, range=(0.2, 0.8))),
    scene("colours-limits", wave, None, Colours("holed", table=m.limited, range=(-0.5, 0.9))),
    scene("colours-limits-before", wave, None, Colours("height", table=m.limited, range=(-0.5, 0.9), before=True)),
    scene("colours-nan-before", wave, None, Colours("holed", table=m.limited, range=(-0.5, 0.9), before=True)),
    scene("colours-transfer", wave, None, Colours("height", table=m.function)),
    scene("colours-transfer-before", wave, None, Colours("height", table=m.function, before=True)),
    scene("colours-diverging", wave, None, Colours("height", table=m.diverging)),
    scene("colours-indexed", coarse, FLAT_FACES, Colours("region", cells=True, table=m.annotated)),
    scene("colours-before", wave, None, Colours("height", range=HEIGHT, before=True)),
    scene("colours-range-of-one-value", wave, None, Colours("height", range=(0.5, 0.5))),
    scene("colours-range-of-one-value-before", wave, None, Colours("height", range=(0.5, 0.5), before=True)),
    scene("colours-bands", wave, None, Colours("height", table=lambda: m.table(9), range=HEIGHT, before=True)),
    scene("colours-with-ambient", sphere, {"Ambient": 0.4, "Diffuse": 0.5}, Colours("height", range=HEIGHT)),
    scene("colours-of-quads", lambda: wave(5, quads=True), None, Colours("height", range=HEIGHT)),
]

BLOCKS = [
    scene("blocks", blocks),
    scene("blocks-coloured", blocks, blocks=m.block_colours),
    scene("blocks-hidden", blocks, blocks=m.block_visibility),
    scene("blocks-of-one-array", blocks, None, Colours("height", range=HEIGHT)),
    scene("blocks-array-and-colour", blocks, None, Colours("height", range=HEIGHT), blocks=m.block_colours),
]

MIRROR = matrix(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0)

TRANSFORMS = [
    scene("transform-turned", cube, FLAT_FACES, matrix=matrix(0.8, -0.6, 0, 0.2, 0.6, 0.8, 0, -0.1, 0, 0, 1, 0.4)),
    scene("transform-scaled", sphere, matrix=matrix(1.3, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.8, 0)),
    scene("transform-sheared", wave, matrix=matrix(1, 0.4, 0, 0, 0, 1, 0, 0.1, 0.3, 0, 0.7, 0)),
    scene("transform-mirrored", sphere, matrix=MIRROR),
    scene("transform-mirrored-culled", bowl, {"BackfaceCulling": True}, matrix=MIRROR, camera=INTO_THE_BOWL),
    scene("transform-mirrored-without-normals", coarse, FLAT_FACES, matrix=MIRROR),
    scene("far-away", far_away, camera={"Position": (2e5 + 0.9, 2e5 - 1.4, 2e5 + 3.6), "FocalPoint": 3 * (2e5,)}),
    scene("ghosts", ghosts),
]

SPHERES = [
    scene("spheres", balls, radius=0.3),
    scene("spheres-of-array", balls, radii="radius"),
    scene("spheres-of-array-and-factor", balls, radii="radius", radius=0.7),
    scene("spheres-coloured", balls, None, Colours("height", range=(0, 1)), radii="radius", lights=(light(),)),
    scene("spheres-transformed", balls, radius=0.3, matrix=matrix(0.5, 0, 0, 0, 0, 0.5, 0, 0.2, 0, 0, 0.5, 0)),
    scene("spheres-impostors", balls, radius=0.3, impostors=True, camera={"ParallelProjection": True}),
]

VIEWS = [
    scene("culled-backs", bowl, {"BackfaceCulling": True}, camera=INTO_THE_BOWL),
    scene("culled-fronts", bowl, {"FrontfaceCulling": True}, camera=INTO_THE_BOWL),
    scene("culled-both", bowl, {"BackfaceCulling": True, "FrontfaceCulling": True}, camera=INTO_THE_BOWL),
    scene("tiny-triangles", lambda: sphere(200), camera={"Position": (2, -3, 8)}),
    scene("parallel", sphere, camera=PARALLEL),
    scene("parallel-point-light", wave, camera=PARALLEL,
          lights=(point_light(),)),
    scene("parallel-flat", coarse, FLAT_FACES, camera=PARALLEL),
    scene("wide-angle", wave, camera={"ViewAngle": 110, "Position": (0.2, -0.6, 0.8)}),
    scene("horizontal-angle", cube, FLAT_FACES, camera={"UseHorizontalViewAngle": True, "ViewAngle": 40}),
    scene("window-centre", sphere, camera={"WindowCenter": (0.3, -0.2)}),
    scene("window-centre-parallel", sphere, camera={**PARALLEL, "WindowCenter": (0.2, 0.3)}),
    scene("rolled", cube, FLAT_FACES, camera={"ViewUp": (0.7, 0.7, 0.2)}),
    scene("clipping-range", sphere, camera={"ClippingRange": (3.2, 3.9)}),
    scene("through-the-surface", wave, camera={"Position": (0, -1.2, 0.15), "FocalPoint": (0, 0, 0.1)}),
]

TRANSLUCENT = [
    scene("opacity", sphere, {"Opacity": 0.5}),
    scene("opacity-culled", sphere, {"Opacity": 0.7, "BackfaceCulling": True}, lights=(light(),)),
    scene("opacity-unlit", bowl, {"Opacity": 0.4, "Lighting": False}, camera=INTO_THE_BOWL),
    scene("opacity-of-layers", layers, {"Opacity": 0.4}, Colours("region", cells=True, range=(0, 2))),
    scene("opacity-of-rgba", wave, None, Colours("rgba")),
    scene("opacity-of-rgba-times-property", wave, {"Opacity": 0.5}, Colours("rgba")),
    scene("opacity-of-grey-and-alpha", wave, None, Colours("grey alpha")),
    scene("opacity-of-table", wave, None, Colours("height", table=m.translucent, range=HEIGHT)),
    scene("opacity-of-table-before", wave, None,
          Colours("height", table=m.translucent, range=HEIGHT, before=True)),
    scene("opacity-of-blocks", blocks, blocks=m.block_opacity),
    scene("opacity-of-spheres", balls, {"Opacity": 0.5}, radius=0.3, lights=(light(),)),
    scene("opacity-before-opaque", [
        Actor(sphere, {"Color": (0.9, 0.3, 0.2)}),
        Actor(wave, {"Opacity": 0.3, "Color": (0.3, 0.4, 0.9)}, matrix=matrix(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0.6))]),
]
for each in TRANSLUCENT:
    each.awaits = ("opacity",)

WHITE = {"Color": (1, 1, 1)}

TEXTURES = [
    scene("texture-repeated", wave, WHITE, texture=m.chequers),
    scene("texture-clamped", wave, WHITE, texture=lambda: m.chequers(True, m.vtkTexture.ClampToEdge)),
    scene("texture-mirrored", wave, {"Color": (0.6, 1, 0.8)},
          texture=lambda: m.chequers(True, m.vtkTexture.MirroredRepeat)),
    scene("texture-with-border", wave, WHITE, texture=lambda: m.chequers(False, m.vtkTexture.ClampToBorder)),
    scene("texture-and-colours", wave, None, Colours("height", range=HEIGHT), texture=m.chequers),
    scene("texture-unlit", wave, {**WHITE, "Lighting": False}, texture=m.chequers),
    scene("texture-of-srgb", wave, WHITE, texture=lambda: m.chequers(UseSRGBColorSpace=True)),
    scene("texture-of-grey", wave, WHITE, texture=m.grey_bytes),
    scene("texture-of-numbers", wave, WHITE, texture=m.numbers),
    scene("texture-transformed", wave, WHITE, texture=m.turned),
    scene("texture-and-highlights", wave, {"Specular": 0.7, "SpecularPower": 10}, texture=m.chequers,
          lights=(point_light(),), awaits=("specular",)),
    scene("texture-with-alpha", wave, WHITE, texture=lambda: m.chequers(alpha=True), awaits=("opacity",)),
    scene("texture-with-opacity", wave, {**WHITE, "Opacity": 0.5}, texture=m.chequers, awaits=("opacity",)),
]
for each in TEXTURES:
    each.awaits += ("textures",)

UNLIT = {"Lighting": False}

THIN = [
    scene("lines", without_polygons, {"Color": (1, 0.9, 0.2), **UNLIT}),
    scene("lines-wide", without_polygons, {"LineWidth": 5, **UNLIT}, Colours("number", cells=True, range=(0, 1))),
    scene("lines-coloured", without_polygons, {"LineWidth": 3, **UNLIT}, Colours("height", range=(-1, 1))),
    scene("lines-lit", without_polygons, {"LineWidth": 2}),
    scene("lines-with-normals", lambda: without_polygons(normals=True), {"LineWidth": 2}, lights=(light(),)),
    scene("lines-as-tubes", without_polygons, {"LineWidth": 6, "RenderLinesAsTubes": True}, camera=PARALLEL),
    scene("lines-on-a-surface", [
        Actor(wave), Actor(wave, {"Representation": WIREFRAME, "Color": (0, 0, 0.6), **UNLIT})]),
    scene("vertices", lambda: without_polygons(vertices=True), {"PointSize": 7, **UNLIT},
          Colours("height", range=(-1, 1))),
    scene("vertices-with-normals", lambda: without_polygons(vertices=True, normals=True), {"PointSize": 5},
          lights=(light(),)),
    scene("vertices-as-spheres", lambda: without_polygons(vertices=True),
          {"PointSize": 12, "RenderPointsAsSpheres": True}),
    scene("vertices-as-spheres-parallel", lambda: without_polygons(vertices=True),
          {"PointSize": 12, "RenderPointsAsSpheres": True}, camera=PARALLEL, lights=(light(),)),
    scene("vertices-of-a-surface", lambda: coarse(normals=True),
          {"VertexVisibility": True, "VertexColor": (0.8, 0, 0), "PointSize": 5}),
    scene("mixed-cells", mixed, {"PointSize": 6, "LineWidth": 3, **UNLIT},
          Colours("number", cells=True, range=(0, 1))),
    scene("wireframe", coarse, {"Representation": WIREFRAME, **UNLIT}),
    scene("wireframe-of-polygons", polygons, {"Representation": WIREFRAME, "LineWidth": 2, **UNLIT}),
    scene("wireframe-with-normals", lambda: coarse(normals=True), {"Representation": WIREFRAME, "LineWidth": 2}),
    scene("wireframe-of-cells", coarse, {"Representation": WIREFRAME, "LineWidth": 2, **UNLIT},
          Colours("region", cells=True, range=(0, 4))),
    scene("points", coarse, {"Representation": POINTS, "PointSize": 5, **UNLIT}),
    scene("points-with-normals", lambda: sphere(16), {"Representation": POINTS, "PointSize": 4}),
]
for each in THIN:
    each.awaits, each.thin = ("lines",), "lines"

EDGES = [
    scene("edges", lambda: coarse(normals=True), {"EdgeVisibility": True, "EdgeColor": (0.1, 0.1, 0.5)}),
    scene("edges-wide", lambda: wave(7, quads=True), {"EdgeVisibility": True, "LineWidth": 4}),
    scene("edges-coloured", cube, {"EdgeVisibility": True, "LineWidth": 2, **FLAT_FACES},
          Colours("region", cells=True, range=(0, 5))),
]
for each in EDGES:
    each.awaits, each.thin = ("edges",), "blended"

SPECULAR = [
    scene("specular", sphere, {"Specular": 0.6, "SpecularPower": 20}),
    scene("specular-coloured", sphere, {"Specular": 0.8, "SpecularPower": 8, "SpecularColor": (0.2, 0.9, 0.3)},
          lights=(light(),)),
    scene("specular-point-light", wave, {"Specular": 0.7, "SpecularPower": 30, "Color": (0.2, 0.3, 0.7)},
          lights=(point_light(),)),
    scene("specular-of-light", sphere, {"Specular": 0.8, "SpecularPower": 8},
          lights=(light(DiffuseColor=(1, 0.5, 0.3), SpecularColor=(0.2, 0.4, 1)),)),
    scene("specular-flat", coarse, {"Specular": 0.6, "SpecularPower": 15, **FLAT_FACES}, lights=(light(),)),
    scene("specular-spheres", balls, {"Specular": 0.6, "SpecularPower": 15}, radius=0.3, lights=(light(),)),
    scene("specular-and-colours", wave, {"Specular": 0.5, "SpecularPower": 25}, Colours("height", range=HEIGHT),
          lights=(point_light(), light(Intensity=0.3))),
    scene("specular-parallel", sphere, {"Specular": 0.6, "SpecularPower": 10}, lights=(light(),),
          camera=PARALLEL),
]
for each in SPECULAR:
    each.awaits = ("specular",)

SCENES = (LIGHTS + SHADING + CELLS + COLOURS + BLOCKS + TRANSFORMS + SPHERES + VIEWS + TRANSLUCENT + TEXTURES +
          THIN + EDGES + SPECULAR)
