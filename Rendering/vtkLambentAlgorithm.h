// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLambentAlgorithm
 * @brief   what all ray-traced pictures have: size, samples, background, output arrays
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
 * Output: vtkImageData of extent (0, width-1, 0, height-1, 0, 0), spacing 1, origin 0, row 0 at
 * the bottom, with these point arrays. A part of the extent that is requested downstream is
 * computed alone and equals that part of the whole. If it is empty, like a piece beyond the number
 * of rows, so is the output.
 *
 * array         | type                           | where nothing is hit | if
 * ------------- | ------------------------------ | -------------------- | ---------------------
 * "Color"       | unsigned char or float, 3 or 4 | background           | always; active scalars
 * "Depth"       | float                          | NaN                  | GenerateDepth
 * "Normals"     | float, 3                       | NaN                  | GenerateNormals
 * "Positions"   | double, 3                      | NaN                  | GeneratePositions
 * "CellIds"     | vtkIdType                      | -1                   | GenerateIds
 * "InputIds"    | vtkIdType                      | -1                   | GenerateIds
 * "BlockIds"    | vtkIdType                      | -1                   | GenerateIds, composite
 * input the array's   | float or double                | NaN                  | AddPassArray()
 *
 * All but "Color" show what one sample of the pixel sees, the middle one, whatever the light and
 * the colours are. So the picture is also a probe of the geometry, one ray per pixel.
 *
 * The filter reports progress and responds to an abort every few tens of milliseconds. After an
 * abort or an error the output is empty. An error names the cause and the remedy: an image size
 * below 1 or beyond memory, a supersampling outside 1 to 16, a background that is not finite, a
 * background image that cannot be used, pass arrays whose names clash or whose sizes are wrong, and
 * what subclasses add.
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

#include <memory> // For pass arrays and the warnings given
#include <string> // For messages

class vtkImageData;

namespace lambent
{
namespace adapters
{
struct OutputSettings;
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
   * become smooth. The time grows less than the number of samples, the memory hardly. A picture
   * of more than 2^25 samples is rendered in bands, each of which reads the whole mesh: one at
   * 1920 x 1080 with n = 4, four with n = 8. GenerateIds names what the sample (n / 2, n / 2) of
   * the pixel sees, rounded down. n times the image size may not exceed 2147483647. Default: 1, one
   * sample in the centre.
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
   * and Background2 that at the top edge. A colour that does not show, since it is behind an image
   * without alpha or GradientBackground is off, causes a warning. Defaults: black, off, black.
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
   * An image behind the surfaces, instead of Background: unsigned char (0 to 255 mean 0 to 1) or
   * float scalars of 1 to 4 components: grey, grey and alpha, RGB or RGBA. Where its alpha
   * (straight) is below 1, Background shows through. The image is stretched to the whole picture;
   * between the centres of its pixels colours are interpolated linearly, beyond them they are those
   * of the edge. So an image of the picture's size is reproduced exactly if Supersampling is 1;
   * with more samples, its hard edges become softer. An image that is more than Supersampling
   * times as large as the picture should be reduced first, with vtkImageResize. It is shared with
   * the caller and not updated. Default: none (nullptr).
   */
  virtual void SetBackgroundImage(vtkImageData* image);
  vtkImageData* GetBackgroundImage() { return this->BackgroundImage; }
  ///@}

  ///@{
  /**
   * Give "Color" a fourth component, alpha: the fraction of the pixel's samples that hit a
   * surface, each counted with the opacity of what it sees, 0 to 1 or 0 to 255. The other
   * components are then the mean colour of these samples alone (straight alpha), and 0 where alpha
   * is 0, so that the picture can be laid over anything. It has no background; setting one causes a
   * warning. With Supersampling 1 and opaque surfaces, alpha is 0 or 1. Default: off.
   */
  vtkSetMacro(OutputAlpha, vtkTypeBool);
  vtkGetMacro(OutputAlpha, vtkTypeBool);
  vtkBooleanMacro(OutputAlpha, vtkTypeBool);
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
   * Add the point array "Depth": the distance of the surface from the camera along the viewing
   * direction, in world units. Default: off.
   */
  vtkSetMacro(GenerateDepth, vtkTypeBool);
  vtkGetMacro(GenerateDepth, vtkTypeBool);
  vtkBooleanMacro(GenerateDepth, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Add the point array "Normals": the unit normal that shading uses, in world coordinates:
   * interpolated where the surface is shaded smooth, and turned to the viewer's side with
   * TwoSidedLighting. Surfaces that are not lit have the normals of their faces. NaN where the
   * normals of a face are zero. Default: off.
   */
  vtkSetMacro(GenerateNormals, vtkTypeBool);
  vtkGetMacro(GenerateNormals, vtkTypeBool);
  vtkBooleanMacro(GenerateNormals, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Add the point array "Positions": where the ray hits the surface, in world coordinates.
   * Default: off.
   */
  vtkSetMacro(GeneratePositions, vtkTypeBool);
  vtkGetMacro(GeneratePositions, vtkTypeBool);
  vtkBooleanMacro(GeneratePositions, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Add the point arrays "CellIds", the cell of the mesh, and "InputIds", the connection of
   * port 0 that the mesh belongs to, counted from 0. If any input is composite, add "BlockIds",
   * too: the flat index of the mesh in its input, as vtkDataObjectTreeIterator counts; -1 at inputs
   * that are not composite. Of several cells at the same depth it is the one of the smallest input,
   * then of the smallest block, then of the smallest id. An edge or point that
   * several cells share belongs to the first of them. A sphere has the number of its point as
   * "CellIds". Needs 20 bytes per pixel, or 28 with
   * blocks. Default: off.
   */
  vtkSetMacro(GenerateIds, vtkTypeBool);
  vtkGetMacro(GenerateIds, vtkTypeBool);
  vtkBooleanMacro(GenerateIds, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Add a point array of that name to the picture: the values of a point or cell array of the
   * surfaces seen (association: vtkDataObject::FIELD_ASSOCIATION_POINTS or
   * FIELD_ASSOCIATION_CELLS). Point arrays are interpolated with the barycentric coordinates of
   * the hit, of the triangle that the cell was cut into, or along the line; cell arrays are not.
   * The coordinates are rounded and may not sum to exactly 1, so that even a value that all points
   * share may change in its last digits: labels belong on cells. All of a sphere has the value of
   * its point, and NaN as the value of a cell array. The array is double if the input's is, or has
   * integers of 32 or 64 bits, and otherwise float. Inputs that have the array must agree in its
   * number of components. Its values are NaN on inputs that do not have it; an array that no input
   * has causes a warning. Names of the picture's own arrays (see the table above), and one name
   * twice, are an error. Default: none.
   */
  void AddPassArray(int association, const char* name);
  void RemoveAllPassArrays();
  ///@}

  /// The newest of this filter's own time and that of the background image.
  vtkMTimeType GetMTime() override;

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
  vtkImageData* BackgroundImage;
  vtkTypeBool OutputAlpha;
  int OutputScalarType;
  vtkTypeBool GenerateDepth;
  vtkTypeBool GenerateNormals;
  vtkTypeBool GeneratePositions;
  vtkTypeBool GenerateIds;

private:
  vtkLambentAlgorithm(const vtkLambentAlgorithm&) = delete;
  void operator=(const vtkLambentAlgorithm&) = delete;

  /// What is wrong with Supersampling, and the remedy; empty if nothing.
  std::string DescribeSamplingDefect() const;
  void AddOwnSettings(lambent::adapters::SceneSettings& scene);
  lambent::adapters::OutputSettings DescribeOutput() const;
  void WarnOfIdleSettings(const lambent::adapters::SceneSettings& scene);
  /// Throws Aborted, or a std::exception with a message for the user.
  void MakePicture(vtkInformationVector** inputs, vtkInformation* outInfo, vtkImageData* output);

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
