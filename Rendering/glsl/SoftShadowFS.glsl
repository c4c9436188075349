// SPDX-License-Identifier: BSD-3-Clause
// Light on a Lambertian ground. The albedo is the colour that VTK would show without light: the
// colour of the actor, of its scalars, or of a draped texture. SKYLINE_COLOR, SKYLINE_ALBEDO and
// SKYLINE_DEVELOP define where sRGB codes become light and light becomes codes: see
// vtkSkylineSoftShadowShader.cxx.
in vec2 skylinePostVSOutput;
uniform float skylineGain; // exposure divided by pi

//Fill::Functions
//Skyline::Color
  gl_FragData[0] = vec4(SKYLINE_COLOR(diffuseColor), opacity);
//Skyline::Impl
  vec3 skylineLight = SkylineIrradiance(skylinePostVSOutput);
  //Fill::Lamps
  gl_FragData[0].rgb =
    SKYLINE_DEVELOP(SKYLINE_ALBEDO(gl_FragData[0].rgb) * skylineLight * skylineGain);
