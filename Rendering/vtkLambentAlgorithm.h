// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLambentAlgorithm
 * @brief   what all ray-traced pictures have: size, background, light switches, output
 *
 * vtkLambentAlgorithm is the abstract superclass of the classes that make pictures. It
 * renders a scene into vtkImageData; a subclass says which scene (DescribeScene()).
 *
 * How it works:
 *
 * 1. RequestInformation() announces an image of ImageSize.
 * 2. RequestData() lets the subclass describe the scene, and warns of settings that have no
 *    effect, once for as long as they stay.
 * 3. The scene becomes plain data; where normals are needed and missing they are computed
 *    (progress text "normals").
 * 4. The part of the image that is asked for is rendered ("rendering").
 *
 * Output: vtkImageData of extent (0, width-1, 0, height-1, 0, 0), spacing 1,
 * origin 0, row 0 at the bottom, with the active point scalars "Color", 3
 * components of unsigned char (default) or float; with GenerateIds also "CellIds"
 * and "InputIds". A part of the extent that is asked for downstream is computed alone
 * and equals that part of the whole.
 *
 * Progress is told, and an abort heeded, every few tens of milliseconds. After an abort or an
 * error the output is empty. An error names the cause and the remedy: an image size below 1 or
 * beyond memory, a supersampling outside 1 to 16, a background that is not finite, and what
 * subclasses add.
 *
 * @warning
 * Only classes of this library can be subclasses: what they describe a scene with is not
 * installed.
 *
 * @sa
 * vtkLambentRayTracer
 */

#ifndef vtkLambentAlgorithm_h
#define vtkLambentAlgorithm_h

#include "vtkImageAlgorithm.h"
#include "vtkLambentModule.h" // For export macro

#include <memory> // For the warnings given
#include <string> // For messages

class vtkImageData;

namespace lambent
{
namespace adapters
{
struct SceneSettings;
}
}

class VTKLAMBENT_EXPORT vtkLambentAlgorithm : public vtkImageAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkLambentAlgorithm, vtkImageAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Width and height of the image in pixels. Each must be at least 1; what
   * memory cannot hold is an error. Default: 300 x 300.
   */
  vtkSetVector2Macro(ImageSize, int);
  vtkGetVector2Macro(ImageSize, int);
  ///@}

  ///@{
  /**
   * The number n of samples along each axis of a pixel, 1 to 16. A pixel is the average of
   * n x n linear values, those of the picture of n times the size (a box filter), so that edges
   * become smooth. The time grows less than the number of samples, the memory hardly.
   * GenerateIds names what the sample (n / 2, n / 2) of the pixel sees, rounded down. n times
   * the image size may not exceed 2147483647. Default: 1, one sample in the centre.
   */
  vtkSetMacro(Supersampling, int);
  vtkGetMacro(Supersampling, int);
  ///@}

  enum AmbientModelType
  {
    PER_LIGHT = 0,
    SCENE = 1
  };

  ///@{
  /**
   * What the ambient reflection rho_a is multiplied with. PER_LIGHT: with the
   * light that arrives from each light, so that every light adds an ambient
   * term (the classroom model). SCENE: with 1, once, whatever the lights, as
   * VTK's OpenGL renderer does. Default: PER_LIGHT.
   */
  vtkSetClampMacro(AmbientModel, int, PER_LIGHT, SCENE);
  vtkGetMacro(AmbientModel, int);
  void SetAmbientModelToPerLight() { this->SetAmbientModel(PER_LIGHT); }
  void SetAmbientModelToScene() { this->SetAmbientModel(SCENE); }
  ///@}

  ///@{
  /**
   * Turn the normal towards the viewer where the back of a face is seen. The back
   * is the side from which its points run clockwise; but where the sum of a triangle's
   * three point normals (or its cell normal, if shaded flat) lies on that side, the
   * other one is. So a mirrored mesh whose own normals point outward is lit from
   * outside. Culling goes by the points alone. Off: the normal is used as it is, and
   * faces seen from behind are usually dark. Default: on.
   */
  vtkSetMacro(TwoSidedLighting, vtkTypeBool);
  vtkGetMacro(TwoSidedLighting, vtkTypeBool);
  vtkBooleanMacro(TwoSidedLighting, vtkTypeBool);
  ///@}

  ///@{
  /**
   * The colour where nothing is hit, red, green, blue, usually in [0, 1]; finite.
   * With GradientBackground it is the colour at the bottom edge of the image,
   * and Background2 that at the top edge. Defaults: black, off, black.
   */
  vtkSetVector3Macro(Background, double);
  vtkGetVector3Macro(Background, double);
  vtkSetMacro(GradientBackground, vtkTypeBool);
  vtkGetMacro(GradientBackground, vtkTypeBool);
  vtkBooleanMacro(GradientBackground, vtkTypeBool);
  vtkSetVector3Macro(Background2, double);
  vtkGetVector3Macro(Background2, double);
  ///@}

  ///@{
  /**
   * The type of "Color": VTK_UNSIGNED_CHAR, floor(255 clamp(I, 0, 1) + 1/2), or
   * VTK_FLOAT, I as it is, linear and not clamped. Any other type is an error.
   * Default: VTK_UNSIGNED_CHAR.
   */
  virtual void SetOutputScalarType(int type);
  vtkGetMacro(OutputScalarType, int);
  void SetOutputScalarTypeToUnsignedChar() { this->SetOutputScalarType(VTK_UNSIGNED_CHAR); }
  void SetOutputScalarTypeToFloat() { this->SetOutputScalarType(VTK_FLOAT); }
  ///@}

  ///@{
  /**
   * Also tell what each pixel shows, in two more point arrays of vtkIdType: "CellIds",
   * the cell of the input mesh, and "InputIds", the connection of port 0 that the mesh
   * came by, counted from 0. Both are -1 where nothing is hit. Of several cells at the
   * same depth it is the one of the smallest input, then of the smallest id. The
   * colours stay the same. Takes 20 bytes a pixel. Default: off.
   */
  vtkSetMacro(GenerateIds, vtkTypeBool);
  vtkGetMacro(GenerateIds, vtkTypeBool);
  vtkBooleanMacro(GenerateIds, vtkTypeBool);
  ///@}

  /**
   * The version of the image contract. It changes only when the same scene can
   * give other bits than before.
   */
  static int GetImageContractVersion();

protected:
  vtkLambentAlgorithm();
  ~vtkLambentAlgorithm() override;

  /**
   * Fill in what the picture shows: inputs, camera, lights, properties and how normals are
   * made (Rendering/SceneSettings.h). The settings of this class are filled in already.
   */
  virtual void DescribeScene(
    vtkInformationVector** inputs, lambent::adapters::SceneSettings& scene) = 0;

  int RequestInformation(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  int ImageSize[2];
  int Supersampling;
  int AmbientModel;
  vtkTypeBool TwoSidedLighting;
  double Background[3];
  vtkTypeBool GradientBackground;
  double Background2[3];
  int OutputScalarType;
  vtkTypeBool GenerateIds;

private:
  vtkLambentAlgorithm(const vtkLambentAlgorithm&) = delete;
  void operator=(const vtkLambentAlgorithm&) = delete;

  /// What is wrong with Supersampling, and the remedy; empty if nothing.
  std::string DescribeSamplingDefect() const;
  void AddOwnSettings(lambent::adapters::SceneSettings& scene);
  void WarnOfIdleSettings(const lambent::adapters::SceneSettings& scene);
  /// Throws Aborted, or a std::exception with a message for the user.
  void MakePicture(vtkInformationVector** inputs, vtkInformation* outInfo, vtkImageData* output);

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
