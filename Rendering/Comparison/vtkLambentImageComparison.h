// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLambentImageComparison
 * @brief   compare a picture with its baseline, exactly or within a tolerance
 *
 * Port 0 takes the picture, port 1 the baseline. Both are vtkImageData of one slice
 * with active point scalars of any numeric type and number of components. Only
 * these scalars are compared; origin, spacing, and the start of the extent are
 * ignored. Two values are the same if they are equal as numbers or both NaN; so 0
 * equals -0. If only one of two values is NaN, they differ by infinity.
 *
 * Algorithm:
 *
 * 1. Check that size, number of components and scalar type are the same. If they are
 *    not, or a picture is empty, the comparison fails and the output is empty.
 * 2. Compare the rows, in parallel.
 * 3. Add up the results of the rows in order, so that they do not depend on the number of
 *    threads.
 *
 * A failed comparison is a result, not an error: Update() reports nothing; call
 * GetPassed() and GetMessage(). Errors, which also fail the comparison, are: an input
 * without scalars or with too few of them, a type that is not numeric, and a metric that
 * the VTK in use lacks.
 *
 * Results are never older than the last request. If an input cannot be updated, the
 * comparison fails, whatever made the request: Update(), UpdateWholeExtent(),
 * UpdateExtent(), UpdatePiece(), the executive, or a filter, writer or streamer downstream.
 * The same holds if an upstream reader sets an error code but reports success.
 * Passed is also false before the first request, and if an input or a setting has changed but
 * the request does not compare, such as UpdateInformation().
 * Composite data are rejected; compare their blocks one by one.
 *
 * @warning vtkPNGReader (VTK 9.1) neither fails nor sets an error code when its file is missing,
 * and outputs old memory. Read baselines with vtkLambentPNGReader.
 *
 * Output: the difference of the pictures; see Highlight.
 *
 * @par Thanks:
 * Structural similarity: Z. Wang, A. C. Bovik, H. R. Sheikh, E. P. Simoncelli,
 * "Image Quality Assessment: From Error Visibility to Structural Similarity", IEEE
 * Transactions on Image Processing 13(4), 2004.
 *
 * @sa
 * vtkLambentPNGReader vtkLambentRayTracer vtkImageSSIM
 */

#ifndef vtkLambentImageComparison_h
#define vtkLambentImageComparison_h

#include "vtkImageAlgorithm.h"
#include "vtkLambentModule.h" // For export macro

#include <string> // For the message

class VTKLAMBENT_EXPORT vtkLambentImageComparison : public vtkImageAlgorithm
{
public:
  static vtkLambentImageComparison* New();
  vtkTypeMacro(vtkLambentImageComparison, vtkImageAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set the two pictures, as SetInputData() does for ports 0 and 1.
   */
  void SetPictureData(vtkDataObject* picture) { this->SetInputData(0, picture); }
  void SetBaselineData(vtkDataObject* baseline) { this->SetInputData(1, baseline); }
  ///@}

  enum MetricType
  {
    MAXIMUM_DIFFERENCE = 0,
    ROOT_MEAN_SQUARE = 1,
    STRUCTURAL_SIMILARITY = 2
  };

  ///@{
  /**
   * The metric that must not exceed the tolerance. MAXIMUM_DIFFERENCE: the largest difference
   * between two values. ROOT_MEAN_SQUARE: the root mean square of all differences.
   * STRUCTURAL_SIMILARITY: 1 minus the structural similarity. Other values are clamped.
   * Default: MAXIMUM_DIFFERENCE.
   *
   * vtkImageSSIM, new in VTK 9.4, computes the structural similarity; without it this metric is
   * an error. It takes scalars of unsigned char (with a range of 255), unsigned short (65535),
   * float and double (1); other types are errors.
   */
  vtkSetClampMacro(Metric, int, MAXIMUM_DIFFERENCE, STRUCTURAL_SIMILARITY);
  vtkGetMacro(Metric, int);
  void SetMetricToMaximumDifference() { this->SetMetric(MAXIMUM_DIFFERENCE); }
  void SetMetricToRootMeanSquare() { this->SetMetric(ROOT_MEAN_SQUARE); }
  void SetMetricToStructuralSimilarity() { this->SetMetric(STRUCTURAL_SIMILARITY); }
  const char* GetMetricAsString() const;
  ///@}

  /// Whether the VTK in use can compute the structural similarity.
  static bool HasStructuralSimilarity();

  ///@{
  /**
   * The largest allowed metric, in units of the scalars: 0 to 255 for unsigned char. For the
   * structural similarity it is 0 to 2: 0.05 requires a similarity of at least 0.95. With 0
   * no value may differ, whatever the metric. A negative or non-finite tolerance is an error
   * and changes nothing. Default: 0.
   */
  virtual void SetTolerance(double tolerance);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Off: the output has the type and components of the inputs; each value is the absolute
   * difference of theirs, clamped to the range of the type. On: the output is a picture with
   * three components of unsigned char in which even the smallest difference is visible: 0
   * where values are the same, and from 55 to 255 (the largest difference of all) where they
   * differ. All three components show the difference of grey, and that of an alpha channel
   * (the second of 2 components, the fourth of 4) where it is larger. Of more than four
   * components, the first three are shown. Default: off.
   */
  vtkSetMacro(Highlight, vtkTypeBool);
  vtkGetMacro(Highlight, vtkTypeBool);
  vtkBooleanMacro(Highlight, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Results of the last request.
   *
   * Passed: whether the metric is within the tolerance.
   * MaximumDifference, RootMeanSquare: over all values of all pixels, in units of the
   * scalars; infinite if a value is NaN or infinite in only one picture; NaN if the
   * pictures could not be compared.
   * StructuralSimilarity: the mean over all values, from -1 to 1; NaN unless it is the
   * metric.
   * NumberOfChangedPixels: the pixels in which any value differs, however little and
   * whatever the tolerance.
   * ChangedExtent: the first and last column, and the first and last row, with changed
   * pixels, counted from 0 at the lower left; (0, -1, 0, -1) if there are none.
   */
  vtkGetMacro(Passed, bool);
  vtkGetMacro(MaximumDifference, double);
  vtkGetMacro(RootMeanSquare, double);
  vtkGetMacro(StructuralSimilarity, double);
  vtkGetMacro(NumberOfChangedPixels, vtkIdType);
  vtkGetVector4Macro(ChangedExtent, int);
  ///@}

  /**
   * The result of the last request, one line without a newline, such as "17 of 90000
   * pixels differ, by at most 3 of 255; the first is (12, 40)". Columns are counted
   * from 0 at the left, rows from 0 at the bottom; the first pixel is the leftmost in
   * the lowest row.
   */
  const char* GetMessage() const { return this->Message.c_str(); }

protected:
  vtkLambentImageComparison();
  ~vtkLambentImageComparison() override = default;

  /// Creates an executive that discards outdated results.
  vtkExecutive* CreateDefaultExecutive() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  int Metric;
  double Tolerance;
  vtkTypeBool Highlight;

  bool Passed;
  double MaximumDifference;
  double RootMeanSquare;
  double StructuralSimilarity;
  vtkIdType NumberOfChangedPixels;
  int ChangedExtent[4];

private:
  vtkLambentImageComparison(const vtkLambentImageComparison&) = delete;
  void operator=(const vtkLambentImageComparison&) = delete;

  class Executive;

  /// Resets the results and sets the message.
  void Fail(const std::string& message);
  /// Throws std::runtime_error with a message for the user.
  void Compare(vtkImageData* picture, vtkImageData* baseline, vtkImageData* output);
  void Judge(vtkIdType x, vtkIdType y, vtkIdType pixels, const std::string& ofScale);

  std::string Message;
  int NumberOfComparisons = 0; ///< counted for the executive
};

#endif
