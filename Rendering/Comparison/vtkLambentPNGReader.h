// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLambentPNGReader
 * @brief   read PNG files safely, even broken ones
 *
 * Produces the same vtkImageData as vtkPNGReader for each valid file, but survives broken files:
 * vtkPNGReader terminates the process when libpng finds an error, such as a truncated file.
 * Baselines come from version control, large-file stores and interrupted copies, so all image
 * comparisons in Lambent read them with this class.
 *
 * The whole file is checked and decoded in the first pass of an update. For a broken file,
 * Update() reports an error and the output is empty. Read() does the same without an
 * error event; GetMessage() then describes the defect.
 *
 * Output: one slice, spacing 1, origin 0, the bottom row first. The point scalars "PNGImage" are
 * unsigned char or unsigned short, with 1 (grey), 2 (grey and alpha), 3 (RGB) or 4 (RGBA)
 * components. Palettes become colours, fewer than 8 bits become 8, and a transparent colour
 * becomes an alpha channel.
 *
 * @warning The VTK module png is optional. Without it every file is an error; see IsAvailable().
 *
 * @sa
 * vtkLambentImageComparison vtkPNGReader
 */

#ifndef vtkLambentPNGReader_h
#define vtkLambentPNGReader_h

#include "vtkImageAlgorithm.h"
#include "vtkLambentModule.h" // For export macro
#include "vtkSmartPointer.h"  // For the picture

#include <map>    // For the texts
#include <string> // For the message

class vtkImageData;

class VTKLAMBENT_EXPORT vtkLambentPNGReader : public vtkImageAlgorithm
{
public:
  static vtkLambentPNGReader* New();
  vtkTypeMacro(vtkLambentPNGReader, vtkImageAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The path of the file, which must be a regular file. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /// Whether Lambent was built with the VTK module png, which decodes the pixels.
  static bool IsAvailable();

  /**
   * Read the file now, even if it was read before. (A pipeline rereads it only after its name
   * changes.) Returns true if it is a complete PNG file; then Update() outputs what was read.
   * Otherwise GetMessage() gives the reason in one line. There is no error event.
   */
  bool Read();

  /// What is wrong with the file last read, such as "it is not a complete PNG file"; empty if it is
  /// valid.
  const char* GetMessage() const { return this->Message.c_str(); }

  /// The text for a key in the file last read (tEXt, zTXt and iTXt chunks), or nullptr.
  const char* GetText(const char* key) const;

protected:
  vtkLambentPNGReader();
  ~vtkLambentPNGReader() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  char* FileName;

private:
  vtkLambentPNGReader(const vtkLambentPNGReader&) = delete;
  void operator=(const vtkLambentPNGReader&) = delete;

  void ReadFile();

  std::string Message;
  std::map<std::string, std::string> Texts;
  vtkSmartPointer<vtkImageData> Picture;
  vtkTimeStamp ReadTime;
};

#endif
