// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkStellate
 * @brief   put a pyramid on each polygon
 *
 * Each polygon becomes a fan of triangles around an apex above the mean of its
 * points. The input's points keep their ids; the apexes follow in the order of the
 * polygons. Other cells and all attributes are dropped.
 */

#ifndef vtkStellate_h
#define vtkStellate_h

#include "vtkPolyDataAlgorithm.h"

class vtkStellate : public vtkPolyDataAlgorithm
{
public:
  static vtkStellate* New();
  vtkTypeMacro(vtkStellate, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How high the apexes are above their polygons; negative ones are hollows.
   * Default: 0.5.
   */
  vtkSetMacro(Height, double);
  vtkGetMacro(Height, double);
  ///@}

protected:
  vtkStellate() = default;

  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  double Height = 0.5;

private:
  vtkStellate(const vtkStellate&) = delete;
  void operator=(const vtkStellate&) = delete;
};

#endif
