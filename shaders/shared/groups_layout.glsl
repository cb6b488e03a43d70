// groups_layout.glsl: what programs declare that run by the list. C++: in namespace neph::gl.
#pragma once

// Of the number of the first work group of a dispatch. Beyond all
// other uniforms.
const int kFirstGroupLocation = 100;
