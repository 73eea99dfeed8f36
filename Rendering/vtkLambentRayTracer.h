// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLambentRayTracer
 * @brief   ray-trace polygonal surfaces into an image, without a window
 *
 * vtkLambentRayTracer is an ordinary pipeline stage: vtkPolyData in, vtkImageData out. It
 * needs no render window, no OpenGL, no display and no GPU. The image is a pure function of
 * the scene: it has the same bits with any number of threads, any compiler and any CPU.
 *
 * The light model is Lambert's diffuse reflection with an ambient term. For each light and
 * each colour channel
 *
 *     I = rho_d * I_s * (s.m) / (|s||m|) + rho_a * I_s   where s.m > 0
 *     I = rho_a * I_s                                    elsewhere
 *
 * s points from the surface point to the light, m is the normal there, and I_s the light
 * that arrives (colour x intensity x attenuation and cone). rho_d is the property's
 * Diffuse x DiffuseColor, and rho_a its Ambient x AmbientColor. The lights are added.
 *
 * How it works:
 *
 * 1. The camera becomes an orthonormal frame and a lattice of rays, one or more through
 *    each pixel (Supersampling). The rays are grouped into square tiles.
 * 2. One pass over the points computes where each of them falls on the lattice.
 * 3. One pass over the triangles drops those that fall between the rays. The others go to
 *    the tiles that they touch; of small triangles, only the hits that are certain.
 * 4. Each tile decides the remaining hits in double precision, keeps the nearest hit of
 *    each ray, shades it, and writes its part of the image.
 *
 * No tree is built, and nothing is kept from one image to the next.
 *
 * Inputs: port 0 takes any number of connections, each a vtkPolyData or composite data
 * (vtkMultiBlockDataSet, vtkPartitionedDataSet, vtkPartitionedDataSetCollection, nested). Together
 * they form one scene. Polygons with any number of points, triangle strips, lines and vertices are
 * rendered, or spheres at the points (SetInputSphereRadius()).
 * Smooth shading uses an input's point normals (vtkPointData::GetNormals(), 3 components),
 * flat shading its cell normals (vtkCellData::GetNormals()). Normals may have any numeric
 * type; all but float and double are converted to double. Smooth inputs without point
 * normals get computed ones that keep sharp edges sharp (Splitting, FeatureAngle). Inputs
 * are never modified.
 *
 * Lines and points: lines are as wide as vtkProperty's LineWidth, in pixels of the picture, and
 * vertices are discs of PointSize. With Representation "wireframe", the edges of polygons and
 * strips are lines, and nothing is filled; with "points", the points that cells use are discs. An
 * edge or point that several cells share is drawn once and belongs to the first of them.
 * VertexVisibility adds the points that cells use in VertexColor, without light. Lines and points
 * bulge towards the eye like a tube of their width, so that those on a face are visible; no depth
 * is shifted. They are lit with the point normals of a smooth-shaded input, and otherwise with
 * normals perpendicular to the line, both turned to the viewer; with RenderLinesAsTubes and
 * RenderPointsAsSpheres, with those of a tube or sphere. Culling does not apply to them.
 *
 * Composite data: each vtkPolyData block is a surface of its own, in the order of the flat index;
 * normals are not smoothed from block to block. Where faces coincide, the smallest (input, block,
 * cell) is seen. Empty blocks are left out, and so are blocks of other classes, with one warning.
 * SetInputBlockAttributes() hides and colours blocks; the picture's array "BlockIds" has the
 * blocks' flat indices (GenerateIds).
 *
 * Ghosts: cells that the array vtkGhostType marks DUPLICATECELL, HIDDENCELL or REFINEDCELL, and
 * cells with a point marked HIDDENPOINT, are neither drawn nor framed by ResetCamera(). These are
 * the ones that VTK's surface filters leave out: vtkGeometryFilter (of VTK 9.3 and newer) the
 * marked cells, also of vtkPolyData; vtkGeometryFilter and vtkDataSetSurfaceFilter the faces of
 * grids with a hidden point. VTK's OpenGL mapper ignores the array and draws all cells of a
 * vtkPolyData. Duplicate cells still contribute to computed normals, so that pieces join without
 * seams; the others do not. Cell ids are those of the input.
 *
 * See vtkLambentAlgorithm for the output and for image size, background and the other
 * settings that do not depend on where the scene comes from.
 *
 * Bad input: errors are a block that contains itself, a cell that uses a point that does not exist,
 * a LineWidth or PointSize that something has and that is not a finite number above 0, normals,
 * radii, colours, texture coordinates or ghost arrays of the wrong length, radii that are negative
 * or not finite, a transform that cannot be used (SetInputTransform()), an image size below 1 or
 * too large for the memory, a view angle outside (0, 180) degrees, a view-up parallel to the view
 * direction, and settings that are not finite. They name the cause and the remedy, and the output
 * is empty. Cells and spheres with points that are not finite are skipped, with one warning.
 * Without any cells or spheres the image shows the background.
 *
 * @warning
 * Not all settings of VTK's objects have an effect. The image depends on vtkCamera's
 * position, focal point, view up, view angle (vertical or horizontal), parallel projection
 * and scale, and window centre. It ignores the clipping range; user transforms, off-axis
 * projection, view shear and explicit projection matrices are not supported. It depends on
 * vtkProperty's diffuse and ambient colours and coefficients, Interpolation, Lighting,
 * Opacity, FrontfaceCulling, BackfaceCulling, Specular, SpecularColor, SpecularPower,
 * EdgeVisibility and its settings, Representation, LineWidth, PointSize, RenderLinesAsTubes,
 * RenderPointsAsSpheres, VertexVisibility and VertexColor, but not on textures by name
 * (SetInputTexture() sets one). A setting without effect causes a warning, once for as long as it
 * stays; this includes FeatureAngle and Splitting if they are changed although no input needs
 * computed normals. Shading multiplies up to six lengths, so coordinates and distances must lie
 * between about 1e-50 and 1e50.
 *
 * @par Thanks:
 * Ray-triangle test: S. Woop, C. Benthin, I. Wald, "Watertight Ray/Triangle
 * Intersection", JCGT 2(1), 2013. Tiles of rays instead of a tree of triangles:
 * W. Hunt, W. Mark, "Ray-Specialized Acceleration Structures for Ray Tracing",
 * IEEE Symposium on Interactive Ray Tracing, 2008; T. Davidovic et al., "3D
 * Rasterization: A Bridge between Rasterization and Ray Casting", Graphics
 * Interface 2012. Ray-sphere test: E. Haines et al., "Precision Improvements for Ray/Sphere
 * Intersection", Ray Tracing Gems, ch. 7, 2019. Smooth shading: B. T. Phong, CACM 18(6), 1975.
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
class vtkCompositeDataDisplayAttributes;
class vtkLight;
class vtkLightCollection;
class vtkMatrix4x4;
class vtkProperty;
class vtkScalarsToColors;
class vtkTexture;

class VTKLAMBENT_EXPORT vtkLambentRayTracer : public vtkLambentAlgorithm
{
public:
  static vtkLambentRayTracer* New();
  vtkTypeMacro(vtkLambentRayTracer, vtkLambentAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The camera, perspective or parallel. It is shared with the caller. Update() never
   * modifies it; changing it makes the image out of date. Default: none (nullptr). The
   * view is then that of a new vtkCamera (looking along -z, y up, view angle 30 degrees),
   * reset to the bounds of the inputs.
   */
  virtual void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera() { return this->Camera; }
  ///@}

  /**
   * Move the camera along its direction until the inputs' bounding sphere is just in view,
   * as vtkRenderer::ResetCamera() does: the view angle becomes 30 degrees and the focal
   * point the centre of the bounds; position and parallel scale follow. Updates the inputs.
   * Creates a camera if none is set.
   */
  virtual void ResetCamera();

  ///@{
  /**
   * The lights. They have vtkLight's switch, intensity, diffuse and specular colour, light type
   * (headlight, camera light, scene light), position, focal point and transform matrix;
   * positional lights also have its cone angle, exponent and attenuation. They are shared
   * with the caller, and Update() never modifies them. Default: none; the scene then has a
   * white headlight along the view direction. A positional light whose three attenuation
   * values are all 0 or less is an error; a light aimed at its own position causes a
   * warning.
   *
   * @warning By default a positional vtkLight has a cone angle of 30 degrees, so it is a
   * spot light. With 90 degrees or more it shines in all directions.
   * @note vtkLight::SetColor() sets the diffuse and the specular colour, the ones used here. The
   * specular colour is that of the highlights; VTK's OpenGL renderer uses the diffuse one instead.
   */
  void AddLight(vtkLight* light);
  void RemoveLight(vtkLight* light);
  void RemoveAllLights();
  vtkLightCollection* GetLights();
  ///@}

  ///@{
  /**
   * The surface property of each input that does not have its own. It is shared with the
   * caller. VTK_FLAT interpolation shades with face normals; VTK_GOURAUD (vtkProperty's
   * default) and VTK_PHONG shade with interpolated point normals. With Lighting off the
   * surface has the plain DiffuseColor. Default: none (nullptr), which means white,
   * ambient 0, diffuse 1, smooth.
   *
   * Specular above 0 adds Phong's highlights with SpecularColor, which vtkProperty::SetColor()
   * sets, too, and SpecularPower. A power below 0 is an error.
   *
   * With EdgeVisibility, the edges of polygons, and of the triangles of strips, are drawn on them:
   * LineWidth pixels wide, in the plain EdgeColor, and mixed with the surface by EdgeOpacity if VTK
   * has that (9.3 and newer). Faces never hide their own edges. Passes do not show edges.
   */
  virtual void SetProperty(vtkProperty* property);
  vtkProperty* GetProperty() { return this->Property; }
  ///@}

  ///@{
  /**
   * The surface property of one input connection of port 0, counted from 0 in the order of
   * AddInputConnection(). nullptr removes it, and the property of SetProperty() applies. It
   * stays with its connection: when that connection is removed, the property is dropped, and
   * the properties of later connections move up with them. When all connections are replaced
   * at once (SetInputConnection(), SetInputData()) or removed, properties stay with their
   * numbers. A negative connection is an error. Default: none.
   */
  virtual void SetInputProperty(int connection, vtkProperty* property);
  vtkProperty* GetInputProperty(int connection);
  ///@}

  ///@{
  /**
   * An affine transform of one input connection, as vtkActor's matrix. It is shared with the
   * caller, and follows its connection as the property does. Points are transformed in double
   * precision, normals by the inverse transpose; positions and depths are those of the transformed
   * surface. Normals are computed after the transform. The front of a face stays its front, also if
   * the matrix mirrors (its determinant is negative). A matrix that is singular, not finite, or
   * whose last row is not 0 0 0 1 is an error. Default: none (nullptr), the identity, which costs
   * nothing.
   *
   * @note vtkActor with VTK's OpenGL mapper transforms points and normals in the same way, but in
   * float, and does not treat mirrors in any special way: OpenGL takes the side that appears
   * counter-clockwise for the front. So a mirrored mesh is turned inside out: culling removes the
   * other side, and given normals are turned away from the viewer, which makes the outside dark.
   * That is not copied.
   */
  virtual void SetInputTransform(int connection, vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetInputTransform(int connection);
  ///@}

  ///@{
  /**
   * The visibility and colours of the blocks of one composite input connection. They are shared
   * with the caller, and follow their connection as the property does. As in
   * vtkCompositePolyDataMapper2, they are looked up by the block's data object, and apply to all
   * blocks below it that do not have their own: hiding a block hides its subtree, except for blocks
   * that are set visible. A colour replaces the property's diffuse and ambient colours, and those
   * of an array; the coefficients stay. An opacity replaces that of the property. Other attributes
   * are ignored. Colours that are not finite, and opacities that are not from 0 to 1, are errors.
   * The attributes also apply to an input that is a single vtkPolyData. Default: none (nullptr);
   * all blocks are visible and look as the property says.
   *
   * @note RemoveBlockColor() and some other Remove...() methods of VTK's class do not change its
   * modification time. Call Modified() after them.
   */
  virtual void SetInputBlockAttributes(
    int connection, vtkCompositeDataDisplayAttributes* attributes);
  vtkCompositeDataDisplayAttributes* GetInputBlockAttributes(int connection);
  ///@}

  ///@{
  /**
   * Colours from an array of an input, for one connection, as vtkMapper has them in its default
   * colour mode. They replace the diffuse and the ambient colour of its property; the
   * coefficients and the light model stay. Default: off; the other settings are used when it is
   * on. An input without active scalars then keeps the property's colours, with a warning; so
   * does, without one, a block of a composite input that lacks the array.
   *
   * An array of unsigned char is colours itself, with 1 (grey), 2 (grey, alpha), 3 or 4
   * components; a byte b stands for b / 255. All other arrays are mapped through a table.
   * Alpha, of the array or of the table, multiplies the opacity of the property. Colours of points,
   * and their alpha, are interpolated across a face with the
   * barycentric coordinates of the hit; colours of cells are constant.
   */
  void SetInputScalarVisibility(int connection, bool visibility);
  bool GetInputScalarVisibility(int connection);
  ///@}

  ///@{
  /**
   * The array: its association, vtkDataObject::FIELD_ASSOCIATION_POINTS or _CELLS, and its
   * name. Without a name (nullptr or ""), the active scalars of the points are used, or, if
   * there are none, those of the cells. Default: without a name. An array that does not exist,
   * is no vtkDataArray, or does not have one tuple per point or cell, is an error.
   */
  void SetInputColorArray(int connection, int association, const char* name);
  const char* GetInputColorArrayName(int connection);
  int GetInputColorArrayAssociation(int connection);
  ///@}

  ///@{
  /**
   * The component that is mapped, from 0, or -1 for the magnitude of the tuple, which, as in VTK,
   * is the number itself if there is only one. A component that the array does not have is an
   * error. Default: 0.
   */
  void SetInputColorComponent(int connection, int component);
  int GetInputColorComponent(int connection);
  ///@}

  ///@{
  /**
   * The table: a vtkLookupTable (linear or logarithmic, with colours for NaN and for numbers
   * below and above its range), or any other vtkScalarsToColors, with annotations, too. It is
   * shared with the caller. Update() never modifies it; changing it makes the image out of
   * date. As in vtkMapper, a table of the array itself (vtkDataArray::SetLookupTable()) comes
   * first. A table without colours is an error. Default: none (nullptr), which means a new
   * vtkLookupTable, from red to blue.
   */
  void SetInputLookupTable(int connection, vtkScalarsToColors* table);
  vtkScalarsToColors* GetInputLookupTable(int connection);
  ///@}

  ///@{
  /**
   * The range of numbers that the table covers. It has no effect on tables that have a fixed
   * one, such as a vtkColorTransferFunction. A range that is reversed or not finite is an
   * error, as is one that does not lie above 0 if the table is logarithmic. Default: none, or
   * none again after ResetInputScalarRange(); then the range is that of the table, or, if no
   * table is set, that of the array's finite numbers, over all blocks of a composite input.
   * GetInputScalarRange() returns whether a range is set.
   */
  void SetInputScalarRange(int connection, double low, double high);
  void ResetInputScalarRange(int connection);
  bool GetInputScalarRange(int connection, double range[2]);
  ///@}

  ///@{
  /**
   * Interpolate the numbers of points across a face, and map them at each hit. Otherwise the
   * colours of points are interpolated, which may give colours that are not in the table. Not
   * used for cell arrays and tables with annotations, as in vtkMapper. A vtkLookupTable is
   * used as it is; other tables are sampled at the middle of 4096 intervals. Default: off.
   */
  void SetInputInterpolateScalarsBeforeMapping(int connection, bool before);
  bool GetInputInterpolateScalarsBeforeMapping(int connection);
  ///@}

  ///@{
  /**
   * A texture of one input connection, as vtkActor's. It is shared with the caller, and follows its
   * connection as the property does. Its image is brought up to date when the picture is rendered.
   * The image covers the unit square of the points' texture coordinates
   * (vtkPointData::GetTCoords(), 1 to 3 components, of which the first two are used), which are
   * interpolated across a face. As with VTK's OpenGL mapper, the colour of the texture multiplies
   * the colour of the lit surface, its colour in the property or array and all its light alike;
   * with Lighting off and a white surface, the texture is seen unchanged. Its alpha
   * multiplies the opacity.
   *
   * It has vtkTexture's Interpolate, Wrap (with BorderColor), Transform (affine),
   * UseSRGBColorSpace (of unsigned char), ColorMode and LookupTable. As there, unsigned char is
   * colours, and all else is mapped, unless ColorMode says otherwise: direct scalars make colours
   * of unsigned short and float with three or four components, too. Images are not reduced
   * where they are small (Mipmap); SetSupersampling() averages. The blending mode and
   * ShowTexturesOnBackface have no effect, with a warning, nor have textures on spheres.
   *
   * A texture coordinate that is not finite selects the first row or column of the image, or its
   * border colour. Errors are missing texture coordinates (of a composite input: if no block has
   * some; blocks that have none look as without the texture) and those of the wrong length; a cube
   * map, a missing, empty or three-dimensional image, one of more than four components of colours,
   * and a transform that is not affine. An input without faces needs no texture coordinates.
   * Default: none (nullptr).
   *
   * @note Do not connect the texture to the output of this same filter.
   */
  virtual void SetInputTexture(int connection, vtkTexture* texture);
  vtkTexture* GetInputTexture(int connection);
  ///@}

  ///@{
  /**
   * Draw a sphere of this radius, in world units, at each point of one input, used by cells or
   * not. A transform moves the points and does not change the radius. The input's polygons and
   * strips are then not drawn. These are true spheres: their outlines are round at any size. Their
   * normals are those of the sphere, even with flat shading; their front is the outside. "CellIds"
   * has the number of a sphere's point. AddPassArray() gives point arrays the value of that point,
   * cell arrays NaN. Points that are not finite are skipped, with one warning. A radius that is
   * negative or not finite is an error of Update(); a negative connection is an error. Like the
   * property of SetInputProperty(), it stays with its connection. Default: 0, no spheres.
   */
  virtual void SetInputSphereRadius(int connection, double radius);
  double GetInputSphereRadius(int connection);
  ///@}

  ///@{
  /**
   * Draw spheres whose radii are the values of a point array of one input, times
   * SetInputSphereRadius() if that is not 0, as vtkPointGaussianMapper and vtkGlyph3DMapper
   * multiply their scale array and scale factor. The array needs one component of any numeric
   * type. Points with radius 0 have no sphere. A missing array, one without a number for each
   * point, and values that are negative or not finite are errors of Update(). nullptr or an empty
   * name: no array, the default.
   */
  virtual void SetInputSphereRadiusArray(int connection, const char* name);
  const char* GetInputSphereRadiusArray(int connection);
  ///@}

  ///@{
  /**
   * As in vtkAlgorithm; the settings of SetInputProperty() and the other SetInput... methods
   * follow their connections.
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
   * Use the point normals of smooth inputs. If this is off, or an input has none, they are
   * computed for this image; see Splitting. Default: on.
   */
  vtkSetMacro(UsePointNormals, vtkTypeBool);
  vtkGetMacro(UsePointNormals, vtkTypeBool);
  vtkBooleanMacro(UsePointNormals, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Keep edges sharp where normals are computed: edges between two faces whose normals
   * differ by more than FeatureAngle. The normal at a corner of a face is then the
   * angle-weighted mean over all faces that can be reached around the point without crossing
   * a sharp edge. If a face occurs twice, once in each orientation, each side has its own
   * normals. No points are copied. Off has the effect of a FeatureAngle of 180. An input's
   * own normals are used unchanged. Default: on.
   */
  vtkSetMacro(Splitting, vtkTypeBool);
  vtkGetMacro(Splitting, vtkTypeBool);
  vtkBooleanMacro(Splitting, vtkTypeBool);
  ///@}

  ///@{
  /**
   * The largest angle, in degrees, between the normals of two faces whose common edge is
   * still smooth when Splitting is on; clamped to [0, 180]. At 180 the surface is smooth
   * everywhere. A coarse cylinder or sphere whose faces meet at larger angles shows facets;
   * raise the angle. Default: 30.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  /**
   * The latest modification time of this filter, the camera, the lights (with their
   * transform matrices), the properties, the transforms, the block attributes, the lookup
   * tables, and the textures with their transforms, lookup tables and images.
   */
  vtkMTimeType GetMTime() override;

  /**
   * Includes the filters that produce the images of textures.
   */
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputs,
    vtkInformationVector* outputs, int port, vtkMTimeType* time) override;

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

  template <typename Change>
  void ChangeInput(int connection, const char* method, const Change& change);
  void PrintInputs(ostream& os, vtkIndent indent);

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
