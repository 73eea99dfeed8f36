// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLambentNormals
 * @brief   point and cell normals of a polygonal mesh, with the same bits on any number of threads
 *
 * vtkLambentNormals passes its input through and adds the point data array "Normals" (3
 * components of float, the active normals). On request it also adds a cell data array of
 * the same name and type. It reads triangles, quads, polygons with any number of points,
 * and triangle strips; vertices and lines pass through.
 *
 * How it works:
 *
 * 1. Check all cells: each must use points that exist.
 * 2. If Splitting is on, split the mesh along its sharp edges.
 * 3. Divide the points into ranges. For each range, walk the faces in order and add their
 *    contributions to the points of the range.
 * 4. Scale each sum to unit length.
 *
 * Definition of a point normal: the sum of the contributions of all faces at the corners
 * that name the point, in binary64 and in ascending order of (cell, triangle within a
 * strip, corner within the face), scaled to unit length and rounded to float. This is the
 * result of a plain serial loop; the number of threads cannot change a bit. Let N be the
 * area vector of a face (normal to it by the right-hand rule, with twice its area as
 * length; Newell's for polygons), and u and v the edges from the corner to the next and
 * to the previous point of the face. The contribution is:
 *
 *     UNIFORM   N / |N|
 *     AREA      N
 *     ANGLE     N / |N| * (angle between u and v)
 *     MAX       u x v / (|u|^2 |v|^2)
 *
 * At a reflex corner of a polygon, ANGLE uses the angle inside the polygon, and MAX
 * negates its vector so that it lies on the side of N. Consecutive repeats of a point in
 * a polygon count once. The normal of a face is N / |N|.
 *
 * Points that no face uses, vertices, lines, faces without area, and points that only
 * such faces use have no normal: they get (0, 0, 0). Faces without area contribute nothing
 * (squared lengths are computed in binary64, so edges should be longer than 1e-75 and
 * shorter than 1e75).
 *
 * Triangle strips remain strips unless Splitting, FlipNormals or ComputeCellNormals is
 * on. Then they become triangles, placed after the polygons of the output, each with the
 * cell data of its strip. Points keep their ids and their order; Splitting appends copies.
 * The input is never modified. Its point or cell normals are passed on if this filter does
 * not compute them.
 *
 * Bad input: it is an error if a cell uses a point that does not exist, or if a data array
 * has the wrong length where points are duplicated or strips become triangles. The output
 * is then empty. Polygons and strips with an infinite or NaN coordinate contribute
 * nothing and cause one warning. An empty input gives an empty output.
 *
 * @warning
 * The orientation of the faces is not changed. Where neighbours have opposite
 * orientations, their contributions cancel; apply vtkPolyDataNormals or vtkOrientPolyData
 * first to orient them consistently.
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
   * The weight of each face at its corners. UNIFORM: the same for all. AREA: the area of
   * the face; large faces dominate. ANGLE: the angle of the corner; the result does not
   * depend on how plane regions are divided into triangles. MAX: exact where the points
   * lie on a sphere. Other values are clamped. Default: ANGLE.
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
   * Compute the cell data "Normals"; vertices and lines get (0, 0, 0). Strips become
   * triangles, since a strip has no single normal. Default: off.
   */
  vtkSetMacro(ComputeCellNormals, vtkTypeBool);
  vtkGetMacro(ComputeCellNormals, vtkTypeBool);
  vtkBooleanMacro(ComputeCellNormals, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Split the mesh along sharp edges, so that each side has its own normals. An edge is
   * sharp if the normals of its two faces differ by more than FeatureAngle, if one of these
   * faces has no area, or if it has more than two faces. The faces around a point form
   * groups that are linked by smooth edges. The group with the smallest cell id keeps the
   * point; each other group gets a copy with the same coordinates and point data. Copies
   * are appended, ordered by the id of the point and then by the smallest cell id of the
   * group. Global ids, which must be unique, are not copied. Default: off.
   */
  vtkSetMacro(Splitting, vtkTypeBool);
  vtkGetMacro(Splitting, vtkTypeBool);
  vtkBooleanMacro(Splitting, vtkTypeBool);
  ///@}

  ///@{
  /**
   * The largest angle, in degrees, between the normals of two faces whose common edge is
   * still smooth when Splitting is on; clamped to [0, 180]. At 180 only edges with more
   * than two faces, or with a face without area, are sharp. Default: 30.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Turn the surface inside out, as vtkPolyDataNormals does: negate the computed normals,
   * and reverse the order of each polygon's points, so that culling also swaps front and
   * back. Point normals that are only passed on are not negated. Therefore FlipNormals
   * without ComputePointNormals causes a warning, unless cell normals are computed and the
   * input has no point normals. Default: off.
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
