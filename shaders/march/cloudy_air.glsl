// cloudy_air.glsl: where what clouds change of the light of air lies in its table, by pixel and
// distance.
#pragma once
#include "../shared/frame.glsl"

/// Number of the first ray along each axis, counted from the lower left of the whole image.
ivec2 firstCloudyAirNode() {
    return u_.whole.zw / int(u_.cloudyAir.z);
}

/// Distance of a layer: finer near the eye.
float cloudyAirDistanceM(int layer, int layers) {
    float share = float(layer) / float(layers - 1);
    return mix(u_.cloudyAir.x, u_.cloudyAir.y, share * share);
}

/// Place of a distance along a pixel's ray in the table.
vec3 inCloudyAir(ivec2 pixel, float distanceM, ivec3 size) {
    vec2 node = (vec2(pixel + u_.whole.zw) + 0.5) / u_.cloudyAir.z - vec2(firstCloudyAirNode());
    float share = (distanceM - u_.cloudyAir.x) / (u_.cloudyAir.y - u_.cloudyAir.x);
    float layer = sqrt(clamp(share, 0.0, 1.0)) * float(size.z - 1);
    return (vec3(node, layer) + 0.5) / vec3(size);
}
