// sampling.h: how finely an image is computed.
//
// None of this is part of a look: with more steps, or another seed, an image has another error but
// shows the same. So presets leave it out, and sessions keep it. The slicing engine's planes are
// part of the look, since the equations as [Riley03] prints them give another brightness with
// another number of planes (docs/physics.md §3).
#pragma once

namespace neph {

struct Sampling {
    float quality = 1.0f;       ///< steps per voxel of the march
    int lightVoxels = 450000;   ///< at most about so many, of full transport
    float targetError = 0.02f;  ///< relative standard error at which the reference rests
    int seed = 0;               ///< of the reference's random numbers
    bool operator==(const Sampling&) const = default;
};

}  // namespace neph
