// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the structural similarity of two pictures, if VTK can compute it
 */
#ifndef StructuralSimilarity_h
#define StructuralSimilarity_h

class vtkImageData;

bool hasStructuralSimilarity();

/// The mean over all pixels and components of two pictures of the same size, type and number
/// of components. Throws std::runtime_error with a message for the user.
double structuralSimilarity(vtkImageData* picture, vtkImageData* baseline);

#endif
