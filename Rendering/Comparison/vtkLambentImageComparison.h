// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLambentImageComparison
 * @brief   compare a picture with its baseline, exactly or within a tolerance
 *
 * Port 0 takes the picture, port 1 the baseline, both vtkImageData of one slice
 * with active point scalars of any number type and number of components. Only
 * these scalars are compared; origin, spacing, and where the extent begins are
 * not. Two values are the same if they are equal as numbers or both not a number
 * (NaN); so 0 is -0. A value that is NaN in one picture alone differs by infinity.
 *
 * How it is done:
 *
 * 1. Size, number of components and scalar type must be the same; if they are
 *    not, or a picture is empty, the comparison fails and the output is empty.
 * 2. The rows are compared, in parallel.
 * 3. What was found in the rows is added up in their order. So the results do not
 *    depend on the number of threads.
 *
 * A comparison that fails is a result, not an error: Update() is silent, and
 * GetPassed() and GetMessage() tell. An input without scalars, or with too few of
 * them, a type that is not a number type, and a metric that the VTK in use lacks
 * are errors, and the comparison fails.
 *
 * A result is never older than the last request. If an input cannot be updated, the
 * comparison fails, whichever method asked for it: Update(), UpdateWholeExtent(),
 * UpdateExtent(), UpdatePiece(), the executive, or a filter, writer or streamer downstream.
 * The same goes for a reader upstream that sets an error code and calls its update a success.
 * If an input or a setting has changed and a request leads to no new comparison, such as
 * UpdateInformation() alone, nothing has passed either; nor before the first request.
 * Composite data are refused; compare the blocks one by one.
 *
 * @warning vtkPNGReader (VTK 9.1) neither fails nor sets an error code when its file is missing,
 * and passes on old memory. Read baselines with vtkLambentPNGReader.
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
   * The two pictures, instead of SetInputConnection() and SetInputData() with the
   * ports 0 and 1.
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
   * What is held against the tolerance. MAXIMUM_DIFFERENCE: the largest difference of
   * two values. ROOT_MEAN_SQUARE: that of all differences. STRUCTURAL_SIMILARITY: what
   * it lacks to 1. Other values are clamped. Default: MAXIMUM_DIFFERENCE.
   *
   * Structural similarity is computed by vtkImageSSIM, which VTK has since 9.4; without it this
   * metric is an error. It takes scalars of unsigned char (the range is 255), unsigned short
   * (65535), float and double (1); others are an error.
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
   * How much the metric may be, in units of the scalars: for unsigned char from 0 to
   * 255. For the structural similarity, which is at most 1, from 0 to 2: 0.05 asks for
   * 0.95 at least. 0 is exact for each of the metrics: then no value may differ. A
   * negative or non-finite tolerance is an error and leaves the old one. Default: 0.
   */
  virtual void SetTolerance(double tolerance);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Off: the output has the type and components of the inputs, and each value is the
   * absolute difference of theirs (no more than the type can hold). On: it is a
   * picture to look at, in which the smallest difference shows, of three components of
   * unsigned char: 0 where the values are the same, from 55 up to 255, which is the
   * largest difference of all, where they are not. The difference of grey stands for
   * all three, and so does that of an alpha channel (the second of 2 components, the
   * fourth of 4) where it is larger. Of more components the first three are shown.
   * Default: off.
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
   * scalars; infinite where a value is NaN or infinite in one picture alone; NaN if
   * the pictures could not be compared.
   * StructuralSimilarity: the mean over all values, from -1 to 1; NaN unless it is the
   * metric.
   * NumberOfChangedPixels: of those that differ in a value, however little, whatever
   * the tolerance.
   * ChangedExtent: the first and last column, and the first and last row, of changed
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
   * The result of the last request in one line without an end, such as "17 of 90000
   * pixels differ, by at most 3 of 255; the first is (12, 40)". Columns are counted
   * from 0 at the left, rows from 0 at the bottom; the first pixel is the leftmost of
   * the lowest row.
   */
  const char* GetMessage() const { return this->Message.c_str(); }

protected:
  vtkLambentImageComparison();
  ~vtkLambentImageComparison() override = default;

  /// One that discards the results of requests that do not lead to a comparison.
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

  /// No result but a message.
  void Fail(const std::string& message);
  /// Throws std::runtime_error with a message for the user.
  void Compare(vtkImageData* picture, vtkImageData* baseline, vtkImageData* output);
  void Judge(vtkIdType x, vtkIdType y, vtkIdType pixels, const std::string& ofScale);

  std::string Message;
  int NumberOfComparisons = 0; ///< counted for the executive
};

#endif
