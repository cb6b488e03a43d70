// march_eye.comp: Eq. 5 along each pixel's ray, in runs of four steps.
//
// A run leaps over what is empty, reads once what varies slowly (the mixture) and four times what
// varies fast (extinction and light). Each step is sampled at one place within it, the same share
// of the step in all steps of a pixel, which differs from pixel to pixel by a blue-noise pattern.
// PROFILE counts; FLOOR repeats the rays and samples of a picture with one fetch each and nothing
// else, to measure against.
#version 450 core
layout(local_size_x = 8, local_size_y = 8) in;
#include "backdrop.glsl"
#include "packed_sample.glsl"
#include "phases.glsl"
#include "ray_in_box.glsl"

layout(location = 0) uniform int firstRow;  // of the band of rows that is drawn
layout(location = 1) uniform float blend;   // of this picture in the mean: 1 for the first
layout(rgba32f, binding = 0) uniform image2D io_linear;
layout(binding = 6) uniform sampler2D t_blueNoise;  // repeats
#if PROFILE
layout(r32ui, binding = 1) writeonly uniform uimage2D o_taken;
layout(std430, binding = 2) buffer Counts {
    uint rays, taken, skipped, terminated;
}
counts_;
#endif
#if FLOOR
layout(r32ui, binding = 1) readonly uniform uimage2D i_taken;
layout(binding = 7) uniform sampler3D t_floor;
#endif

const int kRun = 4;
const float kOpaque = 0.005;  // transmittance below which a ray ends
const float kLog2E = 1.44269504;

struct Eye {
    vec3 radiance;
    float through;
    uint taken, skipped;
};

/// In [0, 1): a different place for each pixel and each picture. The golden ratio's fraction
/// spreads the pictures evenly.
float placeInStep(ivec2 pixel) {
    float pattern = texelFetch(t_blueNoise, pixel & 63, 0).r;
    return fract(pattern + 0.61803399 * float(u_.sampling.x));
}

/// Length of step for a level of extinction. As core says it: 2^((level - 240) / 8) per metre.
float stepM(uint level) {
    float mostPerM = exp2((float(level) - 240.0) / 8.0);
    return u_.march.x * clamp(u_.march.y / (mostPerM * u_.march.x), u_.march.z, u_.march.w);
}

/// Leaps from empty brick to empty brick; returns the level of the brick where that ends.
uint leap(Ray ray, float endM, inout float atM, inout uint skipped) {
    uvec2 brick = brickAt(ray.originM + atM * ray.dir);
    while (brick.r > 0u && atM < endM) {
        // A thousandth of a brick over the wall, so that rounding cannot hold the ray at it.
        atM +=
            emptyDistanceM(ray.originM + atM * ray.dir, ray.dir, int(brick.r)) + 1e-3 * u_.brickM.x;
        brick = brickAt(ray.originM + atM * ray.dir);
        ++skipped;
    }
    return brick.g;
}

#if NOISE
/// Each kind of noise at a point, from the nearest texel to a place jittered within one texel: on
/// average this is linear interpolation.
void noisesAt(vec3 positionM, float random, out float noises[KINDS]) {
    vec3 jitter = (fract(random * vec3(1.0, 37.0, 91.0)) - 0.5) / NOISE_SIZE;
    for (int k = 0; k < KINDS; ++k) {
        vec4 noise = u_.classes[kClassOfKind[k]].noise;
        vec2 texel = textureLod(t_noise, positionM * noise.y + jitter, 0.0).rg;
        noises[k] = noise.z < 0.5 ? texel.r : texel.g;
    }
}
#endif

#if FLOOR
void runFloor(Ray ray, float atM, float h, float place, inout Eye eye) {
    for (int i = 0; i < kRun; ++i) {
        vec3 positionM = ray.originM + (atM + (float(i) + place) * h) * ray.dir;
        vec4 texel = textureLod(t_floor, positionM / u_.gridExtentM.xyz, 0.0);
        eye.radiance += texel.rgb * texel.a;
    }
}
#endif

/// One run of steps of length `h` from `atM`; steps beyond `endM` have no length.
void run(Ray ray, float atM, float endM, float h, float place, vec3 sunlit[CLASSES],
         inout Eye eye) {
    Mixture mixture = mixtureAt(ray.originM + (atM + 2.0 * h) * ray.dir);
    float lit = 0.0;
    float seen = 0.0;
    for (int i = 0; i < kRun; ++i) {
        float startM = atM + float(i) * h;
        vec3 positionM = ray.originM + (startM + place * h) * ray.dir;
        vec2 medium = textureLod(t_extinction, positionM / u_.gridExtentM.xyz, 0.0).rg;
        float extinctionPerM = medium.r;
#if NOISE
        float noises[KINDS];
        noisesAt(positionM, place + 0.7548777 * float(eye.taken + uint(i)), noises);
        extinctionPerM *= detailOf(mixture, noises);
#endif
        float segmentM = clamp(endM - startM, 0.0, h);
        float through = eye.through * exp2(-kLog2E * extinctionPerM * segmentM);
        lit += (eye.through - through) * exp2(-medium.g);
        seen += eye.through - through;
        eye.through = through;
    }
    vec3 sun = vec3(0.0);
    vec3 sky = vec3(0.0);
    for (int i = 0; i < CLASSES; ++i) {
        sun += mixture.share[i] * sunlit[i];
        sky += mixture.share[i] * u_.classes[i].colourAlbedo.rgb;
    }
    eye.radiance += lit * sun + seen * mixture.skylight * u_.ambient.rgb * sky;
}

Eye march(Ray ray, vec2 insideM, float place, uint most) {
    vec3 sunlit[CLASSES];
    for (int i = 0; i < CLASSES; ++i) sunlit[i] = sunlitBy(i, ray.dir);
    Eye eye = Eye(vec3(0.0), 1.0, 0u, 0u);
    float atM = insideM.x;
    while (atM < insideM.y && eye.through > kOpaque && eye.taken < most) {
        uint level = leap(ray, insideM.y, atM, eye.skipped);
        if (atM >= insideM.y) break;
        float h = stepM(level);
#if FLOOR
        runFloor(ray, atM, h, place, eye);
#else
        run(ray, atM, insideM.y, h, place, sunlit, eye);
#endif
        eye.taken += uint(kRun);
        atM += float(kRun) * h;
    }
    return eye;
}

/// What lies behind a ray that ended early is taken to be like what lies before.
void closeRay(inout Eye eye) {
    if (eye.through > kOpaque) return;
    eye.radiance /= 1.0 - eye.through;
    eye.through = 0.0;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, firstRow);
    if (any(greaterThanEqual(pixel, u_.picture.xy))) return;
    Ray ray = rayThrough(pixel);
    vec2 insideM = insideBoxM(ray);
    uint most = 0xffffffffu;
#if FLOOR
    most = imageLoad(i_taken, pixel).r;
#endif
    Eye eye = march(ray, insideM, placeInStep(pixel), most);
    closeRay(eye);
    vec4 seen = vec4(eye.radiance + eye.through * backdrop(ray, u_.slices.x), 1.0 - eye.through);
    if (blend < 1.0) seen = mix(imageLoad(io_linear, pixel), seen, blend);
    imageStore(io_linear, pixel, seen);
#if PROFILE
    imageStore(o_taken, pixel, uvec4(eye.taken, 0u, 0u, 0u));
    if (insideM.x < insideM.y) atomicAdd(counts_.rays, 1u);
    atomicAdd(counts_.taken, eye.taken);
    atomicAdd(counts_.skipped, eye.skipped);
    if (eye.through == 0.0) atomicAdd(counts_.terminated, 1u);
#endif
}
