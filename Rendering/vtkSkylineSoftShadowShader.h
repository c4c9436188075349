// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSkylineSoftShadowShader
 * @brief light on a height field, for the fragment shader of a poly data mapper
 *
 * Holds what lights a terrain: point arrays of its height field, which become textures at the
 * resolution of the posts, and the lights, which are uniforms. Four ways to light, by Mode:
 * - IRRADIANCE: the array Irradiance (RGB), light that is already summed up;
 * - TRANSFER: the array TransferSH (16 coefficients of visibility times cosine) against the 16
 *   coefficients of the light;
 * - VISIBILITY: the array VisibilitySH (16 coefficients) times the clamped cosine around the
 *   normal of the heights, at every fragment, times the light;
 * - RECEIVER: the arrays ShadowHeight, or ShadowHeightUpper and ShadowHeightLower, and the field array
 *   ShadowSun, all of vtkHeightFieldShadowHeight. Draws whatever stands or flies over the height field (houses,
 *   aircraft, a point cloud) in the shadow of the terrain: the sun, as far as the terrain leaves its disc
 *   free at the fragment's own height (as vtkHeightFieldShadowReceiver finds it), times the cosine, and the
 *   16 coefficients of the light as a sky that nothing hides.
 * In each of them up to four lamps may add their own light, from the array LampIrradiance.
 *
 * The ground is Lambertian: it sends out albedo * E / pi. The albedo is what VTK would show without
 * light: the actor's diffuse colour, colours of scalars, draped textures, as sRGB codes. The
 * result is exposed, goes through the tone curve and is shown as sRGB codes.
 *
 * Other mappers call it as vtkSkylineSoftShadowPolyDataMapper does: Prepare before drawing,
 * ReplaceShaderValues on the templates (and no light of their own), Activate, SetUniforms for every
 * program, Deactivate. Positions of the mesh are those of the image; an actor's matrix does not
 * change the light, but in RECEIVER, where it moves the mesh through the shadow (SetPlacement). Several mappers may share one shader, and with it the textures.
 *
 * Missing posts (NaN) take light from their neighbours, so that a mesh with coarser cells has no
 * black rims. Angles and axes as everywhere: x east, y north, z up; harmonics real, orthonormal,
 * without the Condon-Shortley phase, index l * l + l + m.
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

  /// The normals of a mesh for RECEIVER: those of its faces, those of its points, or none: what has no
  /// side is lit as if turned to the sun.
  enum NormalType
  {
    FACES,
    POINTS,
    NONE
  };

  ///@{
  /**
   * Where the light comes from. Default IRRADIANCE.
   */
  void SetMode(int mode);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /**
   * The height field with the arrays: a 2-D image, or the output of an algorithm, which is updated
   * before drawing.
   */
  void SetHeightField(vtkImageData* image);
  vtkImageData* GetHeightField();
  void SetHeightFieldConnection(vtkAlgorithmOutput* output);
  ///@}

  ///@{
  /**
   * Names of the point arrays. Defaults: Irradiance, TransferSH, VisibilitySH, LampIrradiance,
   * Elevation (metres, for the normals; without an array of that name, the active scalars).
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
   * The light of IRRADIANCE as a texture that is on the graphics processor already, a texel a post of the
   * height field: three float components, linear. In place of the array, which then need not exist:
   * light that is computed there is never read back. It belongs to the window that draws, and its owner
   * releases it. Default none.
   */
  void SetIrradianceTexture(vtkTextureObject* texture);
  vtkTextureObject* GetIrradianceTexture();
  ///@}

  ///@{
  /**
   * Coefficient 0 to 15 of the light of TRANSFER and VISIBILITY, linear RGB. Default: that of
   * SetUniformLight(1, 1, 1). A change costs a few uniforms.
   */
  void SetLightCoefficient(int index, double red, double green, double blue);
  void GetLightCoefficient(int index, double rgb[3]);
  ///@}

  /**
   * Makes the light the same radiance from everywhere.
   */
  void SetUniformLight(double red, double green, double blue);

  ///@{
  /**
   * Radiance of lamp 0 to 3, linear RGB, 0 and up. The array LampIrradiance holds in component i what
   * lamp i gives at radiance 1. Default black; while all are black, the shader knows no lamps.
   */
  void SetLampRadiance(int lamp, double red, double green, double blue);
  void GetLampRadiance(int lamp, double rgb[3]);
  bool HasLamps();
  ///@}

  ///@{
  /**
   * Irradiance that the sun of RECEIVER gives a plane which faces it, linear RGB. Default 1, 1, 1. A
   * uniform; where the sun stands is the shadow heights' to say.
   */
  void SetSunIrradiance(double red, double green, double blue);
  void GetSunIrradiance(double rgb[3]);
  ///@}

  ///@{
  /**
   * How far below ShadowHeight light fades, metres; default 0, a hard edge. Of RECEIVER, as in
   * vtkHeightFieldShadowReceiver; counts without shadow heights of both limbs alone.
   */
  void SetPenumbraDepth(double depth);
  double GetPenumbraDepth();
  ///@}

  ///@{
  /**
   * Exposure in stops: light is multiplied by 2 to this power. Default 0, which shows level open
   * ground under an irradiance of pi as its albedo. A uniform.
   */
  vtkSetMacro(Exposure, double);
  vtkGetMacro(Exposure, double);
  ///@}

  ///@{
  /**
   * Whether the tone curve applies; else light above 1 is clipped. Default on.
   */
  void SetToneMapping(bool on);
  vtkGetMacro(ToneMapping, bool);
  vtkBooleanMacro(ToneMapping, bool);
  ///@}

  ///@{
  /**
   * Whether draped textures arrive as linear light (vtkTexture::UseSRGBColorSpaceOn), and whether
   * the framebuffer makes sRGB codes by itself. vtkSkylineSoftShadowPolyDataMapper sets both. Default off.
   */
  void SetLinearTextures(bool on);
  vtkGetMacro(LinearTextures, bool);
  void SetLinearFramebuffer(bool on);
  vtkGetMacro(LinearFramebuffer, bool);
  ///@}

  /**
   * Uploads what changed to textures of the window, whose context is current. Returns false where the
   * terrain cannot be lit: no height field, no such array, too many posts for a texture. An error
   * says why, in one line, once until the reason changes.
   */
  bool Prepare(vtkOpenGLRenderWindow* window);

  /**
   * Adds the light to the templates of a poly data mapper. To be called before VTK's own
   * replacements; the mapper must leave out VTK's lights (ReplaceShaderLight). normals: a NormalType,
   * for RECEIVER, in which the mapper must leave out VTK's normals too (ReplaceShaderNormal).
   */
  void ReplaceShaderValues(
    const std::map<vtkShader::Type, vtkShader*>& shaders, int normals = FACES);

  /**
   * The matrix of the actor that the next SetUniforms is for; null: none. Counts in RECEIVER.
   */
  void SetPlacement(vtkMatrix4x4* matrix);

  ///@{
  /**
   * Around drawing; SetUniforms for every program, with the mapper's buffers, which tell how the
   * vertices were shifted and scaled.
   */
  void Activate();
  void SetUniforms(vtkShaderProgram* program, vtkOpenGLVertexBufferObjectGroup* buffers);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);
  ///@}

  /**
   * How many textures have been uploaded so far. A light that changes uploads none.
   */
  int GetNumberOfTextureUploads();

  /**
   * When the text of the shader changed last. A mapper includes it in its own modified time.
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
  std::unique_ptr<Internals> Inside;

  vtkSkylineSoftShadowShader(const vtkSkylineSoftShadowShader&) = delete;
  void operator=(const vtkSkylineSoftShadowShader&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
