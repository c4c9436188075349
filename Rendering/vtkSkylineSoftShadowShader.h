// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSkylineSoftShadowShader
 * @brief light on a height field, for the fragment shader of a poly data mapper
 *
 * Holds the light of a terrain: point arrays of its height field, which become textures at the
 * resolution of the posts, and lights, which become uniforms. The Mode selects how the light is
 * computed:
 * - IRRADIANCE: from the array Irradiance (RGB), which is the sum of all lights;
 * - TRANSFER: the product of the array TransferSH (16 coefficients of visibility times cosine) and
 *   the 16 coefficients of the light;
 * - VISIBILITY: the triple product of the array VisibilitySH (16 coefficients), the clamped cosine
 *   around the normal of the heights at each fragment, and the light;
 * - RECEIVER: from the arrays of vtkHeightFieldShadowHeight: ShadowHeight, or ShadowHeightUpper and
 *   ShadowHeightLower, and the field array ShadowSun. Draws objects that stand or fly over the
 *   height field (houses, aircraft, a point cloud) in the shadow of the terrain. Their light is
 *   that of the sun, times the visible part of its disc at the height of the fragment (as in
 *   vtkHeightFieldShadowReceiver), times the cosine, plus that of a sky that nothing hides, which
 *   the 16 coefficients describe.
 *
 * In each mode, up to four lamps can add light, from the array LampIrradiance.
 *
 * The ground is Lambertian: its radiance is albedo * E / pi. The albedo is the colour that VTK
 * would show without light: the diffuse colour of the actor, colours from scalars, or draped
 * textures, as sRGB codes. The exposure and the tone curve are applied to the result, which is
 * shown as sRGB codes.
 *
 * Other mappers use this class as vtkSkylineSoftShadowPolyDataMapper does: call Prepare before
 * drawing, ReplaceShaderValues on the shader templates (instead of the mapper's own light), then
 * Activate, SetUniforms for each program, and Deactivate. The mesh must be in the coordinates of
 * the image. The matrix of an actor does not change the light, except in the mode RECEIVER, where
 * it moves the mesh through the shadow (SetPlacement). Several mappers can share one shader and its
 * textures.
 *
 * Missing posts (NaN) take their light from their neighbours, so that a mesh with coarser cells has
 * no black edges. The axes are x east, y north and z up. Harmonics are real, orthonormal and
 * without the Condon-Shortley phase; their index is l * l + l + m.
 */
#ifndef vtkSkylineSoftShadowShader_h
#define vtkSkylineSoftShadowShader_h

#include "SkylineRenderingModule.h" // For export macro
#include "vtkObject.h"
#include "vtkShader.h"              // For ReplaceShaderValues
#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"        // For HeightField

#include <map>    // For ReplaceShaderValues
#include <memory> // For Internals
#include <string> // For names

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithmOutput;
class vtkImageData;
class vtkMatrix4x4;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexBufferObjectGroup;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

class SKYLINERENDERING_EXPORT vtkSkylineSoftShadowShader : public vtkObject
{
public:
  static vtkSkylineSoftShadowShader* New();
  vtkTypeMacro(vtkSkylineSoftShadowShader, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What the light is computed from; see SetMode.
  enum ModeType
  {
    IRRADIANCE,
    TRANSFER,
    VISIBILITY,
    RECEIVER
  };

  /// The normals of a mesh in the mode RECEIVER: those of its faces, those of its points, or none.
  /// Primitives without normals, such as points and lines, are lit as if they faced the sun.
  enum NormalType
  {
    FACES,
    POINTS,
    NONE
  };

  ///@{
  /**
   * How the light is computed, a ModeType. Default: IRRADIANCE.
   */
  void SetMode(int mode);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /**
   * The height field with the arrays: a two-dimensional image, or the output of an algorithm, which
   * is updated before drawing. Default: none.
   */
  void SetHeightField(vtkImageData* image);
  vtkImageData* GetHeightField();
  void SetHeightFieldConnection(vtkAlgorithmOutput* output);
  ///@}

  ///@{
  /**
   * Names of the point arrays. Defaults: Irradiance, TransferSH, VisibilitySH, LampIrradiance,
   * Elevation (heights in metres, from which the normals are computed; if there is no array with
   * this name, the active scalars).
   */
  vtkSetMacro(IrradianceArrayName, std::string);
  vtkGetMacro(IrradianceArrayName, std::string);
  vtkSetMacro(TransferArrayName, std::string);
  vtkGetMacro(TransferArrayName, std::string);
  vtkSetMacro(VisibilityArrayName, std::string);
  vtkGetMacro(VisibilityArrayName, std::string);
  vtkSetMacro(LampArrayName, std::string);
  vtkGetMacro(LampArrayName, std::string);
  vtkSetMacro(ElevationArrayName, std::string);
  vtkGetMacro(ElevationArrayName, std::string);
  ///@}

  ///@{
  /**
   * The irradiance of the mode IRRADIANCE as a texture that already is on the graphics processor,
   * with one texel per post of the height field: three components, floats, linear light. It
   * replaces the array, which then need not exist, so that light computed on the graphics processor
   * is never read back. The texture belongs to the context of the window that draws, and its owner
   * releases it. Default: none.
   */
  void SetIrradianceTexture(vtkTextureObject* texture);
  vtkTextureObject* GetIrradianceTexture();
  ///@}

  ///@{
  /**
   * Coefficient 0 to 15 of the light in the modes TRANSFER, VISIBILITY and RECEIVER, linear RGB.
   * Default: those of SetUniformLight(1, 1, 1). A change only sets uniforms. Another index is an
   * error.
   */
  void SetLightCoefficient(int index, double red, double green, double blue);
  void GetLightCoefficient(int index, double rgb[3]);
  ///@}

  /**
   * Sets the coefficients of a light with the same radiance in all directions, linear RGB.
   */
  void SetUniformLight(double red, double green, double blue);

  ///@{
  /**
   * Radiance of lamp 0 to 3, linear RGB, at least 0. Component i of the array LampIrradiance is the
   * irradiance from lamp i at radiance 1. Default: black. If all lamps are black, the shader
   * contains no lamps.
   */
  void SetLampRadiance(int lamp, double red, double green, double blue);
  void GetLampRadiance(int lamp, double rgb[3]);
  bool HasLamps();
  ///@}

  ///@{
  /**
   * Irradiance that the sun of the mode RECEIVER gives a plane facing it, linear RGB. Default: 1,
   * 1, 1. A change only sets uniforms. The direction of the sun comes with the shadow heights.
   */
  void SetSunIrradiance(double red, double green, double blue);
  void GetSunIrradiance(double rgb[3]);
  ///@}

  ///@{
  /**
   * Depth below ShadowHeight over which the sunlight fades out, in metres, in the mode RECEIVER, as
   * in vtkHeightFieldShadowReceiver. Default: 0, a sharp edge of the shadow. Not used with the
   * shadow heights of both limbs.
   */
  void SetPenumbraDepth(double depth);
  double GetPenumbraDepth();
  ///@}

  ///@{
  /**
   * Exposure in stops: the light is multiplied by 2 to this power. Default: 0, with which level
   * open ground under an irradiance of pi appears in the colour of its albedo. A change only sets a
   * uniform.
   */
  vtkSetMacro(Exposure, double);
  vtkGetMacro(Exposure, double);
  ///@}

  ///@{
  /**
   * Whether to apply the tone curve. If off, light above 1 is clipped. Default: on.
   */
  void SetToneMapping(bool on);
  vtkGetMacro(ToneMapping, bool);
  vtkBooleanMacro(ToneMapping, bool);
  ///@}

  ///@{
  /**
   * Whether draped textures provide linear light (vtkTexture::UseSRGBColorSpaceOn), and whether the
   * framebuffer converts to sRGB codes itself. vtkSkylineSoftShadowPolyDataMapper sets both.
   * Default: off.
   */
  void SetLinearTextures(bool on);
  vtkGetMacro(LinearTextures, bool);
  void SetLinearFramebuffer(bool on);
  vtkGetMacro(LinearFramebuffer, bool);
  ///@}

  /**
   * Uploads changed arrays to textures of the window, whose context must be current. Returns false
   * if the terrain cannot be lit: there is no height field, an array is missing, there are more
   * posts than a texture can hold, or, in the mode VISIBILITY, the filters would refuse the heights
   * or their georeference. The reason is reported as an error, once until it changes.
   */
  bool Prepare(vtkOpenGLRenderWindow* window);

  /**
   * Inserts the light into the shader templates of a poly data mapper. To be called before VTK's
   * own replacements. The mapper must omit VTK's lights (ReplaceShaderLight) and, in the mode
   * RECEIVER, VTK's normals (ReplaceShaderNormal). normals: a NormalType, used in the mode
   * RECEIVER.
   */
  void ReplaceShaderValues(
    const std::map<vtkShader::Type, vtkShader*>& shaders, int normals = FACES);

  /**
   * The matrix of the actor for which SetUniforms is called next, or null if it has none. Used in
   * the mode RECEIVER.
   */
  void SetPlacement(vtkMatrix4x4* matrix);

  ///@{
  /**
   * To be called around drawing: Activate, then SetUniforms for each program, then Deactivate.
   * buffers: the vertex buffers of the mapper, which hold the shift and scale of the vertices.
   */
  void Activate();
  void SetUniforms(vtkShaderProgram* program, vtkOpenGLVertexBufferObjectGroup* buffers);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);
  ///@}

  /**
   * Number of textures uploaded so far. A change of the lights uploads none.
   */
  int GetNumberOfTextureUploads();

  /**
   * The time at which the text of the shader last changed. A mapper must include it in its own
   * modified time.
   */
  vtkMTimeType GetTextTime();

protected:
  vtkSkylineSoftShadowShader();
  ~vtkSkylineSoftShadowShader() override;

private:
  struct Internals;

  std::string Upload(vtkOpenGLRenderWindow* window);

  int Mode = IRRADIANCE;
  std::string IrradianceArrayName = "Irradiance";
  std::string TransferArrayName = "TransferSH";
  std::string VisibilityArrayName = "VisibilitySH";
  std::string LampArrayName = "LampIrradiance";
  std::string ElevationArrayName = "Elevation";
  double Exposure = 0.0;
  bool ToneMapping = true;
  bool LinearTextures = false;
  bool LinearFramebuffer = false;
  std::unique_ptr<Internals> Internal;

  vtkSkylineSoftShadowShader(const vtkSkylineSoftShadowShader&) = delete;
  void operator=(const vtkSkylineSoftShadowShader&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
