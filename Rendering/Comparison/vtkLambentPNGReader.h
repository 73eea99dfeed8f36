// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLambentPNGReader
 * @brief   read a PNG file that may be broken
 *
 * Gives the same vtkImageData as vtkPNGReader for each sound file, but survives the others:
 * vtkPNGReader ends the process when libpng finds an error, such as a file that was cut
 * short. Baselines come out of version control, large-file stores and interrupted copies, so
 * everything of Lambent that compares pictures reads them with this class.
 *
 * The whole file is checked and decoded in the first pass of an update. Update() reports a
 * broken file as an error, and the output is then empty. Read() does the same without an
 * error event; GetMessage() says what is wrong.
 *
 * Output: one slice, spacing 1, origin 0, the bottom row first. Point scalars "PNGImage" of
 * unsigned char or unsigned short, with 1 (grey), 2 (grey and alpha), 3 (RGB) or 4 (RGBA)
 * components. A palette is resolved, fewer than 8 bits become 8, and a transparent colour
 * becomes an alpha channel.
 *
 * @warning The VTK module png is optional. Without it each file is an error; see IsAvailable().
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
   * The file, a regular one. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /// Whether this VTK has the module png, which decodes the pixels.
  static bool IsAvailable();

  /**
   * Read the file now, even if it was read before: a pipeline does so only after a change of
   * the name. True if it is a whole PNG file; then Update() passes on what was read. Otherwise
   * GetMessage() says why not, in one line. There is no error event.
   */
  bool Read();

  /// What is wrong with the file that was last read, such as "the file is cut short"; empty if
  /// nothing is.
  const char* GetMessage() const { return this->Message.c_str(); }

  /// The text of a key in the file that was last read (tEXt, zTXt and iTXt chunks), or nullptr.
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
