// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief read a polygon mesh from an OBJ file
 *
 * vtkOBJReader is not used: it reads beyond its arrays where an index names
 * nothing, it leaves out faces whose corners are written in different forms, it
 * narrows coordinates to float, and it takes several times as long.
 *
 * What the lines of the file become:
 *
 * - `v x y z` are the points, in double. Ids and order are those of the file. A
 *   fourth number is a weight and means nothing here. With `v x y z r g b` the mesh
 *   has the unsigned char point data "RGB": from 0 ... 1, or from 0 ... 255 if all
 *   colours in the file are integers and one is above 1. Points without a colour
 *   are white.
 * - `f` are the polygons. Those of one or two points are left out, and one warning
 *   counts them. `l` and `p` become lines and vertices.
 * - `vn`: if any corner of a face names one that is not of length zero, the mesh
 *   has the point data "Normals". Corners that name different normals get points of
 *   their own, which are copies behind the points of the file. At a corner that
 *   names none, the normal comes from the smoothing groups below, or else is that
 *   of the face.
 * - `s`: if no corner names a normal but a line `s` precedes a face, the mesh has
 *   "Normals", too. Faces of one group are smooth across their common points,
 *   whatever the angle between them, except for a face with the same points as one
 *   before it, the other way round: such faces are smooth among themselves.
 *   Different groups are not smooth across. Faces for which it is off, and those
 *   before the first `s`, are flat. The normals are those of vtkLambentNormals.
 * - Without `vn` and `s` the mesh has no normals, and no point is copied. Whoever
 *   draws computes them.
 * - `vt`: the point data "TCoords" (u and v) if any corner names one. Corners that
 *   name different ones get points of their own. But where the mesh has no normals
 *   that would break those to be computed: then "TCoords" is left out if any point
 *   would need two.
 *
 * Indices may be negative, and may name what follows later in the file. Index 0,
 * and one that names nothing, is a Failure. Lines end with LF, CR LF or CR; a
 * backslash joins lines; a UTF-8 byte order mark is passed over. Anything else
 * (groups, materials, curves) is passed over, too; one warning counts `surf`.
 */

#ifndef ReadObj_h
#define ReadObj_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkPolyData;

namespace lambent::command
{

/// The mesh in the file; throws Failure, with the line, if something in it cannot be right.
vtkSmartPointer<vtkPolyData> ReadObj(
  const std::string& path, const std::function<void(double)>& progress);

} // namespace lambent::command

#endif
