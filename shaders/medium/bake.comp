// bake.comp: from what is held of the species (mass content or extinction) and the look to
// the medium: one extinction per optical class and voxel.
#version 450 core
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;
#include "../shared/medium_layout.glsl"

layout(binding = kHeldUnit) uniform sampler3D t_held[kSpeciesCount];  // kg/m³ or 1/m
layout(rgba32f, binding = kMedium0Image) writeonly uniform image3D o_medium0;
#if CLASS_TEXTURES > 1
layout(rgba32f, binding = kMedium1Image) writeonly uniform image3D o_medium1;
#endif
// m²/kg or 1; 0 when absent.
layout(location = kExtinctionPerHeldLocation) uniform float extinctionPerHeld[kSpeciesCount];
layout(location = kClassOfLocation) uniform int classOf[kSpeciesCount];

void main() {
    ivec3 voxel = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(voxel, imageSize(o_medium0)))) return;
    float extinction[8] = float[8](0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    for (int s = 0; s < kSpeciesCount; ++s) {
        if (classOf[s] < 0) continue;
        extinction[classOf[s]] += extinctionPerHeld[s] * texelFetch(t_held[s], voxel, 0).r;
    }
    imageStore(o_medium0, voxel, vec4(extinction[0], extinction[1], extinction[2], extinction[3]));
#if CLASS_TEXTURES > 1
    imageStore(o_medium1, voxel, vec4(extinction[4], extinction[5], extinction[6], extinction[7]));
#endif
}
