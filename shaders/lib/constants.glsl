// constants.glsl: constants that the shader library shares.
//
// Every file of this folder is plain GLSL 4.5 (pure functions, without uniforms or samplers) and,
// through glsl_cpp.h, plain C++.
#pragma once

const float kPi = 3.14159265358979f;
const vec3 kLuminance = vec3(0.2126f, 0.7152f, 0.0722f);  ///< of linear sRGB
const float kInverseFourPi = 0.0795774715459477f;         ///< the isotropic phase function, 1/sr
