// reference_blocks.glsl: structs in the buffers of the reference (std430). C++: in namespace
// neph::render::block, after reference_layout.glsl.
#pragma once
#include "reference_layout.glsl"

// What a detector reads.
const int kRadianceDetector = 0;
const int kFluxDetector = 1;
const int kDiffuseFluxDetector = 2;
const int kAbsorptionDetector = 3;

struct DetectorBlock {
    vec4 lowerM;  ///< w: which of the above
    vec4 upperM;
    vec4 direction;  ///< unit; w: the largest absorption that its points can have, 1/m
};

struct CounterBlock {
    uint tickets;                  ///< given out
    uint collisions;               ///< places where a particle may have been
    uint scatterings;              ///< particles that scattered
    uint faults;                   ///< paths whose radiance is not a number
    uint finished[kPassesAtOnce];  ///< paths, of each pass that is under way
};
