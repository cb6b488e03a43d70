// eye.comp: Eq. 5 along each pixel's ray, in runs of four steps.
//
// A run skips what is empty, reads once what varies slowly (the mixture) and four times what
// varies fast (extinction and light). Each step is sampled at one place within it, the same share
// of the step in all steps of a pixel, which differs from pixel to pixel by a blue-noise pattern.
// PROFILE counts; FLOOR repeats the rays and samples of an image with one fetch each and nothing
// else, to measure against. docs/performance.md
#version 450 core
#include "../shared/march_layout.glsl"
layout(local_size_x = kMarchEyeGroup, local_size_y = kMarchEyeGroup) in;
#include "../display/backdrop.glsl"
#include "../lib/noise.glsl"
#include "../medium/phases.glsl"
#include "../medium/ray_in_box.glsl"
#include "../shared/march_blocks.glsl"
#include "packed_sample.glsl"

// Of the band of rows that is drawn.
layout(location = kMarchFirstRowLocation) uniform int firstRow;
// Of this image in the mean: 1 for the first.
layout(location = kMarchBlendLocation) uniform float blend;
layout(rgba32f, binding = kMarchLinearImage) uniform image2D io_linear;
layout(binding = kMarchBlueNoiseUnit) uniform sampler2D t_blueNoise;
#if NOISE
// A tile of billow, and of wisp upon it; nearest.
layout(binding = kNoiseUnit) uniform sampler3D t_noise;
// Classes with detail of one scale and character share a kind.
const int kKindOfClass[CLASSES] = KIND_OF_CLASS;
const int kClassOfKind[KINDS] = CLASS_OF_KIND;
#endif
#if PROFILE
layout(r32ui, binding = kMarchTakenImage) writeonly uniform uimage2D o_taken;
layout(std430, binding = kMarchCountsBuffer) buffer Counts {
    CountBlock counts_;
};
#endif
#if FLOOR
layout(r32ui, binding = kMarchTakenImage) readonly uniform uimage2D i_taken;
layout(binding = kMarchFloorUnit) uniform sampler3D t_floor;
#endif

#if FULL
// Of source_to_eye.comp.
layout(binding = kMarchSourceUnit) uniform sampler3D t_source;
#endif

const int kRun = 4;
const float kOpaque = 0.005;  // transmittance below which a ray ends
const float kLog2E = 1.44269504;

/// A ray in the units in which it is used.
struct Path {
    Ray ray;
    vec3 at, atPerM;        // in the medium's texture
    vec3 brick, brickPerM;  // in bricks
    vec3 mPerBrick;         // distance along the ray for one brick of each axis, signed
    float endM;             // of the part that can meet anything
    float place;            // within a step, in [0, 1)
};

struct Eye {
    vec3 radiance;
    float through;
    uint taken, skipped;
};

/// In [0, 1): a different place for each pixel and each image. The golden ratio's fraction
/// spreads the images evenly.
float placeInStep(ivec2 pixel) {
    float pattern = texelFetch(t_blueNoise, (pixel + u_.whole.zw) & (kBlueNoiseSize - 1), 0).r;
    return fract(pattern + 0.61803399 * float(u_.sampling.x));
}

Path pathOf(ivec2 pixel, Ray ray, float endM) {
    Path path;
    path.ray = ray;
    path.at = ray.originM / u_.gridExtentM.xyz;
    path.atPerM = ray.dir / u_.gridExtentM.xyz;
    path.brick = ray.originM / u_.brickM.xyz;
    path.brickPerM = divisible(ray.dir) / u_.brickM.xyz;
    path.mPerBrick = 1.0 / path.brickPerM;
    path.endM = endM;
    path.place = placeInStep(pixel);
    return path;
}

/// Length of step for a level of extinction.
float stepM(uint level) {
    float perM = exp2((float(kLevelOfOne) - float(level)) / float(kLevelsPerOctave));
    return clamp(u_.march.y * perM, u_.march.z * u_.march.x, u_.march.w * u_.march.x);
}

/// Leaps from empty brick to empty brick; returns the level of the brick where that ends.
uint leap(Path path, inout float atM, inout uint skipped) {
    ivec3 last = textureSize(t_bricks, 0) - 1;
    vec3 ahead = step(0.0, path.brickPerM);
    while (true) {
        vec3 p = path.brick + atM * path.brickPerM;
        vec3 corner = floor(p);
        uvec2 brick = texelFetch(t_bricks, clamp(ivec3(corner), ivec3(0), last), 0).rg;
        if (brick.r == 0u || atM >= path.endM) return brick.g;
        float reach = float(brick.r);
        vec3 wall = corner + mix(vec3(1.0 - reach), vec3(reach), ahead);
        vec3 distanceM = (wall - p) * path.mPerBrick;
        // A thousandth of a brick over the wall, so that rounding cannot hold the ray at it.
        atM += min(min(distanceM.x, distanceM.y), distanceM.z) + 1e-3 * u_.brickM.x;
        ++skipped;
    }
}

#if NOISE
/// Shares of the kinds of detail in a mixture, and shares times amounts.
struct Detail {
    float share[KINDS];
    float amount[KINDS];
};

Detail detailOf(Mixture mixture) {
    Detail detail;
    for (int k = 0; k < KINDS; ++k) {
        detail.share[k] = 0.0;
        detail.amount[k] = 0.0;
    }
    for (int i = 0; i < CLASSES; ++i) {
        detail.share[kKindOfClass[i]] += mixture.share[i];
        detail.amount[kKindOfClass[i]] += mixture.share[i] * u_.classes[i].noise.x;
    }
    return detail;
}

/// What the extinction is multiplied by at a point. The noise is that of the nearest texel to a
/// place that is jittered within one texel: on average this is linear interpolation, at an eighth
/// of its fetches.
float detailAt(vec3 positionM, vec3 jitter, Detail detail) {
    float factor = 0.0;
    for (int k = 0; k < KINDS; ++k) {
        vec4 kind = u_.classes[kClassOfKind[k]].noise;
        vec3 at = positionM * kind.y + jitter;
        at.z = 0.5 * (fract(at.z) + kind.z);
        float noise = textureLod(t_noise, at, 0.0).r / kDetailMean - 1.0;
        factor += max(0.0, detail.share[k] + detail.amount[k] * noise);
    }
    return factor;
}
#endif

#if FLOOR
void run(Path path, float atM, float h, vec3 sunlit[CLASSES], inout Eye eye) {
    for (int i = 0; i < kRun; ++i) {
        vec3 at = path.at + (atM + (float(i) + path.place) * h) * path.atPerM;
        vec4 texel = textureLod(t_floor, at, 0.0);
        eye.radiance += texel.rgb * texel.a;
    }
}
#else
/// One run of steps of length `h` from `atM`; steps beyond the end have no length.
void run(Path path, float atM, float h, vec3 sunlit[CLASSES], inout Eye eye) {
    vec3 middleM = path.ray.originM + (atM + 0.5 * float(kRun) * h) * path.ray.dir;
    Mixture mixture = mixtureAt(middleM);
#if NOISE
    Detail detail = detailOf(mixture);
    vec3 jitter = (fract(path.place * vec3(5.0, 37.0, 91.0)) - 0.5) / float(kNoiseSize);
#endif
#if FULL
    float thickness = thicknessAt(middleM);
    float kept = 0.0;
    vec3 single = vec3(0.0);
    vec3 colour = vec3(0.0);
    for (int i = 0; i < CLASSES; ++i) {
        kept += mixture.share[i] * scaledShare(i, thickness);
        single += mixture.share[i] * sunlit[i];
        colour += mixture.share[i] * u_.classes[i].colourAlbedo.rgb;
    }
    single /= kept;
    colour /= max(dot(colour, kLuminance), 1e-6);
#endif
    float lit = 0.0;
    float before = eye.through;
    for (int i = 0; i < kRun; ++i) {
        float startM = atM + float(i) * h;
        float sampleM = startM + path.place * h;
        vec2 medium = textureLod(t_extinction, path.at + sampleM * path.atPerM, 0.0).rg;
        float depth = kLog2E * medium.r * clamp(path.endM - startM, 0.0, h);
#if NOISE
        depth *= detailAt(path.ray.originM + sampleM * path.ray.dir, jitter, detail);
#endif
#if FULL
        float through = eye.through * exp2(-kept * depth);
        vec4 source = textureLod(t_source, sourceAt(path.ray.originM + sampleM * path.ray.dir),
                                 0.0);
        vec3 diffuse = source.rgb - medium.g * source.a * u_.sunRadiance.rgb;
        eye.radiance += (eye.through - through) * max(medium.g * single + colour * diffuse, 0.0);
#else
        float through = eye.through * exp2(-depth);
        lit += (eye.through - through) * medium.g;
#endif
        eye.through = through;
    }
#if !FULL
    float seen = (before - eye.through) * mixture.skylight;
    for (int i = 0; i < CLASSES; ++i) {
        eye.radiance += mixture.share[i] *
                        (lit * sunlit[i] + seen * u_.ambient.rgb * u_.classes[i].colourAlbedo.rgb);
    }
#endif
}
#endif

Eye march(Path path, float atM, uint most) {
    vec3 sunlit[CLASSES];
    for (int i = 0; i < CLASSES; ++i) sunlit[i] = sunlitBy(i, path.ray.dir);
    Eye eye = Eye(vec3(0.0), 1.0, 0u, 0u);
    while (atM < path.endM && eye.through > kOpaque && eye.taken < most) {
        uint level = leap(path, atM, eye.skipped);
        if (atM >= path.endM) break;
        float h = stepM(level);
        run(path, atM, h, sunlit, eye);
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

/// The eight invocations that a processor's vector takes together make a block of 4 x 2 pixels.
ivec2 pixelOf(uint index) {
    uvec2 block = uvec2(index >> 3u & 1u, index >> 4u);
    return ivec2(4u * block.x + (index & 3u), 2u * block.y + (index >> 2u & 1u));
}

void main() {
    ivec2 pixel = kMarchEyeGroup * ivec2(gl_WorkGroupID.xy) + pixelOf(gl_LocalInvocationIndex);
    pixel.y += firstRow;
    if (any(greaterThanEqual(pixel, u_.image.xy))) return;
    Ray ray = rayThrough(pixel);
    vec2 insideM = insideBoxM(ray);
    uint most = 0xffffffffu;
#if FLOOR
    most = imageLoad(i_taken, pixel).r;
#endif
    Eye eye = march(pathOf(pixel, ray, insideM.y), insideM.x, most);
    closeRay(eye);
    vec4 seen = vec4(eye.radiance + eye.through * backdrop(ray, u_.slices.z), 1.0 - eye.through);
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
