// light_layout.glsl: the light buffer, and the pass that carries light from layer to layer. C++: in
// namespace neph::render.
#pragma once

// Texels along the edge of a tile; the work group of the light pass.
const int kLightTile = 16;

const int kLightUnit = 4;
const int kGroundLightUnit = 11;
const int kLightImage = 0;
const int kLightTilesBuffer = 3;
const int kLightLayerLocation = 0;
