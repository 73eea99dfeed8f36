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
 * Output, image size, background and further settings that all pictures have: see
 * vtkLambentAlgorithm.
 *
 * Bad input: a polygon or strip that names a point that does not exist, normals of the
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
 * vtkLambentAlgorithm vtkLambentNormals vtkCamera vtkLight vtkProperty
 */

#ifndef vtkLambentRayTracer_h
#define vtkLambentRayTracer_h

#include "vtkLambentAlgorithm.h"
#include "vtkLambentModule.h" // For export macro

#include <memory> // For the list of per-connection properties

class vtkCamera;
class vtkLight;
class vtkLightCollection;
class vtkProperty;

class VTKLAMBENT_EXPORT vtkLambentRayTracer : public vtkLambentAlgorithm
{
public:
  static vtkLambentRayTracer* New();
  vtkTypeMacro(vtkLambentRayTracer, vtkLambentAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

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

  /**
   * The newest of this filter's own time and those of the camera, the lights
   * (and their transform matrices) and the properties.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkLambentRayTracer();
  ~vtkLambentRayTracer() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void DescribeScene(
    vtkInformationVector** inputs, lambent::adapters::SceneSettings& scene) override;

  vtkCamera* Camera;
  vtkProperty* Property;
  vtkTypeBool UsePointNormals;
  vtkTypeBool Splitting;
  double FeatureAngle;

private:
  vtkLambentRayTracer(const vtkLambentRayTracer&) = delete;
  void operator=(const vtkLambentRayTracer&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
