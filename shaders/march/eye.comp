// eye.comp: Eq. 5 along each pixel's ray, in runs of four steps.
//
// A run skips what is empty, reads four times what varies fast (extinction and light) and once what
// varies slowly (the mixture), where most of the run's light comes from. Samples lie at whole
// numbers of steps from the eye, shifted from pixel to pixel by a blue-noise pattern.
// ADAPTIVE halves steps where that shows; PROFILE counts; FLOOR repeats the rays and samples of an
// image with one fetch each and nothing else, to measure against. docs/performance.md
#version 450 core
#include "../shared/march_layout.glsl"
layout(local_size_x = kMarchEyeGroup, local_size_y = kMarchEyeGroup) in;
#include "../display/backdrop.glsl"
#include "../medium/phases.glsl"
#include "../medium/ray_in_box.glsl"
#include "../shared/march_blocks.glsl"
#include "cloudy_air.glsl"
#include "detail.glsl"
#include "diffuse.glsl"
#include "packed_sample.glsl"
#include "path.glsl"
#include "sunlight.glsl"

// Of the band of rows that is drawn.
layout(location = kMarchFirstRowLocation) uniform int firstRow;
// Of this image in the mean: 1 for the first.
layout(location = kMarchBlendLocation) uniform float blend;
layout(rgba32f, binding = kMarchLinearImage) uniform image2D io_linear;
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

// Of cloudy_air.comp.
layout(binding = kCloudyAirUnit) uniform sampler3D t_cloudyAir;
/// A sample: where it is on the ray, and what is there.
struct Station {
    float atM;
    float extinctionPerM, light;
};

/// What a run scatters towards the eye.
struct Scattered {
    float atM;      // the mean of where, by how much of it is seen
    float light;    // sunlight times the share of it that is seen
    float through;  // transmittance from the eye to the end of the run
};

struct Eye {
    vec3 radiance;
    float through;
    float forward;  // optical depth of scattering that full transport does not count as such
    float atM;      // sum of the distances of what is seen, each times how much of it is
    uint taken, skipped;
};

Station stationAt(Path path, float index) {
    float atM = stationM(path, index);
#if FLOOR
    vec4 texel = textureLod(t_floor, inTexture(path, atM), 0.0);
    return Station(atM, 0.0, dot(texel.rgb, vec3(texel.a)));
#else
    vec2 medium = textureLod(t_extinction, inTexture(path, atM), 0.0).rg;
    return Station(atM, medium.r, medium.g);
#endif
}

/// Whether a step dims the image by more than is wanted.
bool isCoarse(Station stations[kRun], float stepM, float through) {
    float largestPerM = 0.0;
    for (int i = 0; i < kRun; ++i) largestPerM = max(largestPerM, stations[i].extinctionPerM);
    return through * largestPerM * stepM > u_.march.w;
}

/// The samples of one run after number `index`, in steps of `stride` samples, or of half as many
/// for as long as these turn out to be too coarse.
void take(Path path, float index, inout float stride, inout Eye eye, out Station stations[kRun]) {
    for (int i = 0; i < kRun; ++i) {
        stations[i] = stationAt(path, index + float(i + 1) * stride);
    }
    eye.taken += uint(kRun);
#if ADAPTIVE
    if (stride == 1.0 || !isCoarse(stations, kLongest * path.stepM, eye.through)) return;
    stride = 1.0;
    stations[3] = stations[1];
    stations[1] = stations[0];
    stations[0] = stationAt(path, index + 1.0);
    stations[2] = stationAt(path, index + 3.0);
    eye.taken += uint(kRun / 2);
#endif
}

#if FLOOR
void run(Path path, Station stations[kRun], inout Station last, inout Eye eye) {
    for (int i = 0; i < kRun; ++i) eye.radiance += stations[i].light;
    last = stations[kRun - 1];
}
#else
/// Where in a step, as a share of it, the light that it scatters comes from on average, as the eye
/// sees it, if the extinction varies linearly in it.
///
/// In optical depth τ it is 1/τ - 1/(e^τ - 1): half of what is thin, the beginning of what is
/// thick. The fraction has the same value and slope at 0 and the same limit, and is within 6 %.
/// The root finds where that depth is reached.
float originInStep(float fromPerM, float toPerM, float depth) {
    float share = (1.0 + 0.165 * depth) / (2.0 + depth * (0.6633 + 0.165 * depth));
    float first = fromPerM / max(fromPerM + toPerM, 1e-20);
    return share / max(first + sqrt(first * first + (1.0 - 2.0 * first) * share), 1e-6);
}

/// From one sample through four others.
Scattered scatteredIn(Station from, Station stations[kRun], float through) {
    Scattered met = Scattered(0.0, 0.0, through);
    for (int i = 0; i < kRun; ++i) {
        Station to = stations[i];
        float depth = 0.5 * (from.extinctionPerM + to.extinctionPerM) * (to.atM - from.atM);
        float origin = originInStep(from.extinctionPerM, to.extinctionPerM, depth);
        float beyond = met.through * exp2(-kLog2E * depth);
        float seen = met.through - beyond;
        met.light += seen * mix(from.light, to.light, origin);
        met.atM += seen * mix(from.atM, to.atM, origin);
        met.through = beyond;
        from = to;
    }
    const float kHardly = 1e-5;  // seen; where it is no more, the middle
    met.atM = (met.atM + kHardly * stations[1].atM) / (through - met.through + kHardly);
    return met;
}

#if FULL
/// What a run adds to the image, step by step: sunlight scattered once, and diffuse light, of which
/// voxels of light know the sum.
void addScattered(Path path, Station from, Station stations[kRun], Optics optics, vec3 sun,
                  inout Eye eye) {
#if PERIODIC
    vec4 source = vec4(0.0);  // of two steps
#endif
    for (int i = 0; i < kRun; ++i) {
        Station to = stations[i];
        float depth =
            0.5 * optics.kept * (from.extinctionPerM + to.extinctionPerM) * (to.atM - from.atM);
        float origin = originInStep(from.extinctionPerM, to.extinctionPerM, depth);
        float light = mix(from.light, to.light, origin);
#if PERIODIC
        if (i % 2 == 0) {
            Station last = stations[i + 1];
            float ends = from.extinctionPerM + last.extinctionPerM;
            float both = 0.5 * optics.kept * ends * (last.atM - from.atM);
            float place = originInStep(from.extinctionPerM, last.extinctionPerM, both);
            bool any = ends + to.extinctionPerM > 0.0;
            if (any) source = sentAlongRay(positionOn(path, mix(from.atM, last.atM, place)), sun);
        }
#else
        vec3 positionM = positionOn(path, mix(from.atM, to.atM, origin));
        vec4 source = textureLod(t_source, sourceAt(positionM), 0.0);
#endif
        vec3 diffuse = source.rgb - light * source.a * sun * u_.sunRadiance.rgb;
        float through = eye.through * exp2(-kLog2E * depth);
        vec3 single = optics.once;
        if (path.sunwards) {
            float fromSun = -log(max(light, 1e-6));
            single =
                scatteredOnce(optics, eye.forward + (origin * depth + fromSun) * optics.forward);
        }
        eye.radiance +=
            (eye.through - through) * max(light * sun * single + optics.colour * diffuse, 0.0);
        eye.through = through;
        eye.forward += depth * optics.forward;
        from = to;
    }
}
#endif

/// What a run adds to the image.
void run(Path path, Station stations[kRun], inout Station last, inout Eye eye) {
    Scattered met = scatteredIn(last, stations, eye.through);
    vec3 metM = positionOn(path, met.atM);
    Mixture mixture = mixtureAt(metM);
#if NOISE
    Detail detail = detailOf(mixture);
    vec3 jitter = (fract(path.place * vec3(5.0, 37.0, 91.0)) - 0.5) / float(kNoiseSize);
    for (int i = 0; i < kRun; ++i) {
        vec3 positionM = positionOn(path, stations[i].atM);
        stations[i].extinctionPerM *= detailAt(positionM, jitter, detail);
    }
    met = scatteredIn(last, stations, eye.through);
#endif
    vec3 sun = sunAt(altitudeM(metM));
    vec3 nearer = eye.radiance;
    float throughNearer = eye.through;
#if FULL
    addScattered(path, last, stations, opticsOf(mixture, thicknessAt(metM), path.sunwards), sun,
                 eye);
#else
    float seen = (eye.through - met.through) * mixture.skylight;
    for (int i = 0; i < CLASSES; ++i) {
        eye.radiance += mixture.share[i] * (met.light * sun * sunlit_[i] +
                                            seen * u_.ambient.rgb * u_.classes[i].colourAlbedo.rgb);
    }
    eye.through = met.through;
#endif
    if (hasAir()) {
        eye.radiance = nearer + throughAir(path.air, met.atM, eye.radiance - nearer,
                                           throughNearer - eye.through);
        eye.atM += (throughNearer - eye.through) * met.atM;
    }
#if PERIODIC
    else {
        vec3 horizon = (throughNearer - eye.through) * u_.skyHorizon.rgb;
        float acrossM = met.atM * length(path.ray.dir.xy);
        eye.radiance = nearer + hazyCloud(eye.radiance - nearer, horizon, acrossM);
    }
#endif
    last = stations[kRun - 1];
}
#endif

Eye march(Path path, uint most) {
    lookUpSunlight(path.ray.dir, path.sunwards);
#if FULL && PERIODIC
    lookUpDiffuse(path.ray.dir);
#endif
    Eye eye = Eye(vec3(0.0), 1.0, 0.0, 0.0, 0u, 0u);
    float stride = kLongest;
    float index = stationBefore(path, path.startM);
    Station last = stationAt(path, index);
    while (last.atM < path.endM && eye.through > path.opaque && eye.taken < most) {
        float atM = leap(path, last.atM, eye.skipped);
        if (atM >= path.endM) break;
        float before = stationBefore(path, atM);
        if (before > index) {  // on from the last sample in what is empty
            index = before;
            last = stationAt(path, index);
            ++eye.taken;
        }
        Station stations[kRun];
        take(path, index, stride, eye, stations);
        index += float(kRun) * stride;
        run(path, stations, last, eye);
#if ADAPTIVE
        if (!isCoarse(stations, kLongest * path.stepM, eye.through)) stride = kLongest;
#endif
    }
    return eye;
}

/// What clouds change of the light that air sends up to a distance.
vec3 cloudyAir(ivec2 pixel, float distanceM) {
    return textureLod(t_cloudyAir, inCloudyAir(pixel, distanceM, textureSize(t_cloudyAir, 0)), 0.0)
        .rgb;
}

/// Of the air before what is seen of the medium.
void addCloudyAir(ivec2 pixel, inout Eye eye) {
    if (u_.cloudyAir.w < 0.5) return;
    float covered = 1.0 - eye.through;
    vec3 change = cloudyAir(pixel, eye.atM / max(covered, 1e-6));
    eye.radiance = max(eye.radiance + covered * change, 0.0);
}

/// Sky or ground as it is seen through air among clouds; the pixel has one of both.
vec3 cloudyBackdrop(ivec2 pixel, Ray ray, float discShown) {
    vec3 behind = backdrop(ray, u_.slices.z, discShown);
    if (u_.cloudyAir.w < 0.5 || u_.sampling.y == 0) return behind;
    float groundM = groundDistanceM(ray);
    return max(behind + cloudyAir(pixel, groundM > 0.0 ? groundM : kAirRangeM), 0.0);
}

/// What lies behind a ray that ended early is taken to be like what lies before.
void closeRay(Path path, inout Eye eye) {
    if (eye.through > path.opaque) return;
    eye.radiance /= 1.0 - eye.through;
    eye.atM /= 1.0 - eye.through;
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
    float sky = skyShareOf(ray.dir);
    vec3 pixelDir = ray.dir;
    bool hasBoth = sky > 0.0 && sky < 1.0;
    if (hasBoth) ray.dir = besideHorizon(pixelDir, 1.0);
    vec2 insideM = insideBoxM(ray);
    uint most = 0xffffffffu;
#if FLOOR
    most = imageLoad(i_taken, pixel).r;
#endif
    Path path = pathOf(pixel, ray, insideM);
    Eye eye = march(path, most);
    closeRay(path, eye);
    addCloudyAir(pixel, eye);
    vec3 behind = cloudyBackdrop(pixel, ray, exp(-eye.forward));
    vec4 seen = vec4(eye.radiance + eye.through * behind, 1.0 - eye.through);
    if (hasBoth) {
        ray.dir = besideHorizon(pixelDir, -1.0);
        vec3 ground = cloudyBackdrop(pixel, ray, 0.0);
        bool before = eye.atM < (1.0 - eye.through) * groundDistanceM(ray);
        vec4 lower = before ? vec4(eye.radiance + eye.through * ground, 1.0 - eye.through)
                            : vec4(ground, 0.0);
        seen = mix(lower, seen, sky);
    }
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
