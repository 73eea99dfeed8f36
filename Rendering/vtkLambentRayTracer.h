// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLambentRayTracer
 * @brief   ray-trace polygonal surfaces into an image, without a window
 *
 * vtkLambentRayTracer is an ordinary pipeline stage: vtkPolyData in,
 * vtkImageData out. It needs no render window, no OpenGL, no display and no
 * GPU. The picture is a pure function of the scene: the same bits for every
 * number of threads, compiler and CPU.
 *
 * The light model is Lambert's diffuse reflection with an ambient term. Per
 * light and colour channel
 *
 *     I = rho_d * I_s * (s.m) / (|s||m|) + rho_a * I_s   where s.m > 0
 *     I = rho_a * I_s                                    elsewhere
 *
 * s goes from the point that is seen to the light, m is the normal there, I_s
 * the light that arrives (colour x intensity x attenuation and cone), rho_d the
 * property's Diffuse x DiffuseColor, rho_a its Ambient x AmbientColor. Lights
 * add up.
 *
 * How a picture is made:
 *
 * 1. The camera becomes an orthonormal frame and a lattice of rays, one through
 *    the centre of each pixel. The rays are grouped into square cells.
 * 2. One pass over the points finds where on the lattice each of them falls.
 * 3. One pass over the triangles drops those between the rays and hands the
 *    others, or the hits on them that are certain, to the cells they touch.
 * 4. Each cell decides in double precision what is still open, keeps the nearest
 *    hit of each ray, shades it and writes its part of the image.
 *
 * Nothing is built and nothing is kept from one picture to the next.
 *
 * Inputs: port 0 takes any number of connections, each a vtkPolyData; together
 * they are one scene. Polygons of any number of points and triangle strips are
 * drawn; vertices and lines are not. Read from each input: the point normals
 * (vtkPointData::GetNormals(), 3 components, any floating-point type) for
 * smooth shading, the cell normals (vtkCellData::GetNormals()) for flat
 * shading. Smooth inputs without point normals get some, which leave sharp edges
 * sharp (Splitting, FeatureAngle). Inputs are never modified.
 *
 * Output: vtkImageData of extent (0, width-1, 0, height-1, 0, 0), spacing 1,
 * origin 0, row 0 at the bottom, with the active point scalars "Color", 3
 * components of unsigned char (default) or float; with GenerateIds also "CellIds"
 * and "InputIds". A part of the extent that is asked for downstream is computed alone
 * and equals that part of the whole.
 *
 * Bad input: a cell that names a point that does not exist, normals of the
 * wrong length or kind, an image size below 1 or beyond memory, a view angle
 * outside (0, 180) degrees, a view-up parallel to the view direction and
 * non-finite settings are errors; they name the cause and the remedy, and the
 * output is empty. Cells with non-finite points are skipped with one warning.
 * No triangles at all make a picture of the background.
 *
 * @warning
 * Of vtkCamera the position, focal point, view up, view angle (vertical or
 * horizontal), parallel projection and scale, and window centre are used. The
 * clipping range is ignored; user transforms, off-axis projection, view shear
 * and explicit projection matrices are not supported. Of vtkProperty the diffuse
 * and ambient colours and coefficients, Interpolation, Lighting, FrontfaceCulling
 * and BackfaceCulling are used; wireframe, points, opacity, specular terms,
 * textures and edges are not. Settings that have no effect cause a warning, once
 * for as long as they stay; FeatureAngle and Splitting if they are changed though no
 * input needs computed normals. Shading multiplies up to six lengths, so
 * coordinates and distances must lie between about 1e-50 and 1e50.
 *
 * @par Thanks:
 * Ray-triangle test: S. Woop, C. Benthin, I. Wald, "Watertight Ray/Triangle
 * Intersection", JCGT 2(1), 2013. Cells of rays instead of a tree of triangles:
 * W. Hunt, W. Mark, "Ray-Specialized Acceleration Structures for Ray Tracing",
 * IEEE Symposium on Interactive Ray Tracing, 2008; T. Davidovic et al., "3D
 * Rasterization: A Bridge between Rasterization and Ray Casting", Graphics
 * Interface 2012. Smooth shading: B. T. Phong, CACM 18(6), 1975.
 *
 * @sa
 * vtkLambentNormals vtkCamera vtkLight vtkProperty
 */

#ifndef vtkLambentRayTracer_h
#define vtkLambentRayTracer_h

#include "vtkImageAlgorithm.h"
#include "vtkLambentModule.h" // For export macro

#include <memory> // For the list of per-connection properties

class vtkCamera;
class vtkImageData;
class vtkLight;
class vtkLightCollection;
class vtkProperty;

class VTKLAMBENT_EXPORT vtkLambentRayTracer : public vtkImageAlgorithm
{
public:
  static vtkLambentRayTracer* New();
  vtkTypeMacro(vtkLambentRayTracer, vtkImageAlgorithm)
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
   * The camera, perspective or parallel. It is shared with the caller, never
   * modified by Update(), and changing it makes the picture out of date.
   * Default: none (nullptr); then the view is that of a new vtkCamera (looking
   * along -z, y up, view angle 30 degrees) reset to the bounds of the inputs.
   */
  virtual void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera() { return this->Camera; }
  ///@}

  /**
   * Move the camera along its direction so that the inputs' bounding sphere is
   * just in view, as vtkRenderer::ResetCamera() does: the view angle becomes 30
   * degrees, the focal point the centre of the bounds; position and parallel
   * scale follow. Updates the inputs. Makes a camera if none is set.
   */
  virtual void ResetCamera();

  ///@{
  /**
   * The lights, with vtkLight's meaning of switch, intensity, diffuse colour,
   * light type (headlight, camera light, scene light), position, focal point,
   * transform matrix, and for positional lights cone angle, exponent and
   * attenuation. They are shared with the caller and never modified by
   * Update(). Default: none; then a white headlight along the view direction.
   * A positional light whose three attenuation values are all 0 or less is an
   * error; a light that is aimed at its own position causes a warning.
   *
   * @warning A positional vtkLight has a cone angle of 30 degrees by default
   * and is then a spot light; 90 or more make it shine in all directions.
   * @note vtkLight::SetColor() sets the diffuse colour, the one used here.
   */
  void AddLight(vtkLight* light);
  void RemoveLight(vtkLight* light);
  void RemoveAllLights();
  vtkLightCollection* GetLights();
  ///@}

  ///@{
  /**
   * The surface property of every input that has none of its own. Shared with
   * the caller. Interpolation VTK_FLAT shades with face normals, VTK_GOURAUD
   * (vtkProperty's default) and VTK_PHONG with interpolated point normals.
   * Lighting off gives the plain DiffuseColor. Default: none (nullptr), which
   * means white, ambient 0, diffuse 1, smooth.
   */
  virtual void SetProperty(vtkProperty* property);
  vtkProperty* GetProperty() { return this->Property; }
  ///@}

  ///@{
  /**
   * The surface property of one input connection of port 0, counted from 0 in
   * the order of AddInputConnection(); nullptr takes it back, then the property
   * of SetProperty() holds. It stays with its connection: when that is removed, it is
   * dropped, and those of later connections move up with them. When all connections are
   * replaced at once (SetInputConnection(), SetInputData()) or removed, properties stay with
   * their numbers. A negative connection is an error. Default: none.
   */
  virtual void SetInputProperty(int connection, vtkProperty* property);
  vtkProperty* GetInputProperty(int connection);
  ///@}

  ///@{
  /**
   * As vtkAlgorithm's; the properties of SetInputProperty() follow.
   */
  void SetInputConnection(int port, vtkAlgorithmOutput* input) override;
  void SetInputConnection(vtkAlgorithmOutput* input) override
  {
    this->SetInputConnection(0, input);
  }
  void RemoveInputConnection(int port, vtkAlgorithmOutput* input) override;
  void RemoveInputConnection(int port, int idx) override;
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
   * Use the point normals that a smooth input has. Off, or where it has none, they are
   * computed for this picture; see Splitting. Default: on.
   */
  vtkSetMacro(UsePointNormals, vtkTypeBool);
  vtkGetMacro(UsePointNormals, vtkTypeBool);
  vtkBooleanMacro(UsePointNormals, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Keep edges sharp where normals are computed: those between two faces whose normals are
   * more than FeatureAngle apart. The normal at a corner of a face is then the angle-weighted
   * mean of the faces round the point that are reached over edges that are not sharp. Faces
   * that are there twice, once each way round, have normals of their own on both sides. No
   * points are copied. Off: as with a FeatureAngle of 180. Normals that an input brings along
   * are used as they are. Default: on.
   */
  vtkSetMacro(Splitting, vtkTypeBool);
  vtkGetMacro(Splitting, vtkTypeBool);
  vtkBooleanMacro(Splitting, vtkTypeBool);
  ///@}

  ///@{
  /**
   * The largest angle, in degrees, between the normals of two faces that still go smoothly
   * into each other when Splitting is on; clamped to [0, 180]. At 180 the surface is smooth
   * everywhere. A coarse cylinder or sphere whose faces meet at larger angles shows facets:
   * raise the angle. Default: 30.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
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
   * The newest of this filter's own time and those of the camera, the lights
   * (and their transform matrices) and the properties.
   */
  vtkMTimeType GetMTime() override;

  /**
   * The version of the image contract. It changes only when the same scene can
   * give other bits than before.
   */
  static int GetImageContractVersion();

protected:
  vtkLambentRayTracer();
  ~vtkLambentRayTracer() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  int ImageSize[2];
  vtkCamera* Camera;
  vtkProperty* Property;
  int AmbientModel;
  vtkTypeBool TwoSidedLighting;
  double Background[3];
  vtkTypeBool GradientBackground;
  double Background2[3];
  int OutputScalarType;
  vtkTypeBool UsePointNormals;
  vtkTypeBool Splitting;
  double FeatureAngle;
  vtkTypeBool GenerateIds;

private:
  vtkLambentRayTracer(const vtkLambentRayTracer&) = delete;
  void operator=(const vtkLambentRayTracer&) = delete;

  /// Throws Aborted, or a std::exception with a message for the user.
  void MakePicture(vtkInformationVector* inputs, vtkInformation* outInfo, vtkImageData* output);

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
