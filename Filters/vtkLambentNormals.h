// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLambentNormals
 * @brief   point and cell normals of a polygonal mesh, the same bits on any number of threads
 *
 * vtkLambentNormals passes its input on with the point data array "Normals" (3
 * components of float, the active normals) and, if asked for, a cell data array of
 * the same name and kind. It reads triangles, quads, polygons of any number of
 * points and triangle strips; vertices and lines pass through.
 *
 * How it works:
 *
 * 1. All cells are checked: each must name points that exist.
 * 2. If asked for, the mesh is cut open along its sharp edges.
 * 3. The points are divided into ranges. A range goes through the faces in order and
 *    adds what each of them contributes to the points of the range.
 * 4. Each sum is scaled to length one.
 *
 * The definition of a point normal: the sum, in binary64 and in ascending order of
 * (cell, triangle within a strip, corner within the face), of what each face
 * contributes at the corners that name the point, scaled to length one and rounded
 * to float. That is what a plain serial loop gives; threads and their number cannot
 * change a bit. With N the area vector of a face (normal to it by the right-hand
 * rule, as long as twice its area; Newell's for polygons), u and v the edges from
 * the corner to the next and to the previous point of the face:
 *
 *     UNIFORM   N / |N|
 *     AREA      N
 *     ANGLE     N / |N| * (angle between u and v)
 *     MAX       u x v / (|u|^2 |v|^2)
 *
 * At a reflex corner of a polygon ANGLE takes the angle inside the polygon, and MAX
 * turns its vector to the side of N. A point that a polygon names twice in a row
 * counts once. The normal of a face is N / |N|.
 *
 * What has no normal gets (0, 0, 0): points that no face uses, vertices, lines,
 * faces of no area, and points all of whose faces are such. Faces of no area
 * contribute nothing (squared lengths are computed in binary64: edges should be
 * longer than 1e-75 and shorter than 1e75).
 *
 * Triangle strips stay strips, unless Splitting, FlipNormals or ComputeCellNormals
 * is on: then they become triangles, each with the cell data of its strip, after the
 * polygons of the output. Points keep their ids and their order; Splitting appends
 * copies. The input is never modified. Point or cell normals that the input has and
 * that are not computed are passed on.
 *
 * Bad input: a cell that names a point that does not exist is an error, and the
 * output is empty; so is, where points are duplicated or strips become triangles, a
 * data array of the wrong length. Polygons and strips with an infinite or undefined coordinate
 * contribute nothing, and bring one warning. An empty input gives an empty output.
 *
 * @warning
 * The faces are taken as they are oriented. Where neighbours face opposite ways
 * their contributions cancel; vtkPolyDataNormals or vtkOrientPolyData can turn them
 * the same way first.
 *
 * @par Thanks:
 * ANGLE: G. Thuermer, C. A. Wuethrich, "Computing Vertex Normals from Polygonal
 * Facets", Journal of Graphics Tools 3(1), 1998. MAX: N. Max, "Weights for Computing
 * Vertex Normals from Facet Normals", Journal of Graphics Tools 4(2), 1999. UNIFORM:
 * H. Gouraud, "Continuous Shading of Curved Surfaces", IEEE Transactions on
 * Computers C-20(6), 1971. Newell's vector: I. E. Sutherland, R. F. Sproull, R. A.
 * Schumacker, "A Characterization of Ten Hidden-Surface Algorithms", ACM Computing
 * Surveys 6(1), 1974.
 *
 * @sa
 * vtkLambentRayTracer vtkPolyDataNormals vtkTriangleMeshPointNormals
 */

#ifndef vtkLambentNormals_h
#define vtkLambentNormals_h

#include "vtkLambentModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKLAMBENT_EXPORT vtkLambentNormals : public vtkPolyDataAlgorithm
{
public:
  static vtkLambentNormals* New();
  vtkTypeMacro(vtkLambentNormals, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum WeightingType
  {
    UNIFORM = 0,
    AREA = 1,
    ANGLE = 2,
    MAX = 3
  };

  ///@{
  /**
   * How much each face counts at its corners. UNIFORM: all the same. AREA: by the
   * area of the face; large faces dominate. ANGLE: by the angle of the corner; the
   * result does not depend on how plane regions are cut into triangles. MAX: exact
   * where the points lie on a sphere. Other values are clamped. Default: ANGLE.
   */
  vtkSetClampMacro(Weighting, int, UNIFORM, MAX);
  vtkGetMacro(Weighting, int);
  void SetWeightingToUniform() { this->SetWeighting(UNIFORM); }
  void SetWeightingToArea() { this->SetWeighting(AREA); }
  void SetWeightingToAngle() { this->SetWeighting(ANGLE); }
  void SetWeightingToMax() { this->SetWeighting(MAX); }
  const char* GetWeightingAsString() const;
  ///@}

  ///@{
  /**
   * Compute the point data "Normals". Default: on.
   */
  vtkSetMacro(ComputePointNormals, vtkTypeBool);
  vtkGetMacro(ComputePointNormals, vtkTypeBool);
  vtkBooleanMacro(ComputePointNormals, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Compute the cell data "Normals", (0, 0, 0) for vertices and lines. Strips
   * become triangles, since a strip has no single normal. Default: off.
   */
  vtkSetMacro(ComputeCellNormals, vtkTypeBool);
  vtkGetMacro(ComputeCellNormals, vtkTypeBool);
  vtkBooleanMacro(ComputeCellNormals, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Cut the mesh open along sharp edges, so that each side has normals of its own.
   * Sharp is an edge between two faces whose normals are more than FeatureAngle
   * apart, and an edge of more than two faces; a face of no area is sharp against
   * all others. The faces round a point that are linked by edges that are not sharp
   * stay together; the group with the smallest cell id keeps the point, and each
   * further one gets a copy with the same coordinates and point data. Copies are
   * appended, ordered by the id of the point and then by the smallest cell id of the
   * group. Global ids, which must be unique, are not copied. Default: off.
   */
  vtkSetMacro(Splitting, vtkTypeBool);
  vtkGetMacro(Splitting, vtkTypeBool);
  vtkBooleanMacro(Splitting, vtkTypeBool);
  ///@}

  ///@{
  /**
   * The largest angle, in degrees, between the normals of two faces that still go
   * smoothly into each other when Splitting is on; clamped to [0, 180]. At 180 only
   * edges of more than two faces are sharp. Default: 30.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Turn the surface inside out, as vtkPolyDataNormals does: computed normals point
   * the other way, and the points of each polygon run the other way round, so that
   * front and back change places for culling too. Point normals that are only passed
   * on are not turned; so without ComputePointNormals it causes a warning, unless cell
   * normals are computed and the input has no point normals. Default: off.
   */
  vtkSetMacro(FlipNormals, vtkTypeBool);
  vtkGetMacro(FlipNormals, vtkTypeBool);
  vtkBooleanMacro(FlipNormals, vtkTypeBool);
  ///@}

protected:
  vtkLambentNormals();
  ~vtkLambentNormals() override = default;

  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  int Weighting;
  vtkTypeBool ComputePointNormals;
  vtkTypeBool ComputeCellNormals;
  vtkTypeBool Splitting;
  double FeatureAngle;
  vtkTypeBool FlipNormals;

private:
  vtkLambentNormals(const vtkLambentNormals&) = delete;
  void operator=(const vtkLambentNormals&) = delete;

  void Execute(vtkPolyData* input, vtkPolyData* output);
  void WarnOfFlipping(vtkPolyData* input);

  bool HasWarnedOfFlipping = false;
};

#endif
