// eye.comp: the eye buffer for one batch of slices: Eq. 5 summed along each pixel's ray,
// nearest sample first.
//
// A sample lies where the ray meets a slice and stands for the length of ray between two slices. It
// scatters the light that its slice received (Eq. 12) by the phase functions of its classes (Eq.
// 18), and skylight.
#version 450 core
#include "../shared/slicing_layout.glsl"
layout(local_size_x = kSlicingEyeGroup, local_size_y = kSlicingEyeGroup) in;
#include "../medium/phases.glsl"
#include "../medium/ray_in_box.glsl"
#include "../medium/sample.glsl"
#include "../medium/total_extinction.glsl"
#include "../shared/light_layout.glsl"
#include "../sky/air.glsl"

layout(binding = kLightUnit) uniform sampler2DArray t_light;
// Of the band of rows that is drawn.
layout(location = kSlicingFirstRowLocation) uniform int firstRow;
// rgb: radiance, a: transmittance.
layout(rgba32f, binding = kSlicingEyeImage) uniform image2D io_eye;

/// Slices of this batch that the ray meets within the occupied box and before the ground: first and
/// last, in light order.
ivec2 slicesMet(Ray ray, float t0, float perUnit) {
    vec2 inside = insideBoxM(ray);
    if (inside.x >= inside.y) return ivec2(1, 0);
    vec2 at = (inside - t0) / perUnit;
    ivec2 first = ivec2(ceil(min(at.x, at.y)), floor(max(at.x, at.y)));
    return ivec2(max(first.x, u_.slices.y), min(first.y, u_.slices.y + u_.slices.z - 1));
}

vec4 marchBatch(Ray ray) {
    float slope = dot(u_.normal.xyz, ray.dir);
    float perUnit = u_.lightScale.z / slope;  // ray length from one slice to the next, signed
    float t0 = (u_.normal.w + 0.5 * u_.lightScale.z - dot(u_.normal.xyz, ray.originM)) / slope;
    float segmentM = abs(perUnit);
    ivec2 met = slicesMet(ray, t0, perUnit);

    vec3 sunlit[CLASSES];
    for (int i = 0; i < CLASSES; ++i) sunlit[i] = sunlitBy(i, i, ray.dir);

    AirRay air;
    if (hasAir()) air = airRay(ray.dir);
    int forward = perUnit > 0.0 ? 1 : -1;
    int slice = forward > 0 ? met.x : met.y;
    vec3 radiance = vec3(0.0);
    float through = 1.0;
    while (slice >= met.x && slice <= met.y) {
        float atM = t0 + float(slice) * perUnit;
        vec3 positionM = pointAlong(ray, atM);
        int empty = emptiness(positionM);
        if (empty > 0) {
            float skipM = emptyDistanceM(positionM, ray.dir, empty);
            slice += forward * max(1, int(ceil(skipM / segmentM)));
            continue;
        }
        MediumSample s = sampleMedium(positionM);
        float extinctionPerM = totalExtinctionPerM(s);
        if (extinctionPerM > 0.0) {
            float light =
                textureLod(t_light, vec3(lightCoordinate(positionM), slice - u_.slices.y), 0.0).r;
            vec3 sun = sunAt(altitudeM(positionM));
            vec3 source = vec3(0.0);
            for (int i = 0; i < CLASSES; ++i) {
                source += s.extinctionPerM[i] *
                          (light * sun * sunlit[i] +
                           skylightOf(s) * u_.ambient.rgb * u_.classes[i].colourAlbedo.rgb);
            }
            float segment = exp(-extinctionPerM * segmentM);
            float seen = through * (1.0 - segment);
            vec3 sent = seen / extinctionPerM * source;
            radiance += hasAir() ? throughAir(air, atM, sent, seen) : sent;
            through *= segment;
            if (through < u_.forwardShare.z) {
                through = 0.0;
                break;
            }
        }
        slice += forward;
    }
    return vec4(radiance, through);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, firstRow);
    if (any(greaterThanEqual(pixel, u_.image.xy))) return;
    bool frontToBack = u_.forward.w > 0.0;
    vec4 before = imageLoad(io_eye, pixel);
    vec4 batch = vec4(0.0, 0.0, 0.0, 1.0);
    if (!frontToBack || before.a > 0.0) batch = marchBatch(rayThrough(pixel));
    vec4 near = frontToBack ? before : batch;
    vec4 far = frontToBack ? batch : before;
    imageStore(io_eye, pixel, vec4(near.rgb + near.a * far.rgb, near.a * far.a));
}
