// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief reads a polygon mesh from an OBJ file
 *
 * vtkOBJReader is not used: it reads beyond its arrays if an index names an item that does not
 * exist, skips faces whose corners are written in different forms, narrows coordinates to float,
 * and takes several times as long.
 *
 * The lines of the file are converted as follows:
 *
 * - `v x y z` are the points, in double, with the ids and order of the file. A fourth number is a
 *   weight and is ignored. With `v x y z r g b` the mesh has the unsigned char point data "RGB",
 *   converted from 0 ... 1, or from 0 ... 255 if all colours in the file are integers and one is
 *   above 1. Points without a colour are white.
 * - `f` are the polygons. Faces of one or two points are skipped, and a warning counts them. `l`
 *   and `p` become lines and vertices.
 * - `vn`: if any corner of a face uses a normal of nonzero length, the mesh has the point data
 *   "Normals". Corners that name different normals get separate points, which are copies after the
 *   points of the file. A corner that names no normal gets one from the smoothing groups below, or
 *   else the face normal.
 * - `s`: if no corner uses a normal but a line `s` precedes a face, the mesh has "Normals" too.
 *   Faces of a group are smooth across their common points, whatever the angle between them. An
 *   exception is a face with the same points as an earlier one in the opposite orientation: such
 *   faces are smooth only among themselves. Edges between groups are sharp. Faces with smoothing
 *   off, and those before the first `s`, are flat. The normals are those of vtkLambentNormals.
 * - Without `vn` and `s` the mesh has no normals, and no point is copied. The renderer computes
 *   normals.
 * - `vt`: the mesh has the point data "TCoords" (u and v) if any corner uses a texture coordinate.
 *   Corners that name different ones get separate points. In a mesh without normals, separate
 *   points would break the smoothness of computed normals; there "TCoords" is omitted if any point
 *   would need two.
 *
 * - `mtllib` and `usemtl`: the names of the files and of each face's material become field data
 *   (ObjMaterials.h). The files are not read here.
 *
 * Indices may be negative, and may name items later in the file. An index of 0, or one that names
 * an item that does not exist, is a Failure. Lines end with LF, CR LF or CR; a backslash joins
 * lines; a UTF-8 byte order mark is skipped. Everything else (groups, curves) is skipped; a warning
 * counts `surf`.
 */

#ifndef ReadObj_h
#define ReadObj_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkPolyData;

namespace lambent::command
{

/// The mesh in the file. Throws Failure with the line if the file is invalid.
vtkSmartPointer<vtkPolyData> ReadObj(
  const std::string& path, const std::function<void(double)>& progress);

} // namespace lambent::command

#endif
