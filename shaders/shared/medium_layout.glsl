// medium_layout.glsl: sizes of the volume and of what is made of it; texture and image units,
// buffers and locations of the passes that make the medium of slicing and of the reference, and of
// all that read a medium. C++: in namespace neph::render.
#pragma once
#include "sizes.glsl"

// Voxels along the edge of a block, the unit in which bakes visit the volume, and of a brick, the
// unit in which emptiness is known: small, so that few samples fall where nothing is.
const int kBlockVoxels = 8;
const int kBrickVoxels = 4;

// Texels along the edge of a tile of noise, and levels of the stacked noise: down to 4 texels along
// the edge, less than one for the largest features.
const int kNoiseSize = 128;
const int kNoiseLevels = 6;

// Classes that share a texture with the skylight; where there are more, a second texture is used.
const int kClassesBesideSkylight = 3;

// Texture units. The march reads a medium of its own in units of its own; march_layout.glsl.
const int kMedium0Unit = 0;
const int kMedium1Unit = 1;
const int kBricksUnit = 2;
const int kNoiseUnit = 3;
const int kPhasesUnit = 8;

// Rows of a class for full transport: its phase function, then for voxels of thickness 0, 1 and 2
// the peak after one scattering forward, after two and after more. docs/transport.md
const int kPeakTimes = 3;
const int kPhaseRows = 1 + 3 * kPeakTimes;
const float kPeakEndCos = 0.5f;  // of the angle where the widest end, 60 degrees

// Bakes read a texture for each species, and one more.
const int kHeldUnit = 0;
const int kBesideHeldUnit = kHeldUnit + kSpeciesCount;

// bake.comp
const int kMedium0Image = 0;
const int kMedium1Image = 1;
const int kExtinctionPerHeldLocation = 0;
const int kClassOfLocation = kExtinctionPerHeldLocation + kSpeciesCount;

// bake_skylight.comp
const int kSkylightImage = 0;
const int kSkylightLayerLocation = 0;
const int kSkylightAsymmetryLocation = 1;
const int kSkylightGroundLocation = 2;

// sun_shown.comp
const int kSunShownLanes = 64;
const int kSunShownImage = 0;

// bake_noise.comp and brick_maximum.comp
const int kNoiseImage = 0;
const int kBrickMaximumImage = 0;
