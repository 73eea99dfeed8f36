# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""What run.py breaks: (file, text that occurs once, its replacement, what that breaks).

Mutations of bounds make them keep too little. Keeping too much only costs time, which no test can
detect. The same holds for a condition that others imply: a triangle whose edge functions sum to zero
is not hit, but its depth, 0 / 0, would prevent that, too; and the kernel of small triangles leaves
those much larger than their box open, though its bound grows with them.
"""

CONTRACT = "Rendering/Core/Contract/ImageContract.h"
FRAME = "Rendering/Core/Frame/CameraFrame.h"
CAMERA = "Rendering/Core/Frame/CameraFrame.cxx"
ELEMENTARY = "Filters/Base/Elementary.cxx"
LATTICE = "Rendering/Core/Tiles/PointLattice.cxx"
LATTICE_KERNEL = "Rendering/Core/Tiles/LatticeKernel.cxx"
TRIANGLE_BINNING = "Rendering/Core/Tiles/TriangleBinning.cxx"
COVERAGE = "Rendering/Core/Tiles/CoverageKernel.cxx"
EDGES = "Rendering/Core/Cast/EdgeFunctions.h"
SETUP = "Rendering/Core/Cast/CastingSetup.h"
EXACT = "Rendering/Core/Cast/ExactRow.h"
NEAREST = "Rendering/Core/Cast/Nearest.h"
SHADING_KERNEL = "Rendering/Core/Light/ShadingKernel.cxx"
PAINTING = "Rendering/Core/Painting.cxx"
TRIANGULATION = "Rendering/Core/Scene/Triangulation.cxx"
EARS = "Rendering/Core/Scene/Ears.h"
TOUCHING = "Rendering/Core/Scene/TouchingPolygon.cxx"
NORMAL = "Filters/Core/NormalContribution.h"
MERGED = "Filters/Core/MergedFaces.cxx"
NORMAL_KERNEL = "Filters/Core/NormalKernel.cxx"
ANGLES = "Filters/Core/CornerAngles.h"
SHARP = "Filters/Core/SharpEdges.cxx"
CREASES = "Filters/Core/Creases.h"
CREASE_KERNEL = "Filters/Core/CreaseKernel.cxx"
CREASED = "Filters/Core/CreasedPoint.h"
CHECKED = "Filters/Core/CheckedFaces.cxx"
CORNERS = "Filters/Core/CornerNormals.cxx"
TRIANGLE_NORMALS = "Filters/Core/TriangleNormals.cxx"
ARITHMETIC = "Filters/Base/Arithmetic.h"
EDGE_WIDTH = "Rendering/Core/Frame/CellEdges.h"
EDGE_LINES = "Rendering/Core/Contract/EdgeLines.h"
CELL_EDGES = "Rendering/Core/Frame/CellEdges.cxx"
LIGHT = "Rendering/Core/Light/LightModel.cxx"
VECTOR_LIGHTS = "Rendering/Core/Light/VectorLights.h"
TRIANGLE_POINTS = "Rendering/Core/SurfacePoints/TrianglePoints.cxx"
VECTOR_POINTS = "Rendering/Core/SurfacePoints/VectorTrianglePoints.h"
RUNS = "Rendering/Core/SurfacePoints/VectorSurfacePoint.h"
BYTES = "Rendering/Core/Film/ByteKernel.cxx"
SAMPLES = "Rendering/Core/SurfacePoints/SampleBatch.h"
LOADING = "Rendering/Core/SurfacePoints/LoadTriangles.cxx"
FILM = "Rendering/Core/Film/Film.cxx"
BACKGROUND = "Rendering/Core/Film/Background.cxx"
RUN_RANGE = "Rendering/Core/SurfacePoints/RunRange.cxx"
HITS = "Rendering/Core/Frame/VectorHits.h"
FILM_COLORS = "Rendering/Core/Film/Film.h"
POINT_STORE = "Rendering/Core/SurfacePoints/VectorPointBatch.h"
PASSES = "Rendering/Core/PassPainting.cxx"
TILE_TASKS = "Rendering/Core/TileTasks.cxx"
SCENE_MESH = "Rendering/Core/Scene/SceneMesh.cxx"
IMAGE = "Rendering/Core/Film/Image.h"
FILL_KERNEL = "Rendering/Core/Film/FillKernel.cxx"
CORNER_ATTRIBUTE = "Rendering/Core/SurfacePoints/CornerAttribute.h"
PASS_TABLE = "Rendering/Core/PassTable.h"
PASS_STORE = "Rendering/Core/Film/PassStore.h"
ATTRIBUTE = "Filters/Base/AttributeSpan.h"
SPANS = "Filters/SpansFromVTK.cxx"
INPUTS = "Rendering/InputSurfaces.cxx"
PASS_ARRAYS = "Rendering/PassArrays.cxx"
COLOR_TABLE = "Rendering/Core/Scene/ColorTable.cxx"
COLOR_TABLE_HEADER = "Rendering/Core/Scene/ColorTable.h"
COLOR_ARRAY = "Rendering/Core/Scene/ColorArray.h"
SURFACE_COLOR = "Rendering/Core/SurfacePoints/SurfaceColor.cxx"
VECTOR_COLOR = "Rendering/Core/SurfacePoints/VectorSurfaceColor.h"
COLORS = "Rendering/ColorsFromVTK.cxx"
COLORS_OF_INPUTS = "Rendering/ColorsOfInputs.cxx"
SURFACE = "Rendering/Core/Scene/Surface.h"
SPHERE_HITS = "Rendering/Core/Frame/VectorSpheres.h"
SPHERE_BOXES = "Rendering/Core/Tiles/SphereBoxKernel.cxx"
SPHERE_BINNING = "Rendering/Core/Tiles/SphereBinning.cxx"
SPHERE_CASTING = "Rendering/Core/Cast/SphereCastingKernel.cxx"
SPHERE_POINTS = "Rendering/Core/SurfacePoints/SpherePoints.cxx"
LOADING_SPHERES = "Rendering/Core/SurfacePoints/LoadSpheres.cxx"
VECTOR_SPHERE_POINTS = "Rendering/Core/SurfacePoints/VectorSpherePoints.h"
LOOKUP_TABLE = "Rendering/LookupTableFromVTK.cxx"
TEXTURE = "Rendering/Core/Scene/Texture.cxx"
TEXTURE_FACTORS = "Rendering/Core/SurfacePoints/TextureFactors.cxx"
TEXTURE_FROM_VTK = "Rendering/TextureFromVTK.cxx"
RAY_TRACER_INPUTS = "Rendering/vtkLambentRayTracerInputs.cxx"
SPHERES_FROM_VTK = "Rendering/SpheresFromVTK.cxx"
LINE_CONTRACT = "Rendering/Core/Contract/LineContract.h"
LINE_BOUNDS = "Rendering/Core/Frame/LineBounds.h"
LINE_BINNING = "Rendering/Core/Tiles/LineBinning.cxx"
LINE_POINTS = "Rendering/Core/SurfacePoints/LinePoints.cxx"
CELL_LINES = "Rendering/Core/Scene/CellLines.cxx"
LINES_FROM_VTK = "Rendering/LinesFromVTK.cxx"
TRANSFORM = "Rendering/Core/Scene/Transform.h"
COFACTORS = "Rendering/Core/Scene/Transform.cxx"
DRAWN = "Rendering/Core/Scene/DrawnTriangles.cxx"
BLOCKS = "Rendering/InputBlocks.cxx"
SURFACE_FROM_VTK = "Rendering/SurfaceFromVTK.cxx"
OUTPUT_IMAGE = "Rendering/OutputImage.cxx"
SCENE_FROM_SETTINGS = "Rendering/SceneFromSettings.cxx"
SORTED_LAYERS = "Rendering/Core/Cast/SortedLayers.cxx"
SAMPLE_SHADING = "Rendering/Core/SampleShading.cxx"
LAYER_PAINTING = "Rendering/Core/LayerPainting.cxx"
COLOR_MAPS = "Rendering/CommandLine/ColorMaps.cxx"
COLOR_BY = "Rendering/CommandLine/ColorBy.cxx"
PLY_VERTICES = "Rendering/CommandLine/Reading/PlyVertices.cxx"
MATERIAL_INPUTS = "Rendering/CommandLine/MaterialInputs.cxx"
COVER_WITH_TEXTURE = "Rendering/CommandLine/CoverWithTexture.cxx"
IDLE_PROPERTY = "Rendering/CommandLine/IdleProperty.cxx"
NOTHING_SEEN = "Rendering/CommandLine/NothingSeen.cxx"

MUTATIONS = [
    # The contract's arithmetic.
    (ARITHMETIC, "(a.x * b.x + a.y * b.y) + a.z * b.z", "a.x * b.x + (a.y * b.y + a.z * b.z)",
     "dot products are summed in order"),
    (ARITHMETIC, "a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z",
     "a.z * b.y - a.y * b.z, a.z * b.x - a.x * b.z", "cross products have the right signs"),
    (ARITHMETIC, "return { a.x / l, a.y / l, a.z / l };",
     "return { a.x * (1 / l), a.y * (1 / l), a.z * (1 / l) };", "vectors are divided by their lengths"),
    (CONTRACT, "b.x - x * b.w", "b.x - x * c.w", "each vertex is sheared by its own depth"),
    (CONTRACT, "if (!spansZero(ax, bx, cx) || !spansZero(ay, by, cy))", "if (false)",
     "hits lie in the sheared box"),
    (CONTRACT, "std::min(a, std::min(b, c)) <= 0.0", "std::min(a, std::min(b, c)) < 0.0",
     "the box includes its border"),
    (CONTRACT, "hit.e0 >= 0.0 && hit.e1 >= 0.0", "hit.e0 > 0.0 && hit.e1 >= 0.0",
     "edges belong to the front"),
    (CONTRACT, "hit.e0 <= 0.0 && hit.e1 <= 0.0", "hit.e0 < 0.0 && hit.e1 <= 0.0",
     "edges belong to the back"),
    (CONTRACT, "(hit.e0 + hit.e1) + hit.e2;", "hit.e0 + (hit.e1 + hit.e2);",
     "edge functions are summed in order"),
    (CONTRACT, "(hit.e0 * a.z + hit.e1 * b.z) + hit.e2 * c.z",
     "hit.e0 * a.z + (hit.e1 * b.z + hit.e2 * c.z)", "the depth is summed in order"),
    (CONTRACT, "hit.sum != 0.0 && hit.depth > 0.0", "hit.sum != 0.0",
     "triangles behind the eye are not hit"),
    (CONTRACT, " && hit.depth < std::numeric_limits<double>::infinity();", ";",
     "depths that overflow are not hit"),
    (CONTRACT, "255.0 * clamped + 0.5", "255.0 * clamped + 0.499", "bytes are rounded"),
    (CONTRACT, "(value < 1.0 ? value : 1.0)", "value", "bytes are clamped"),
    # The camera.
    (FRAME, "return ((i + 0.5) - this->centerX) * this->pixel;",
     "return (i - this->centerX) * this->pixel;", "rays go through the centres of columns"),
    (FRAME, "return ((j + 0.5) - this->centerY) * this->pixel;",
     "return (j + 0.5) * this->pixel - this->centerY * this->pixel;",
     "rows are moved before they are scaled"),
    (FRAME, "this->parallel ? 1.0 : z };", "z };", "parallel views do not divide"),
    (FRAME, "this->parallel ? across + this->forward * depth", "this->parallel ? across",
     "points of a parallel view have a depth"),
    (CAMERA, "this->up = cross(this->right, this->forward);",
     "this->up = normalized(camera.viewUp);", "the up axis is orthogonal"),
    (CAMERA, "2.0 * camera.parallelScale / height", "2.0 * camera.parallelScale / width",
     "the parallel scale spans the height"),
    (CAMERA, "camera.horizontalViewAngle ? width : height);",
     "camera.horizontalViewAngle ? height : width);", "the view angle spans the height"),
    (CAMERA, "0.5 * height - (0.5 * height) * camera.windowCenter[1]",
     "0.5 * height + (0.5 * height) * camera.windowCenter[1]", "the window centre has the right sign"),
    (CAMERA, "constexpr double parallelSine = 1e-10;", "constexpr double parallelSine = 0.0;",
     "a view-up nearly parallel to the direction is refused"),
    # Bounds and float arithmetic: they may keep too much, never too little.
    (LATTICE, "std::max(u - axis.margin, 0.0)", "std::max(u, 0.0)",
     "a point on a sample's ray is on both sides of it (left)"),
    (LATTICE, "u + axis.margin + 1.0", "u + 1.0", "a point on a sample's ray is on both sides of it (right)"),
    (LATTICE, "(end + (1 << shift) - 1) >> shift", "end >> shift", "groups of samples are whole"),
    (LATTICE_KERNEL, "hn::Max(hn::Sub(u, margin), zero)", "hn::Max(u, zero)",
     "the kernel's margin (left)"),
    (LATTICE_KERNEL, "hn::Add(hn::Add(u, margin), hn::Set(d, 1.0))", "hn::Add(u, hn::Set(d, 1.0))",
     "the kernel's margin (right)"),
    (LATTICE_KERNEL, "p + lanes <= end && lattice.isPrecise()", "p + lanes <= end",
     "the kernel locates no points if positions are imprecise"),
    (COVERAGE, "hn::Set(f, 4.0f * moved), hn::Add", "hn::Set(f, 0.0f * moved), hn::Add",
     "hits that float cannot decide are uncertain"),
    (COVERAGE, "hn::And(isRanged, isSmall), error", "isSmall, error",
     "hits beyond the range of float are uncertain"),
    (COVERAGE, "hn::Mul(hn::Div(one, nearest), more)", "hn::Mul(hn::Div(one, nearest), less)",
     "ranges of nearness contain the nearness"),
    (NEAREST, "if (range.low > this->Highs[sample])",
     "if (range.low > this->Lows[sample])", "overlapping ranges are decided by the depth"),
    (EDGES, "scaled(products, std::ldexp(1.0, -46))", "scaled(products, std::ldexp(1.0, -90))",
     "edge functions have error bounds"),
    (SETUP, "hn::IfThenElse(isSteady, scaled(spread, 1.001), hn::Set(d, 1e35))",
     "hn::IfThenElse(isSteady, hn::Zero(d), hn::Set(d, 1e35))",
     "the range of nearness at a sample has a width"),
    (EDGES, "hn::Sub(middle, reach), hn::Add(middle, reach)",
     "hn::Sub(middle, reach), hn::Sub(middle, reach)", "extremes of edge functions over a box"),
    (HITS, "hn::Le(hn::Max(hn::Max(this->e0, this->e1), this->e2), zero)",
     "hn::Lt(hn::Max(hn::Max(this->e0, this->e1), this->e2), zero)", "the kernel's edges belong to the back"),
    (TRIANGLE_BINNING, "nearest = std::min(nearest, p.z);", "nearest = p.z;",
     "the nearest corner bounds the hits of a triangle"),
    (TRIANGLE_BINNING, "isBound = isBound && isZeroOrOrdinary(p.x) && isZeroOrOrdinary(p.y);", "",
     "corners do not bound the hits of a triangle if products underflow"),
    (SETUP, "hn::And(isZeroOrOrdinary(corners[k].x), isZeroOrOrdinary(corners[k].y))",
     "isZeroOrOrdinary(corners[k].z)",
     "the kernel's ranges of nearness do not hold if products underflow"),
    (EXACT, "hn::And(result.isHit(), sheared.spansRay())", "result.isHit()",
     "the kernel's hits lie in the sheared box"),
    (EXACT, "hn::And(hit, hn::Le(result.sum, hn::Zero(d)))",
     "hn::And(hit, hn::Ge(result.sum, hn::Zero(d)))",
     "the kernel culls the right side"),
    (NEAREST, "depth == nearest && primitive < this->Primitives[sample]",
     "depth == nearest && primitive > this->Primitives[sample]",
     "at equal depth the first primitive wins"),
    ("Rendering/Core/Cast/TileHits.h", "this->least = -std::numeric_limits<float>::infinity();", "",
     "what one tile hides is not hidden in the next"),
    # The light model.
    (LIGHT, "light.positional && light.coneAngle < 90.0", "light.positional",
     "cones of 90 degrees or more are ignored"),
    (LIGHT, "light.positional && light.attenuation != Vec3", "light.attenuation != Vec3",
     "directional lights are not attenuated"),
    (TRIANGLE_POINTS, "normal(0) * hit.e0 + normal(1) * hit.e1", "normal(0) * hit.e1 + normal(1) * hit.e0",
     "each normal belongs to its corner"),
    (TRIANGLE_POINTS, "isBack && !this->TwoSided ? -m : m", "isBack ? -m : m",
     "smooth normals face the viewer"),
    (TRIANGLE_POINTS, "isBack && this->TwoSided ? -m : m", "m", "flat normals face the viewer"),
    (TRIANGLE_POINTS, "return cross(b - a, c - a);", "return cross(c - a, b - a);",
     "the geometric normal has the right sign"),
    (LIGHT, "facing / std::sqrt(square * normalSquare)", "facing / std::sqrt(square)",
     "normals are normalized"),
    (LIGHT, "if (facing > 0.0)\n    {\n      reflected", "if (true)\n    {\n      reflected",
     "no light from behind"),
    (LIGHT, "ambient * light;", "ambient;", "the ambient term includes the light"),
    (LIGHT, "(a.x + a.y * distance) + (a.z * distance) * distance",
     "(a.x + a.y * distance) + a.z * distance", "attenuation is quadratic"),
    (LIGHT, "cosine >= source.coneCosine", "cosine > source.coneCosine + 0.01",
     "the cone includes its rim"),
    (LIGHT, "fraction * power(cosine, source.exponent) : 0.0", "fraction : 0.0",
     "the exponent has an effect"),
    (LIGHT, "if (!(distance > 0.0))", "if (false)", "a light at the hit point is not dimmed"),
    (VECTOR_LIGHTS, "hn::Mul(hn::Mul(quadratic, distance), distance)",
     "hn::Mul(quadratic, hn::Mul(distance, distance))", "the kernel multiplies the attenuation in order"),
    (VECTOR_LIGHTS, "hn::IfThenElse(hn::Gt(distance, hn::Zero(d)), fraction, one)", "fraction",
     "the kernel's light at the hit point"),
    (VECTOR_POINTS, "IsTurned(points.isTwoSided() != range.isSmooth)", "IsTurned(points.isTwoSided())",
     "the kernel's normals face the viewer"),
    (BYTES, "hn::Mul(hn::Set(d, 255.0), clamped), hn::Set(d, 0.5)",
     "hn::Mul(hn::Set(d, 255.0), clamped), hn::Set(d, 0.499)", "the kernel's bytes are rounded"),
    (VECTOR_LIGHTS, "hn::Div(facing, hn::Sqrt(hn::Mul(square, normalSquare)))",
     "hn::Div(facing, hn::Mul(hn::Sqrt(square), hn::Sqrt(normalSquare)))",
     "the kernel computes the cosine in order"),
    (RUNS, "hn::TableLookupLanes(hn::LoadU(d, values + this->First), this->Places)",
     "hn::LoadU(d, values + this->First)", "each sample uses the data of its run"),
    (SHADING_KERNEL, "storeWhere(samples.isWanted, color.y, batch.colors[1] + place);",
     "hn::StoreU(color.y, d, batch.colors[1] + place);",
     "samples without hits keep the background"),
    (SAMPLES, "std::fill(runs + width, runs + pieceSize, last);",
     "", "places beyond a piece belong to its last run"),
    (LOADING, "std::fill_n(batch.isWanted, batch.runCount, 0.0);", "",
     "samples of other ranges are not shaded again"),
    ("Rendering/Core/Film/AverageKernel.cxx", "row = 0; row < n; ++row", "row = n - 1; row >= 0; --row",
     "samples are added from the bottom row"),
    ("Rendering/Core/Film/AverageKernel.cxx", "hn::Div(sum, divisor)",
     "hn::Mul(sum, hn::Div(hn::Set(d, 1.0), divisor))",
     "sums of samples are divided"),
    (FILM, "(row * n + n / 2) * stride", "(row * n) * stride", "triangle ids are those of the middle sample"),
    (RUN_RANGE, "if (!current || !current->holds(primitive))", "if (!current)",
     "each run has its own surface"),
    (SAMPLE_SHADING, "if (isOfPrimitives && (range.isUnlit || !range.appearance))", "if (false)",
     "surfaces shaded together keep their colours"),
    (RUN_RANGE, "|| (!this->isUnlit && other.isSmooth != this->isSmooth)", "",
     "flat and smooth surfaces are not shaded together"),
    (RUN_RANGE, "this->hasGivenNormals || other.hasGivenNormals", "this->hasGivenNormals",
     "surfaces with cell normals are shaded separately"),
    (TRIANGLE_BINNING, "+ boxed.begin - boxed.first)", "+ boxed.begin)",
     "triangles of several surfaces keep their numbers"),
    ("Rendering/Core/Tiles/GatheredPoints.h", "|| positions + begin != this->First + this->Count", "",
     "points located together are adjacent"),
    (BACKGROUND, "(j + 0.5)", "(j + 0.0)", "the gradient is evaluated at the centres of rows"),
    # Alpha and the background image.
    (FILM_COLORS, "FilmColor{ divided(color.color, color.alpha), color.alpha }", "color",
     "colours are divided by alpha"),
    (FILM, "alpha > 0.0 ? channels[channel][k] / alpha : 0.0", "channels[channel][k]",
     "the kernel's colours are divided by alpha"),
    (FILM, "alpha > 0.0 ? channels[channel][k] / alpha : 0.0", "channels[channel][k] / alpha",
     "colours are 0 where alpha is"),
    (PAINTING, "batch.isHit(place) ? 1.0 : 0.0", "1.0", "samples that hit nothing have alpha 0"),
    (BYTES, "hn::LoadU(d8, bytes[3] + i)", "hn::LoadU(d8, bytes[2] + i)", "the kernel stores alpha"),
    (BACKGROUND, "? Vec3(0.0)", "? scene.background", "pictures with alpha have no background"),
    (BACKGROUND, "scene.backgroundImage.pixels && !image.hasAlpha", "scene.backgroundImage.pixels",
     "pictures with alpha have no background image"),
    (BACKGROUND, "(k + 0.5) * pixels / samples - 0.5", "(k + 0.5) * pixels / samples",
     "the background image has its colours at the centres of its pixels"),
    (BACKGROUND, "(k + 0.5) * pixels / samples - 0.5", "k * static_cast<double>(pixels) / samples",
     "the background image is evaluated at the centres of samples"),
    (BACKGROUND, "std::min(first + 1.0, last)", "std::max(first - 1.0, 0.0)",
     "background images are interpolated with the next pixel"),
    (BACKGROUND, "fraction == 0.0 ? first : first", "first", "a NaN of weight 0 has no effect"),
    (BACKGROUND, "columns[k].fraction == 0.0 ? a : a", "a",
     "a NaN of weight 0 has no effect in rows of samples"),
    (BACKGROUND, "a + (b - a) * rows.fraction", "b", "rows of samples are interpolated"),
    (BACKGROUND, "alpha == 0.0 ? base : color", "color", "transparent pixels have no colour"),
    (BACKGROUND, "base * (1.0 - alpha)", "base", "opaque background images hide the gradient"),
    (BACKGROUND, "stored / 255.0", "stored / 256.0", "bytes of background images are divided by 255"),
    # Passes.
    (TRIANGLE_POINTS, "(at(0) * weights.x + at(1) * weights.y) + at(2) * weights.z",
     "at(0) * weights.x + (at(1) * weights.y + at(2) * weights.z)", "attributes are summed in order"),
    (TRIANGLE_POINTS, "at(0) * weights.x + at(1) * weights.y", "at(1) * weights.x + at(0) * weights.y",
     "each attribute belongs to its corner"),
    (TRIANGLE_POINTS, "static_cast<std::size_t>(surface.cellOf(triangle))", "triangle",
     "cell attributes are looked up by the input's cell"),
    (TRIANGLE_POINTS, "hit.e1 / hit.sum, hit.e2 / hit.sum", "hit.e2 / hit.sum, hit.e1 / hit.sum",
     "each weight belongs to its corner"),
    (CORNER_ATTRIBUTE, "Corners == 2 ? ofTwo : ofTwo + weighted(c, 2)",
     "Corners == 2 ? ofTwo : weighted(a, 0) + (weighted(b, 1) + weighted(c, 2))", "runs of attributes are summed in order"),
    (CORNER_ATTRIBUTE, "all + components * static_cast<std::size_t>(surface.cellOf(primitive))",
     "all + components * primitive", "attributes of runs are looked up by the input's cell"),
    (VECTOR_POINTS, "hn::Div(hit.e1, hit.sum), hn::Div(hit.e2, hit.sum)",
     "hn::Div(hit.e2, hit.sum), hn::Div(hit.e1, hit.sum)", "each of the kernel's weights belongs to its corner"),
    (ATTRIBUTE, "static_cast<std::size_t>(this->components) + component;",
     "static_cast<std::size_t>(this->components);", "attributes have several components"),
    (ATTRIBUTE, "static_cast<const std::int8_t*>(this->data)", "static_cast<const std::uint8_t*>(this->data)",
     "signed bytes"),
    (PASSES, "for (int i = n / 2; i < window.width(); i += n)", "for (int i = 0; i < window.width(); i += n)",
     "passes show the middle sample"),
    (PASSES, "row[(begin + i) * n + n / 2]", "row[(begin + i) * n]", "the kernel's middle sample"),
    (PASSES, "xs[i] = samples.xs()[(begin + i) * n + n / 2];", "xs[i] = samples.xs()[(begin + i) * n];",
     "the ray of the kernel's middle sample"),
    (PASS_TABLE, "normalized(point.normal)[k]", "point.normal[k]", "normals have length 1"),
    (POINT_STORE, "hn::Sqrt(dot(point.normal, point.normal))", "hn::Set(d, 1.0)",
     "the kernel's normals have length 1"),
    (PASS_TABLE, "(eye + point.position)[k]", "point.position[k]",
     "positions are in world coordinates"),
    (POINT_STORE, "store(eye + point.position,", "store(point.position,",
     "the kernel's positions are in world coordinates"),
    (POINT_STORE, "storeWhere(isWanted, v.y, rows[1] + place);", "hn::StoreU(v.y, d, rows[1] + place);",
     "points of other ranges are not overwritten"),
    (PASSES, "[&](auto* to) { fillWithNaN(to, width * pass.components); }", "[](auto*) {}",
     "tiles without triangles are NaN"),
    (PASSES, "this->storeNothing(piece.i, piece.j, count);", "", "pieces without hits are NaN"),
    (PASS_STORE, "std::isnan(value) ? std::numeric_limits<Value>::quiet_NaN() : static_cast<Value>(value)",
     "static_cast<Value>(value)", "all NaN have the same bits"),
    (SPANS, "isBits ? VTK_UNSIGNED_CHAR : array->GetDataType()", "VTK_DOUBLE", "converted arrays keep their type"),
    (INPUTS, "values.type >= AttributeType::Int32 && values.type != AttributeType::Float",
     "values.type == AttributeType::Double", "integers that float cannot hold become double"),
    (INPUTS, "if (values || !hasValues)", "if (values)", "arrays of empty inputs keep their form"),
    (PASS_ARRAYS, "if (!describeDefect(settings.passArrays).empty())", "if (false)",
     "refused arrays are not also reported as missing"),
    # Elementary functions.
    (ELEMENTARY, "{ 0.017453292519943295, 2.9486522708701687e-19 }", "{ 0.017453292519943295, 0.0 }",
     "the factor of radians has a low part"),
    (ELEMENTARY, "return { high, (a - (high - bPart)) + (b - bPart) };",
     "return { high, b - bPart };", "sums have a low part"),
    (ELEMENTARY, "for (int n = 17; n >= 3; n -= 2)", "for (int n = 13; n >= 3; n -= 2)",
     "the sine has enough terms"),
    (ELEMENTARY, "for (int n = 16; n >= 4; n -= 2)", "for (int n = 12; n >= 4; n -= 2)",
     "the cosine has enough terms"),
    (ELEMENTARY, "for (int n = 27; n >= 7; n -= 2)", "for (int n = 19; n >= 7; n -= 2)",
     "the logarithm has enough terms"),
    (ELEMENTARY, "for (int n = 14; n >= 2; --n)", "for (int n = 10; n >= 2; --n)",
     "the exponential has enough terms"),
    (ELEMENTARY, "{ 0.6931471805599453, 2.3190468138462996e-17 }", "{ 0.6931471805599453, 0.0 }",
     "the logarithm of 2 has a low part"),
    (ELEMENTARY, "r.quadrant == 1 || r.quadrant == 2", "r.quadrant == 2", "the cosine has the right signs"),
    (ELEMENTARY, "tangent = isSwapped ? -quotient", "tangent = isSwapped ? quotient",
     "the tangent has the right signs"),
    # Polygons and strips.
    (MERGED, "points[i + odd], points[i + 1 - odd], points[i + 2]",
     "points[i], points[i + 1], points[i + 2]",
     "triangles of a strip alternate in orientation"),
    (TRIANGULATION, "if (hasBadPoint)", "if (false)", "a bad point invalidates the whole strip"),
    (CHECKED, "result.defect.cell += cellCount(polygons);", "", "strips are numbered after the polygons"),
    (TRIANGULATION, "const bool isConcave = this->Shape.isConcave();",
     "const bool isConcave = false;", "concave polygons are triangulated by ears"),
    (TRIANGULATION, "isConcave || size > 4 ?", "isConcave ?", "repeated corners may hide concave ones"),
    (TRIANGULATION, "this->mendedTurnedArea() < 0.5 * turned", "true",
     "a triangulation is changed only if that improves it"),
    (EARS, ".witness == k)", ".witness == 0)", "an ear is retried after its obstacle is cut"),
    (EARS, "this->tryAgain(corner.next);", "", "the neighbours of a cut ear are tried again"),
    (TOUCHING, "return isOnNewEdge || this->leadsInto(a, b, c, p);", "return false;",
     "no corner lies inside an ear"),
    # Normals.
    (NORMAL, "const Vec3 area = cross(ab, ac);", "const Vec3 area = cross(ac, ab);",
     "normals follow the right-hand rule"),
    (NORMAL, "squaredLength >= std::numeric_limits<double>::min()", "squaredLength >= 0.0",
     "a face without area has no normal"),
    (NORMAL, "add(1, area * (1.0 / (bcSquare * abSquare)));",
     "add(1, area * (1.0 / (acSquare * abSquare)));", "Max weights use the edges at the corner"),
    (NORMAL, "add(2, normal * angles.c);", "add(2, normal * angles.b);",
     "each angle belongs to its corner"),
    (NORMAL, "const bool isReflex = dot(corner, area) < 0.0;", "const bool isReflex = false;",
     "reflex corners have reflex angles"),
    (NORMAL, "scratch.erase(std::unique(scratch.begin(), scratch.end()), scratch.end());", "",
     "repeated points count once"),
    (NORMAL, "while (scratch.size() > 1 && scratch.back() == scratch.front())", "while (false)",
     "repeated points at the end count once"),
    (NORMAL, "const Vec3 next = points[corners[i]] - origin;\n      area = area + cross(previous, next);",
     "const Vec3 next = points[corners[i]];\n      area = area + cross(previous, next);",
     "areas are summed near the origin"),
    (NORMAL_KERNEL, "inverse(hn::Mul(abSquare, acSquare)), inverse(hn::Mul(bcSquare, abSquare))",
     "inverse(hn::Mul(abSquare, acSquare)), inverse(hn::Mul(abSquare, acSquare))",
     "the kernel's Max weights"),
    (NORMAL_KERNEL, "hn::AndNot(hn::Lt(place, hn::Zero(di)), hn::Lt(place, this->Outside))",
     "hn::Lt(place, this->Outside)", "the kernel does not write points of other ranges"),
    (SHARP, "dot(a, b) >= this->Cosine", "dot(a, b) > this->Cosine + 1e-6",
     "edges of exactly the feature angle are smooth"),
    (SHARP, "if (end - side == 2 &&", "if (", "edges of three faces are sharp"),
    (SHARP, "result.copiedPoints.begin() + firstCopy[point + 1], static_cast<std::int64_t>(point)",
     "result.copiedPoints.begin() + firstCopy[point + 1], static_cast<std::int64_t>(0)",
     "copied points have the right source"),
    # Corner normals.
    (CREASES, "!(along > 0.0 && ", "!(", "opposite faces are steep"),
    (CREASES, "along * along >= squaredCosine * square", "along * along > 1.01 * squaredCosine * square",
     "a face at half the feature angle is not steep"),
    (CREASE_KERNEL, "hn::Ge(hn::Mul(along, along), least)", "hn::Ge(along, least)",
     "the kernel compares squares"),
    (CREASED, "a->leaves != b->leaves && ", "", "neighbours have opposite directions along an edge"),
    (CREASED, "return isSmooth && !", "return isSmooth || !", "sharp edges do not join faces"),
    (CREASED, "&& !this->Opposites.areOpposite(this->face(a), this->face(b))", "",
     "opposite faces are never joined"),
    ("Filters/Core/OppositePolygons.h", "second += first == second;", "",
     "the two start positions of a ring differ"),
    (CREASED, "mostSidesAtEdge = 64", "mostSidesAtEdge = 65", "the limit of faces at an edge"),
    (CREASED, "return sum.isDirection ? sum.vector : this->FaceNormals[corner];", "return sum.vector;",
     "if the terms cancel, the face normal is used"),
    (CREASED, "if (groups == 1 && this->isLong(allSum, count))", "if (this->isLong(allSum, count))",
     "each group has its own sum"),
    ("Filters/Core/CornerRange.h", "std::max(cosDegrees(0.5 * angle), 1.0 / (1 << 20))", "cosDegrees(angle)",
     "all faces lie within half the feature angle"),
    (CREASED, "if (place > 0 && ids[place - 1] == point)", "if (false)",
     "in large polygons repeated points count once"),
    (CORNERS, "featureAngle + featureAngleMargin", "featureAngle",
     "rounding does not make edges sharp"),
    (CORNERS, "static_cast<std::int32_t>(first[i]) + use.number", "use.number",
     "additional normals follow those of the points"),
    (TRIANGLE_NORMALS, "normals.numbers.get() + cells.offsets[face]", "normals.numbers.get()",
     "each face has its own normal numbers"),
    (TRIANGLE_POINTS, "const bool isTurned = this->TwoSided && isReversed(surface, triangle);",
     "const bool isTurned = false;", "point normals define the front side"),
    (TRIANGLE_POINTS, "(normal(0) + normal(1)) + normal(2)", "normal(0)",
     "all three point normals define the front side"),
    (VECTOR_POINTS, "given = (given + load(batch.normals + 3, k)) + load(batch.normals + 6, k);", "",
     "the kernel sums all three normals"),
    (ANGLES, "return x < 0.0 ? (piHigh - angle) + piLow : angle;", "return angle;",
     "obtuse angles are supplements"),
    (ANGLES, "if (x <= tangentOfEighth * y)", "if (false)", "angles near 90 degrees"),
    (ANGLES, "const double largest = piHigh - (first + second);",
     "const double largest = piHigh - first;", "the angles of a triangle add up to 180 degrees"),

    # Bands of the picture, and windows of background.
    (IMAGE, "result.bytes += this->bytes ? before * this->channels() : 0;", "", "a band has its own bytes"),
    (IMAGE, "result.primitives += this->primitives ? before : 0;", "", "a band has its own ids"),
    (IMAGE, "before * pass.components * size", "before * size", "a band has its own passes"),
    (TILE_TASKS, "background.i1 = tile.i1;", "", "a window of background includes its last tile"),
    (TILE_TASKS, "tile.i0 == background.i1 && tile.j0", "tile.j0",
     "a window of background contains no other tiles"),
    (TILE_TASKS, "this->merge(hits, *kept);", "", "a tile keeps the hits of all rounds"),
    (FILL_KERNEL, "std::numeric_limits<Value>::quiet_NaN()", "Value(0)", "passes without a hit are NaN"),
    (SCENE_MESH, "block.last == block.first ? block.replacement : block.last", "block.last",
     "blocks of surfaces with one appearance"),
    (SCENE_MESH, "part.firstPoint += block.points;", "", "points are counted over all surfaces"),

    # Colours from arrays.
    (ELEMENTARY, "product(logarithm(scale(x)), InverseLogOf10).high",
     "logarithm(scale(x)).high * InverseLogOf10.high", "decimal logarithms are accurate"),
    (COLOR_TABLE, "if (place > this->High)", "if (place >= this->High)",
     "the end of the range is in the range"),
    (COLOR_TABLE, "(place - this->Low) * this->Factor", "(place - this->Low) * this->Factor + 0.5",
     "intervals of a table begin at the low end"),
    (COLOR_TABLE, "if (this->IsLogarithmic && !(value > 0.0))", "if (false)",
     "numbers without a logarithm have the first colour"),
    (COLOR_ARRAY, "sum += number * number;", "sum = number * number;", "all components count"),
    (COLOR_TABLE_HEADER, "k / 255.0", "k / 256.0", "255 is 1"),
    (SURFACE_COLOR, "surface.colors->color(tuple)",
     "surface.colors->color(primitive)", "colours are those of cells"),
    (SURFACE_COLOR, "color * appearance.ambient, opacity,", "appearance.ambientReflection(), opacity,",
     "colours of arrays replace the ambient colour"),
    (TRIANGLE_POINTS, "colors->number(point(2)) * weights.z;", "colors->number(point(2)) * weights.y;",
     "numbers are interpolated"),
    (VECTOR_COLOR, "hn::Mul(runs(rows[6 + k]), weights.z)", "hn::Mul(runs(rows[6 + k]), weights.y)",
     "colours are interpolated in vectors"),
    (LOADING, "range.isUnlit ? 1.0 : part.appearance->diffuse", "part.appearance->diffuse",
     "unlit colours are not multiplied"),
    (RUN_RANGE, "other.colorSource != this->colorSource", "false",
     "sources of colours are not shaded together"),
    (COLORS, "components == 1 ? 0 : settings.component", "settings.component",
     "the magnitude of a single number is the number"),
    (COLORS, "(hasPointScalars ? ofPoints : ofCells)->GetScalars()", "ofPoints->GetScalars()",
     "active scalars of cells are found"),
    (COLORS_OF_INPUTS, "this->Low = std::min(this->Low, range[0]);", "this->Low = range[0];",
     "blocks share one range"),
    (COLORS_OF_INPUTS, " && !input.color;", ";", "a block's own colour comes first"),
    (LOOKUP_TABLE, "if (table->GetUseAboveRangeColor())", "if (false)", "colours above the range"),
    (COLORS, "    this->Array->GetLookupTable() ?", "    false ?", "a table of the array comes first"),
    # Textures.
    (TEXTURE, "TextureWrap::MirroredRepeat;\n  const double period = isMirrored ? 2.0 * n : n;",
     "TextureWrap::MirroredRepeat;\n  const double period = n;", "mirrored images alternate"),
    (TEXTURE, "place < 0.0 ? place + period : place", "place", "images repeat to the left"),
    (TEXTURE, "s * image.width - 0.5", "s * image.width", "the middle of a pixel has its colour"),
    (TEXTURE, "x <= 0.04045 ? x / 12.92 :", "", "dark sRGB is linear"),
    (TEXTURE_FACTORS, "components > 1 ? at(1) : 0.0", "at(components > 1 ? 1 : 0)",
     "a missing second coordinate is 0"),
    (RUN_RANGE, "other.hasTextures != this->hasTextures", "false",
     "textured surfaces are shaded apart from others"),
    (SHADING_KERNEL, "if (!range.appearance || range.isUnlit)", "if (!range.appearance)",
     "unlit surfaces with a texture are not lit"),
    (TEXTURE_FROM_VTK, "n -= n > 1 ? 1 : 0;", "", "pixels may be the cells of an image"),
    (RAY_TRACER_INPUTS, "*time = std::max(*time, ofImage);", "",
     "pictures follow the filters that produce their textures"),
    # Spheres.
    (CONTRACT, "const double nearest = b / a;", "const double nearest = b;",
     "rays of any direction pass a centre"),
    (CONTRACT, "square - ((lx * lx + ly * ly) + lz * lz);", "square - (lx * lx + (ly * ly + lz * lz));",
     "distances to a ray are summed in order"),
    (CONTRACT, "disc > 0.0 && s.radius > 0.0", "disc >= 0.0 && s.radius > 0.0",
     "rays that touch a sphere miss it"),
    (CONTRACT, "disc > 0.0 && s.radius > 0.0", "disc > 0.0", "negative radii are not hit"),
    (CONTRACT, "b > 0.0 ? b + root : b - root", "b + root", "roots do not cancel behind the centre"),
    (CONTRACT, "s.hasOutside && outside > 0.0", "outside > 0.0", "the outside may not be drawn"),
    (CONTRACT, " &&\n    !(hit.isInside && !s.hasInside);", ";", "the inside may not be drawn"),
    (SPHERE_HITS, "hn::And(s.hasOutside, hn::Gt(outside, zero))", "hn::Gt(outside, zero)",
     "the outside may not be drawn, in kernels"),
    (SPHERE_HITS, "hn::Or(isOutside, s.hasInside)", "hn::Or(isOutside, isAhead)",
     "the inside may not be drawn, in kernels"),
    (SPHERE_HITS, "hn::IfThenElse(isAhead, first, second);", "first;",
     "the order of the roots depends on the side of the centre"),
    (SPHERE_BOXES, "hn::Add(zt, xr), isOutside, -1.0", "hn::Sub(zt, xr), isOutside, -1.0",
     "the tangent on the left has its own denominator"),
    (SPHERE_BOXES, "hn::And(isOutside, hn::Gt(denominator, hn::Zero(d)))", "isOutside",
     "spheres that cross the plane of the eye have no bound"),
    (SPHERE_BOXES, "hn::Le(hn::Add(c.z, larger), hn::Zero(d))", "hn::Le(c.z, hn::Zero(d))",
     "spheres around the eye are kept"),
    (SPHERE_BOXES, "hn::Sub(c.z, larger), nothing", "c.z, nothing", "a sphere is nearer than its centre"),
    (SPHERE_BINNING, "!box.empty() && boxes.radii[place] > 0.0", "!box.empty()",
     "spheres of no size are not drawn"),
    (SPHERE_BINNING, "result.defects.notFinite += !part.isTransparent() || primitive % 2 == 0;", "", "centres that are not finite are counted"),
    (SPHERE_CASTING, "hn::Or(hn::AndNot(isRanged, hit), hn::Gt(isOpen, hn::Zero(d)))",
     "hn::AndNot(isRanged, hit)", "hits whose order is open are compared by depth"),
    (SPHERE_CASTING, "this->second + (lane - half)", "this->first + lane",
     "half of the lanes are another row"),
    (SPHERE_POINTS, "hit.isInside && this->TwoSided ? -normal : normal", "normal",
     "normals turn inside a sphere"),
    (VECTOR_SPHERE_POINTS, "this->IsTwoSided ? negatedWhere(hit.isInside, normal) : normal", "normal",
     "normals turn inside a sphere, in kernels"),
    (LOADING_SPHERES, "part.hasOutside(batch.primitives[run]) ? 1.0 : 0.0", "1.0",
     "kernels know that the outside is not drawn"),
    (RUN_RANGE, "other.kind != this->kind", "false", "ranges have one kind of primitive"),
    (SURFACE, " &&\n      !(this->kind() == PrimitiveKind::Sphere && this->attributes[index].isPerCell);", ";",
     "spheres have no values of cells"),
    (SURFACE, "this->radius * this->radii[sphere]", "this->radii[sphere]", "radii are multiplied"),
    (SURFACE, "body(this->points[sphere] - Vec3(size));", "", "bounds include radii"),
    (SPHERES_FROM_VTK, "settings.radius > 0.0 ? settings.radius : 1.0", "settings.radius",
     "an array alone gives the radii"),
    # Lines.
    (LINE_CONTRACT, "line.isTurned = comesBefore(b, a);", "line.isTurned = false;",
     "a line and the same line turned are equal"),
    (LINE_CONTRACT, "t * line.az / (t * line.az + (1.0 - t) * line.bz)", "t",
     "data on lines is in perspective"),
    (LINE_CONTRACT, "line.aShare + s * (1.0 - line.aShare)", "s", "lines that are cut keep their data"),
    (LINE_CONTRACT, "std::min(half, 0.5)", "half", "wide lines have no hole"),
    (LINE_CONTRACT, "z - hit.rise * (line.parallel ? line.bulge : line.bulge * z)", "z",
     "lines on a surface are visible"),
    (LINE_BOUNDS, "const double more = 1.0 + this->Slack;", "const double more = 1.0 - this->Slack;",
     "bounds of lines hold their caps"),
    (LINE_BOUNDS, "this->Reach + (dx * height + dy * width)", "this->Reach",
     "a tile beside the centre line is kept"),
    (LINE_BINNING, "result.defects.notFinite += isFirstOfCell(surface, line);",
     "++result.defects.notFinite;", "cells with points that are not finite count once"),
    (LINE_POINTS, "dot(m, ray) > 0.0 ? -m : m", "m", "normals of lines look at the viewer"),
    (LINE_POINTS, "return offset - ray * dot(offset, ray);", "return offset;",
     "spheres at the edge of a wide view are not skewed"),
    (LINE_POINTS, "(end == 0.0) != line.isTurned", "end == 0.0", "tubes end at the right end"),
    (CELL_LINES, "isFirst[edges[k].number] = edges[k].larger != edges[k - 1].larger;", "",
     "an edge is drawn once"),
    (CELL_LINES, "edges.add(points[k], points[k + 2], cell);", "", "the triangles of strips have edges"),
    (LINES_FROM_VTK, "style.pointsAreSpheres ? look.shading : Shading::Unlit", "look.shading",
     "marked vertices have their plain colour"),
    # Transforms, ghosts and blocks.
    (TRANSFORM, "((m[0] * p.x + m[1] * p.y) + m[2] * p.z) + m[3]",
     "(m[0] * p.x + m[1] * p.y) + (m[2] * p.z + m[3])", "transformed points are summed in order"),
    (COFACTORS, "this->Rows[i][k] = a - b;", "this->Rows[i][k] = a + b;", "normals stay perpendicular"),
    (COFACTORS, "cofactor = this->IsMirror ? -cofactor : cofactor;", "",
     "normals stay on their side of a mirrored surface"),
    (COFACTORS, "std::ldexp(transform.rows[i][k], -exponent)", "transform.rows[i][k]",
     "normals do not depend on the scale"),
    (COFACTORS, "> 0x1p-48 * terms", "> 0.0", "a determinant of rounding errors is 0"),
    (DRAWN, "flags & (GhostFlags::hiddenCell | GhostFlags::refinedCell)",
     "flags & GhostFlags::hiddenCell", "refined cells are not drawn"),
    (DRAWN, "? CellUse::ForNormals", "? CellUse::None", "duplicate cells contribute to normals"),
    (DRAWN, "skip[face] || uses[cell] == CellUse::None", "skip[face]",
     "hidden cells do not contribute to normals"),
    (DRAWN, "isHidden(cells.connectivity[k]) ? CellUse::None : uses[cell]", "uses[cell]",
     "cells with a hidden point are not drawn"),
    (DRAWN, "this->AreMirrored ? 2 : 1", "1", "mirrored faces keep their front"),
    (SURFACE_FROM_VTK, "values, std::negate<>()", "values, [](float v) { return v; }",
     "computed normals of a mirrored mesh point outward"),
    (SURFACE_FROM_VTK, "numbers = this->DrawnNumbers.span();", "",
     "drawn corners keep their normals"),
    (SURFACE_FROM_VTK, "this->Result.cells = this->Drawn.cells().data();", "",
     "drawn triangles keep their cells"),
    (BLOCKS, "const vtkIdType block = this->Next++;", "const vtkIdType block = ++this->Next;",
     "the root's flat index is 0"),
    (BLOCKS, "state.isVisible = this->Attributes->GetBlockVisibility(object);",
     "state.isVisible &= this->Attributes->GetBlockVisibility(object);",
     "a visible block in a hidden one is drawn"),
    (BLOCKS, "this->Parents.pop_back();", "", "a block may occur twice"),
    (OUTPUT_IMAGE, "input[k] = place.connection;", "input[k] = place.block;",
     "the input of a block is its connection"),
    (SCENE_FROM_SETTINGS, "result.back().diffuseColor = result.back().ambientColor = *input.color;",
     "result.back().diffuseColor = *input.color;", "a block's colour is also the ambient one"),
    (SORTED_LAYERS, "{ return a.high > b.high; }", "{ return a.low > b.low; }",
     "layers are sorted by the near ends of their ranges"),
    (SORTED_LAYERS, "low = std::min(low, next->low);", "low = next->low;",
     "a layer may overlap another one that is not next to it"),
    (SORTED_LAYERS, "(a.depth == b.depth && a.primitive < b.primitive)", "false",
     "layers at the same depth are in the order of their numbers"),
    (SORTED_LAYERS, "return isRepeated;\n  }", "return false;\n  }",
     "a ray through an edge sees one of its triangles"),
    (SORTED_LAYERS, "Outline{ hit.e2 == 0.0 ? t.a : t.c, t.a }", "Outline{ t.c, t.a }",
     "a corner is not an edge"),
    (LAYER_PAINTING, "seen[i] == noPrimitive && opacity > 0.0 ? primitive", "opacity > 0.0 ? primitive",
     "passes show the nearest layer"),
    (LAYER_PAINTING, "hasAlpha ? 1.0 - transmittances[i] : 1.0", "hasAlpha ? 1.0 : 1.0",
     "alpha is what the layers hold back"),
    (LAYER_PAINTING, "t > 0.0 ? colors[i] + b * t : colors[i]", "colors[i]",
     "the background is seen through layers"),
    (SURFACE_COLOR, "    opacity = opacity *\n", "    opacity =\n", "alpha multiplies the opacity"),
    (COLORS, "isAny = isAny || bytes[(k + 1) * step - 1] != 255;", "",
     "alpha of arrays is used"),
    (COLOR_MAPS, "ofA + ofB; // rounds", "0; // rounds", "entries between two knots are rounded"),
    (COLOR_BY, "array->GetNumberOfComponents() > 1 ? Magnitude : 0", "0",
     "several components are mapped by their magnitude"),
    (PLY_VERTICES, "ColorScaleOf(element.properties[property].type) > 0;", "true;",
     "properties that are not bytes or floats are no colours"),
    # Edges of cells and highlights.
    (EDGE_LINES, "along < square ? along / square : 1.0", "along / square", "edges end at their ends"),
    (EDGE_LINES, "const double s = (far.z - depth) / (far.z - near.z);", "const double s = 1.0;",
     "edges are cut before the eye"),
    (CELL_EDGES, "cells[range.end - first] == cell", "false", "all triangles of a cell show its edges"),
    (CELL_EDGES, "distance * (1.0 + 0x1p-20)", "0.5 * distance", "edges beside a tile are kept"),
    (EDGE_WIDTH, "0.5 * mesh.frame().samplesPerPixel * mesh.frame().pixel", "0.5 * mesh.frame().pixel",
     "lines are as wide with several samples"),
    (DRAWN, "(edges & 1u) << 2", "(edges & 1u)", "mirrored triangles keep their edges"),
    (RUN_RANGE, "this->hasEdges = this->hasEdges || other.hasEdges;", "",
     "edges of all surfaces in a range are drawn"),
    (RUN_RANGE, "!areSame(other.specular, this->specular)", "false",
     "ranges have one kind of highlights"),
    (LIGHT, "(2.0 * facing) / normalSquare", "2.0 * facing", "normals of highlights have any length"),
    (LIGHT, "this->Parallel ? this->TowardsViewer : -point.position", "-point.position",
     "highlights in a parallel view are seen along the rays"),
    # The command's options of surfaces, textures and materials.
    (IDLE_PROPERTY, "options.edges || options.edgeColor;", "options.edges;",
     "the colour of edges shows them"),
    (COVER_WITH_TEXTURE, "if (HasCoordinates(meshes[k]))", "if (!meshes.empty())",
     "inputs without coordinates have no texture"),
    (MATERIAL_INPUTS, "opacity * options.opacity", "opacity", "opacities are multiplied"),
    (MATERIAL_INPUTS, "&& material.hasHighlights", "", "models 0 and 1 have no highlights"),
    (MATERIAL_INPUTS, "1 - material.transparency", "material.transparency",
     "Tr is 1 minus the opacity"),
    (NOTHING_SEEN, "  options.opacity = 1;", "", "invisible faces are hit"),
]
