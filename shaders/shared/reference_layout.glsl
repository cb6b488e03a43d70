// reference_layout.glsl: sizes, texture and image units, buffers and locations of the reference's
// passes. C++: in namespace neph::render.
#pragma once
#include "medium_layout.glsl"

// Equally probable intervals of a table to draw from. Weights make up for what an interval does not
// resolve; with so many their variance is about 2e-4 per scattering for droplets, the worst.
const int kScatteringIntervals = 4096;

// Passes that are under way at a time.
const int kPassesAtOnce = 4;

// Words, of four numbers, that a lane keeps between two dispatches: of its path, and of each path
// that may wait for the end of a branch. shaders/reference/state.glsl
const int kPathWords = 10;
const int kWaitingWords = 4;
const int kMostWaiting = 8;
const int kLaneWords = kPathWords + kMostWaiting * kWaitingWords;

// Texture units beside those of medium_layout.glsl.
const int kCellsUnit = 5;
const int kNoiseBoundUnit = 6;
const int kScatteringUnit = 9;
const int kSunDepthUnit = 10;

// trace.comp
const int kLanesBuffer = 3;
const int kCountersBuffer = 4;
const int kResultsBuffer = 5;  // of gather.comp too
const int kDetectorsBuffer = 6;
const int kTraceLanesLocation = 0;
const int kTraceRoundsLocation = 1;
const int kTracePathsLocation = 2;
const int kTraceFirstTicketLocation = 3;
const int kTraceFirstPassLocation = 4;
const int kTraceSeedLocation = 5;
const int kTraceMaxScatteringsLocation = 6;
const int kTraceCellLocation = 7;
const int kTraceVoxelLocation = 8;
const int kTraceDiscLocation = 9;
const int kTraceRouletteLocation = 10;
const int kTraceMoleculesLocation = 11;
const int kTraceHazeLocation = 12;
const int kTraceMoleculesHeightLocation = 13;
const int kTraceHazeHeightLocation = 14;
const int kTraceHazeAlbedoLocation = 15;

// gather.comp
const int kGatherHalfImage = 0;
const int kGatherSquaresImage = 1;
const int kGatherOtherImage = 2;
const int kGatherMeanImage = 3;
const int kGatherFirstResultLocation = 0;
const int kGatherPerPathLocation = 1;

// error.comp
const int kErrorHalfAImage = 0;
const int kErrorSquaresImage = 1;
const int kErrorHalfBImage = 2;
const int kErrorRowsBuffer = 7;
const int kErrorPathsLocation = 0;

// cells.comp
const int kBoundImage = 0;
const int kBoundCellVoxelsLocation = 0;
const int kBoundAmountLocation = kBoundCellVoxelsLocation + 1;
const int kBoundTexelsPerMLocation = kBoundAmountLocation + kSpeciesCount;
const int kBoundCharacterLocation = kBoundTexelsPerMLocation + kSpeciesCount;
const int kBoundVoxelLocation = kBoundCharacterLocation + kSpeciesCount;
const int kBoundMovedLocation = kBoundVoxelLocation + 1;

// sun_depth.comp
const int kSunDepthImage = 0;

// species_depths.comp: species as in bake.comp, medium_layout.glsl
const int kDepthsBuffer = 6;
const int kDepthsStepLocation = kClassOfLocation + kSpeciesCount;

// sun_disc.comp
const int kSunDiscImage = 0;
const int kSunDiscStepLocation = 0;

// cosines.comp
const int kCosinesBuffer = 6;
const int kCosinesCountLocation = 0;
const int kCosinesSeedLocation = 1;
