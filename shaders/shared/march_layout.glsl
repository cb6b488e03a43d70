// march_layout.glsl: texture and image units, buffers and locations of the passes of the march.
// C++: in namespace neph::render.
#pragma once
#include "medium_layout.glsl"

// The medium of the march, and what the eye reads besides: beside the units of medium_layout.glsl
// and light_layout.glsl.
const int kMarchExtinctionUnit = 0;
const int kMarchMixture0Unit = 1;
const int kMarchMixture1Unit = 5;
const int kMarchBlueNoiseUnit = 6;
const int kMarchFloorUnit = 7;
const int kMarchThicknessUnit = 9;
const int kMarchSourceUnit = 10;
const int kCloudyAirUnit = 12;
const int kSunThroughUnit = 13;
const int kAroundMoleculesUnit = 14;
const int kAroundHazeUnit = 15;

// eye.comp. Its work groups are squares.
const int kMarchEyeGroup = 8;
const int kMarchLinearImage = 0;
const int kMarchTakenImage = 1;
const int kMarchCountsBuffer = 2;
const int kMarchFirstRowLocation = 0;
const int kMarchBlendLocation = 1;

// Passes by the list of blocks.
const int kMarchBlocksBuffer = 0;
const int kMarchExtinctionImage = 0;

// pack_extinction.comp and pack_mixture.comp
const int kPackExtinctionPerTexelLocation = 0;

// pack_extinction.comp
const int kPackAmountLocation = kPackExtinctionPerTexelLocation + kSpeciesCount;
const int kPackTexelsPerMLocation = kPackAmountLocation + kSpeciesCount;
const int kPackCharacterLocation = kPackTexelsPerMLocation + kSpeciesCount;
const int kPackVoxelLocation = kPackCharacterLocation + kSpeciesCount;
const int kPackMovedLocation = kPackVoxelLocation + 1;

// light_nodes.comp
const int kNodesExtinctionBuffer = 4;
const int kNodesFirstVoxelLocation = 0;
const int kNodesSpacingLocation = 1;
const int kNodesSamplesLocation = 2;
const int kNodesCountLocation = 3;

// source_to_eye.comp. Of each active node as halves, two in a word: moments of the sun, then of the
// horizon and of the zenith.
const int kSourceImage = 0;
const int kSourceNodesBuffer = 4;
const int kSourceMomentsBuffer = 5;
const int kSourceBalancedBuffer = 6;
const int kSourceCountLocation = 0;
const int kSourceGroup = 64;
const int kSunMoments = 11;
const int kSkyMoments = 9;
const int kWordsOfSun = (kSunMoments + 1) / 2;
const int kWordsOfSky = (2 * kSkyMoments + 1) / 2;
const int kWordsOfNode = kWordsOfSun + kWordsOfSky;
const int kBalancedDegrees = 5;
const int kWordsOfBalanced = (kBalancedDegrees + 1) / 2;
// Where the domain repeats, the moments themselves lie in its texture, four a texel, layer upon
// layer: of the sun, of the sky, and where there are any the balanced ones.
const int kFirstSkyMoment = 2 * kWordsOfSun;
const int kFirstBalancedMoment = 2 * kWordsOfNode;
const int kMomentLayers = (kFirstBalancedMoment + 2 * kWordsOfBalanced) / 4;
const int kMomentLayersUnbalanced = (kFirstBalancedMoment + 3) / 4;

// sun_through.comp
const int kSunThroughImage = 0;
const int kSunThroughLayerLocation = 0;
const int kSunThroughGroup = 8;
const int kSlicesPerSunThrough = 2;

// cloudy_air.comp
const int kCloudyAirImage = 0;
const int kCloudyAirGroup = 8;

// light_around.comp, which also has kSourceGroup; the locations are of both.
const int kAroundMoleculesImage = 0;
const int kAroundHazeImage = 1;
const int kAroundMomentsBuffer = 4;
const int kAroundLowerLocation = 0;
const int kAroundSpacingLocation = 1;
const int kAroundParts = 3;
// Where the domain repeats: layers of moments in the texture of molecules.
const int kAroundLayers = (kAroundParts * kSkyMoments + 3) / 4;

// pack_mixture.comp
const int kPackMixture0Image = 0;
const int kPackMixture1Image = 1;
const int kPackLayerLocation = kPackExtinctionPerTexelLocation + kSpeciesCount;
const int kPackAsymmetryLocation = kPackLayerLocation + 1;
const int kPackGroundLocation = kPackAsymmetryLocation + 1;
const int kPackCellLocation = kPackGroundLocation + 1;
