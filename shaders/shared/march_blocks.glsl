// march_blocks.glsl: what a profiled frame of the march counts (std430). C++: in namespace
// neph::render::block.
#pragma once

struct CountBlock {
    uint rays;        ///< that can meet anything
    uint taken;       ///< samples
    uint skipped;     ///< empty bricks
    uint terminated;  ///< rays that ended early
};
