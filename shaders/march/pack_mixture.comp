// pack_mixture.comp: skylight and the classes' shares of the extinction, at half the resolution.
//
// One invocation a column of cells of 2 x 2 x 2 voxels; a linear fetch at their common corner is
// their mean. Shares are stored times a weight that grows with the extinction: where thin air lies
// beside thick cloud, interpolation then gives the cloud's. docs/physics.md §5
#version 450 core
layout(local_size_x = 8, local_size_y = 8) in;
#include "../lib/optics.glsl"
#include "../shared/march_layout.glsl"

layout(binding = kHeldUnit) uniform sampler3D t_held[SPECIES];  // those that are visible
const int kClassOfSpecies[SPECIES] = CLASS_OF_SPECIES;
layout(binding = kBesideHeldUnit) uniform sampler3D t_extinction;
layout(rgba8, binding = kPackMixture0Image) writeonly uniform image3D o_mixture0;
#if MIXTURE_TEXTURES > 1
layout(rgba8, binding = kPackMixture1Image) writeonly uniform image3D o_mixture1;
#endif
layout(location = kPackExtinctionPerTexelLocation) uniform float extinctionPerTexel[SPECIES];
layout(location = kPackLayerLocation) uniform float layerM;  // height of a voxel
layout(location = kPackAsymmetryLocation) uniform float asymmetry;
layout(location = kPackGroundLocation) uniform float groundShare;
layout(location = kPackCellLocation) uniform vec3 cellSize;  // as a share of the texture

vec3 cornerOf(ivec3 cell) {
    return (vec3(cell) + 0.5) * cellSize;
}

/// 1 for 1/m, an eighth for 1e-12/m and less: seven octaves of byte steps are left for the shares.
float presence(float extinctionPerM) {
    return clamp(1.0 + log2(max(extinctionPerM, 1e-30)) / 45.0, 0.125, 1.0);
}

void storeShares(ivec3 cell, float skylight) {
    float shares[2 * kClassesBesideSkylight];
    for (int i = 0; i < 2 * kClassesBesideSkylight; ++i) shares[i] = 0.0;
    float total = 0.0;
    for (int s = 0; s < SPECIES; ++s) {
        float e = extinctionPerTexel[s] * textureLod(t_held[s], cornerOf(cell), 0.0).r;
        shares[kClassOfSpecies[s]] += e;
        total += e;
    }
    float scale = total > 0.0 ? presence(total) / total : 0.0;
    imageStore(o_mixture0, cell,
               vec4(skylight, scale * shares[0], scale * shares[1], scale * shares[2]));
#if MIXTURE_TEXTURES > 1
    imageStore(o_mixture1, cell,
               vec4(scale * shares[3], scale * shares[4], scale * shares[5], 0.0));
#endif
}

void main() {
    ivec3 size = imageSize(o_mixture0);
    ivec2 column = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(column, size.xy))) return;
    float cellM = 2.0 * layerM;
    float total = 0.0;
    for (int z = 0; z < size.z; ++z) {
        total += cellM * textureLod(t_extinction, cornerOf(ivec3(column, z)), 0.0).r;
    }
    float above = total;
    for (int z = 0; z < size.z; ++z) {
        ivec3 cell = ivec3(column, z);
        float half_ = 0.5 * cellM * textureLod(t_extinction, cornerOf(cell), 0.0).r;
        above -= half_;
        float fromSky = skyTransmittance(max(above, 0.0), asymmetry);
        float fromGround = skyTransmittance(max(total - above, 0.0), asymmetry);
        above -= half_;
        storeShares(cell, (fromSky + groundShare * fromGround) / (1.0 + groundShare));
    }
}
