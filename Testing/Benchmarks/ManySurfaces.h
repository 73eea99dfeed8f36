// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a mesh as one surface, and as many surfaces of one piece each
 *
 * The pieces have equally many triangles and points, and follow each other in the mesh.
 */
#ifndef ManySurfaces_h
#define ManySurfaces_h

#include "LambentRenderer.h"

#include "Scene.h"

#include <vector>

class ManySurfaces
{
public:
  explicit ManySurfaces(const BenchmarkScene& scene);

  /// Seconds of the filter with an input connection for each piece.
  double renderInputs();
  /// Seconds of a filter that has the same connections but draws the pieces by the core alone. The
  /// difference to renderMany() is what VTK's executive takes.
  double renderBlindly();
  /// Seconds of the core with one surface, and with one for each piece.
  double renderOne() { return this->render(this->One); }
  double renderMany() { return this->render(this->Many); }

private:
  void connect(vtkAlgorithm* filter);
  double render(const lambent::Scene& scene);

  int Width, Height;
  vtkNew<vtkLambentRayTracer> Filter;       ///< its inputs are the pieces
  vtkSmartPointer<vtkImageAlgorithm> Blind; ///< its inputs are the pieces
  vtkSmartPointer<vtkPolyData> Mesh;
  std::vector<vtkIdType> Corners; ///< of a piece
  lambent::Scene One, Many;
};

#endif
