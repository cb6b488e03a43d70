// slicing_layout.glsl: image units and locations of the eye's pass of half-angle slicing. C++: in
// namespace neph::render.
#pragma once

// Work groups are squares.
const int kSlicingEyeGroup = 8;
const int kSlicingEyeImage = 0;
const int kSlicingFirstRowLocation = 0;
