// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a ray tracer's input connections and their settings, by the bytes of a fuzzer
 */
#ifndef FuzzInputs_h
#define FuzzInputs_h

#include "FuzzBlocks.h"
#include "FuzzInput.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataObject;
class vtkLambentRayTracer;

class FuzzInputs
{
public:
  static constexpr int most = 3;

  FuzzInputs(FuzzInput& input, vtkLambentRayTracer* tracer)
    : Input(input)
    , Tracer(tracer)
    , Blocks(input)
  {
  }

  const std::vector<vtkSmartPointer<vtkDataObject>>& all() const { return this->Objects; }

  /// Connects a mesh.
  void add(bool hasArrays);
  /// Connects composite data.
  void addTree(bool hasArrays);
  /// Makes room for another input if there are the most, and seldom otherwise.
  void clearSeldom();

  /// Changes a setting of an input, or of one that is not connected yet.
  void change();
  void changeTransform();

  /// Leaves a triangle as the only input, and no setting of any input.
  void reset();

private:
  vtkSmartPointer<vtkDataObject> makeMesh(bool hasArrays);
  void connect(vtkDataObject* data);
  void clear();
  void changeColors(int connection);
  void changeSpheres(int connection);
  void changeLook(int connection);

  FuzzInput& Input;
  vtkLambentRayTracer* const Tracer;
  FuzzBlocks Blocks;
  std::vector<vtkSmartPointer<vtkDataObject>> Objects; ///< connected ones
};

#endif
