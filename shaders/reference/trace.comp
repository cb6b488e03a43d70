// trace.comp: paths of light, traced from the eye or from a detector until they leave the medium
// for good.
//
// Null-collision tracking [Woodcock65] finds the next particle, closed forms the next of the air
// where that is AIR; from each, ratio tracking [Novak14]
// finds how much of the sun's light arrives, and a direction drawn from the phase function goes on.
// Both may find the sun: their shares are weighed against one another by the balance heuristic
// [VG95]. An invocation is a lane that carries one path after the other, a number of rounds at a
// time; docs/architecture.md has the whole.
#version 450 core
layout(local_size_x = 64) in;
#include "../lib/random.glsl"
#include "../medium/ray_in_box.glsl"
#include "../shared/reference_blocks.glsl"
#include "../sky/air.glsl"
#include "scattering.glsl"
#include "state.glsl"
#if AIR
#include "box_air.glsl"
#endif

layout(location = kTraceRoundsLocation) uniform int rounds;     // of each lane in this dispatch
layout(location = kTracePathsLocation) uniform int pathsAPass;  // one a pixel, or detector
// Of the oldest pass that is not whole.
layout(location = kTraceFirstTicketLocation) uniform int firstTicket;
layout(location = kTraceFirstPassLocation) uniform int firstPass;  // its number
layout(location = kTraceSeedLocation) uniform int seed;
layout(location = kTraceMaxScatteringsLocation) uniform int maxScatterings;  // 0: no limit
layout(location = kTraceDiscLocation) uniform float discVersine;  // of the sun's angular radius
layout(location = kTraceRouletteLocation) uniform float rouletteFrom;  // scatterings

layout(std430, binding = kCountersBuffer) buffer Counters {
    CounterBlock counters_;
};
layout(std430, binding = kResultsBuffer) writeonly buffer Results {
    vec4 results_[];  // rgb: radiance, w: distance to the first particle or -1; pass after pass
};

// Light is worth what it brings relative to isotropic scattering in full sunlight. Chances of
// asking for sunlight, by what would arrive: times what is expected, at least, and how an optical
// depth counts; and the worth below which it is a matter of chance whether to ask on. Chances of a
// branch: at least. Chances to go on, times the weight; in cloud, of a path that went on from air
// that the eye looks through. All by measurement: docs/measurements.md
const float kAsking = 4.0, kLeastAsking = 0.05, kAskingPerDepth = 0.3, kFaint = 0.1;
const float kLeastBranching = 0.05;
const float kGoingOn = 4.0, kVeilGoingOn = 2.0;

layout(binding = kSunDepthUnit) uniform sampler3D t_sunDepth;  // to the sun, about

uint collisions_ = 0u, scatterings_ = 0u;

vec4 draw(inout Path p) {
    return unitsOf(randomWords(uvec4(p.key, p.draws++, seed)));
}

float sunSolidAngle() {
    return 2.0 * kPi * discVersine;
}

/// Radiance that full sunlight at a point gives to isotropic scatter.
vec3 sunRadianceAt(vec3 positionM) {
    return u_.sunRadiance.rgb * sunAt(max(altitudeM(positionM), 0.0));
}

vec3 sunIrradianceAt(vec3 positionM) {
    return 4.0 * kPi * sunRadianceAt(positionM);
}

/// What light along the path counts for, at each wavelength.
vec3 worthOf(Path p) {
    return 3.0 * p.wavelengths * p.throughput;
}

/// Share of what sampling the sun finds, where directions are drawn with a density as well.
float shareOfSun(float density) {
    return 1.0 / (1.0 + density * sunSolidAngle());
}

/// Whether the way ahead ends on the ground.
bool endsOnGround(Path p) {
    float heightM = u_.eyeM.w + p.positionM.z;
    float highest = hasAir() ? horizonSine(heightM) : 0.0;
    return u_.ground.w > 0.5 && p.dir.z < highest && heightM >= -1.0;
}

/// The same; then moves there.
bool reachesGround(inout Path p) {
    if (!endsOnGround(p)) return false;
    float heightM = u_.eyeM.w + p.positionM.z;
    if (p.dir.z < 0.0) p.positionM += max(heightM, 0.0) / -p.dir.z * p.dir;
    return true;
}

#if DETECTORS
#include "from_detector.glsl"
#else
#include "from_eye.glsl"
#endif

/// Stores what the path has brought.
void finish(inout Path p) {
    if (any(isnan(p.radiance)) || any(isinf(p.radiance))) {
        atomicAdd(counters_.faults, 1u);
        p.radiance = vec3(0.0);
    }
    uint path = p.ticket - uint(firstTicket);
    uint slot = (uint(firstPass) + path / uint(pathsAPass)) % uint(kPassesAtOnce);
    results_[slot * uint(pathsAPass) + path % uint(pathsAPass)] = vec4(p.radiance, p.firstM);
    atomicAdd(counters_.finished[slot], 1u);
    p.stage = kIdle;
}

/// Takes the next path, where it is one of those that may be begun.
void begin(inout Path p) {
    if (p.stage == kIdle) p.ticket = atomicAdd(counters_.tickets, 1u);
    p.stage = kWaiting;
    uint path = p.ticket - uint(firstTicket);
    if (path >= uint(kPassesAtOnce) * uint(pathsAPass)) return;
    p.key = uvec2(keyOf(path % uint(pathsAPass)), uint(firstPass) + path / uint(pathsAPass));
    p.draws = 0u;
    p.scatterings = 0;
    p.toSun = false;
    p.direct = true;
    p.veil = false;
    p.waiting = 0;
    p.density = 0.0;
    p.firstM = -1.0;
    p.throughput = vec3(1.0);
    p.wavelengths = vec3(1.0 / 3.0);
    p.radiance = vec3(0.0);
    p.hero = int(3.0 * draw(p).x);
    p.stage = kAiming;
    start(p, path % uint(pathsAPass));
}

/// Chance that a path goes on, by what it can bring, of which sunlight scattered a little is most
/// where it is bound for the sun (`lobe`, see scatter), and by how often it has been scattered. In
/// a thick cloud the number of paths of at least n scatterings falls as n^-1/2, so that most of the
/// work would go into the few longest; a chance of (n / (n + 1))^1/2 each time, and weights that
/// make up for it, spread the work over all lengths. docs/architecture.md
float chanceToGoOn(Path p, float lobe) {
    float goingOn = p.veil && p.kind == kParticle ? kVeilGoingOn : kGoingOn;
    float chance = min(1.0, goingOn * largestOf(p.throughput) * max(1.0, 4.0 * kPi * lobe));
    float n = float(p.scatterings);
    return n < rouletteFrom ? chance : chance * sqrt(n / (n + 1.0));
}

/// What a direction gets of the light at the path's vertex, and how likely it is to be drawn.
Sent sentTo(Path p, MediumSample medium, Mixture mixture, vec3 dir) {
    if (p.kind == kParticle) {
        return sentInto(medium, mixture, versineBetween(p.axis, dir), p.wavelengths);
    }
#if AIR
    if (p.kind == kAir) {
        BoxAir air = boxAirAt(altitudeM(p.positionM));
        return sentByAir(air, versineBetween(p.axis, dir), p.wavelengths);
    }
#endif
    float share = p.kind == kSurface ? max(dot(p.axis, dir), 0.0) / kPi : kInverseFourPi;
    return Sent(vec3(share), share);
}

float sunDepthAt(vec3 positionM) {
    return textureLod(t_sunDepth, positionM / u_.gridExtentM.xyz, 0.0).r;
}

/// Share of the sun's light that arrives from near the sun, about: droplets scatter half of it by a
/// degree or two, which is as good as not at all.
float sunReach(vec3 positionM) {
    return min(1.0, 4.0 * exp(-0.3 * sunDepthAt(positionM)));
}

/// What all the sunlight at the vertex would bring.
float worthOfSunlight(Path p) {
    return largestOf(p.sunlit) / max(largestOf(sunRadianceAt(p.vertexM)), 1e-30);
}

/// Light scattered for the first time, or from ground that is seen, has little noise but this.
bool savesOnSunlight(Path p) {
    return p.scatterings > 1;
}

/// The path is at a vertex: a particle, a surface or a detector inside the medium. Asks for the
/// light of a point of the sun's disc.
void sampleSun(inout Path p) {
    vec3 towards = u_.towardsSun.xyz;
    MediumSample medium = sampleMedium(p.positionM);
    Mixture mixture = mixtureOf(medium);
    vec4 u = draw(p);
    if (p.kind == kInside) p.throughput *= absorptionOf(medium);
    vec3 sun = directionAround(towards, discVersine * u.x, u.y);
    // Weighed by the density towards the disc's middle, for both ways of finding it.
    p.density = p.direct ? sentTo(p, medium, mixture, towards).density : 0.0;
    p.sunlit = worthOf(p) * sentTo(p, medium, mixture, sun).share * sunIrradianceAt(p.positionM) *
               shareOfSun(p.density);
    p.vertexM = p.positionM;
    float expected = worthOfSunlight(p) * exp(-kAskingPerDepth * sunDepthAt(p.positionM));
    float asking = savesOnSunlight(p) ? clamp(kAsking * expected, kLeastAsking, 1.0) : 1.0;
    p.toSun = p.direct && u.z < asking && largestOf(p.sunlit) > 0.0;
    p.sunlight = 1.0 / asking;
    p.dir = sun;
    p.stage = p.toSun ? kAiming : kScattering;
}

/// Samples the direction in which the path goes on from the vertex.
///
/// Around the sun the sky of a thin cloud is as bright as its particles' forward peak is high.
/// Paths seldom go there by themselves, and bring very much when they do. So where the sun is
/// near, some scatters send off a branch into the lobe of the peak around the sun, and both are
/// weighed by the balance heuristic; the path itself waits until the branch has ended. The more a
/// branch can bring the more are sent: else a path that comes near the lobe by chance brings a
/// hundred times the mean.
void scatter(inout Path p, uint lane) {
    vec3 towards = u_.towardsSun.xyz;
    MediumSample medium = sampleMedium(p.positionM);
    Mixture mixture = mixtureOf(medium);
    vec4 u = draw(p);
    vec4 v = draw(p);
    int chosen = classBy(u.x, mixture);
#if AIR
    BoxAir air = boxAirAt(altitudeM(p.positionM));
    vec3 hazes = chancesOfHaze(air);
    if (p.kind == kAir) chosen = u.x < hazes[p.hero] ? kHazeRow : kMoleculesRow;
#endif
    vec2 drawn = vec2(p.kind == kSurface ? versineByCosine(u.y) : 2.0 * u.y, 0.0);
    if (p.kind == kParticle || p.kind == kAir) drawn = drawVersine(chosen, p.hero, u.y);
    vec2 drawnNear = drawVersine(LOBE_CLASS, p.hero, v.x);
    vec3 next = directionAround(p.axis, drawn.x, u.z);
    vec3 near = directionAround(towards, drawnNear.x, v.y);
    float reach = sunReach(p.positionM);
    bool shines = largestOf(sunRadianceAt(p.vertexM)) > 0.0;
    bool branches = shines && p.direct && p.waiting < kMostWaiting;
    float branching = branches ? clamp(worthOfSunlight(p) * reach, kLeastBranching, 1.0) : 0.0;
    Sent toNext = sentTo(p, medium, mixture, next);
    Sent toNear = sentTo(p, medium, mixture, near);
    float lobeOfNext = dot(p.wavelengths, phaseOf(LOBE_CLASS, versineBetween(next, towards)));
    vec3 lobes = phaseOf(LOBE_CLASS, drawnNear.x);
    float lobeOfNear = branching * dot(p.wavelengths, lobes);
    vec3 wavelengths = p.wavelengths;
    vec3 throughput = p.throughput;

    if (p.kind == kParticle || p.kind == kAir) {
        vec3 phase = phaseOf(chosen, drawn.x);
        p.throughput *= phase[p.hero] / drawn.y;
        p.wavelengths *= phase;
        if (p.kind == kParticle) {
            vec3 colour = u_.classes[chosen].colourAlbedo.rgb;
            p.throughput *= colour / max(largestOf(colour), 1e-30) *
                            (mixture.scatteringPerM / mixture.extinctionPerM);
        }
#if AIR
        if (p.kind == kAir) {
            p.throughput *= (air.molecules + air.haze) / max(air.extinction, vec3(1e-30));
            p.wavelengths *= chosen == kHazeRow ? hazes : 1.0 - hazes;
        }
#endif
        p.wavelengths /= p.wavelengths.r + p.wavelengths.g + p.wavelengths.b;
        ++p.scatterings;
        ++scatterings_;
    }
    p.throughput *= toNext.density / max(toNext.density + branching * lobeOfNext, 1e-30);
    float chance = chanceToGoOn(p, reach * lobeOfNext);
    p.throughput /= max(chance, 1e-30);
    bool ends = u.w >= chance || largestOf(p.throughput) <= 0.0;
    float density = p.direct ? p.density : 0.0;
    p.density = versineBetween(next, towards) < discVersine ? density : 0.0;
    p.direct = true;
    p.dir = next;
    p.stage = ends ? kDone : kAiming;
    if (v.z >= branching) return;
    if (!ends) suspend(p, lane);
    p.throughput = throughput * toNear.share / (branching * lobes) *
                   (lobeOfNear / (lobeOfNear + toNear.density) * lobes[p.hero] / drawnNear.y);
    p.wavelengths = wavelengths * lobes;
    p.wavelengths /= p.wavelengths.r + p.wavelengths.g + p.wavelengths.b;
    p.density = drawnNear.x < discVersine ? density : 0.0;
    p.dir = near;
    p.stage = largestOf(p.throughput) > 0.0 ? kAiming : kDone;
}

#include "flight.glsl"

/// The ground, the sky or the sun is at the end of the way.
void arrive(inout Path p) {
    bool seen = p.scatterings == 0;
    p.stage = kDone;
    if (seen && !showsBackdrop()) return;
    // Air between the vertex and here has been met.
    vec3 fromM = AIR == 1 ? p.positionM : p.vertexM;
    if (p.density > 0.0) {
        p.radiance +=
            worthOf(p) * sunIrradianceAt(fromM) / sunSolidAngle() * (1.0 - shareOfSun(p.density));
    }
#if AIR
    if (meetsAir(p) && p.dir.z < 0.0 && endsOnGround(p)) {
        if (meetsAirBelow(p, altitudeM(p.positionM), draw(p).xy)) return;
    }
#endif
    bool ground = seen ? reachesSeenGround(p) : reachesGround(p);
    if (!ground) {
        p.radiance += worthOf(p) * (seen ? seenSky(p) : skyFrom(fromM, p.dir));
        return;
    }
    p.positionM.z = -u_.eyeM.w;
    if (seen) {
        passHaze(p);
        p.radiance += worthOf(p) * seenMirrored(p);
    }
    p.positionM = repeated(p.positionM);
    ++p.scatterings;
    p.throughput *= u_.ground.rgb * (seen ? seenGround(p) : vec3(1.0));
    p.axis = vec3(0.0, 0.0, 1.0);
    p.kind = kSurface;
    p.stage = kMet;
}

/// Sunlight has been asked for. It is not hidden by the horizon: the earth is round, and a sun just
/// below it lights what is high.
void receive(inout Path p) {
    p.radiance += p.sunlight * p.sunlit;
    p.toSun = false;
    p.positionM = p.vertexM;
    p.stage = kScattering;
}

/// What a processor's vector of lanes does together is done in the same place: it goes through all
/// branches, so that each must be there once. Of the work at a vertex, the lanes of a vector share
/// more the longer all have flown.
void main() {
    uint lane = gl_GlobalInvocationID.x;
    if (lane >= uint(laneCount)) return;
    Path p = loadPath(lane);
    const int kSteps = 6;
    for (int i = 0; i < rounds; ++i) {
        if (p.stage == kDone && p.waiting > 0) takeUp(p, lane);
        if (p.stage == kDone && p.waiting == 0) finish(p);
        if (p.stage <= kWaiting) begin(p);
        if (p.stage == kWaiting) break;
        if (p.stage == kMet) sampleSun(p);
        if (p.stage == kScattering) scatter(p, lane);
        if (p.stage == kAiming) aim(p);
        for (int k = 0; k < kSteps && p.stage == kFlying; ++k) {
            float boundPerM = cross(p);
            if (boundPerM > 0.0) meet(p, boundPerM);
        }
        bool ended = p.stage == kMet || (p.stage == kLeft && !p.toSun);
        bool seen = ended && p.scatterings == 0;
        vec3 way = p.axis;
#if AIR
        if (ended && meetsAir(p)) weighByAir(p, altitudeM(p.positionM));
#endif
        if (p.stage == kMet && seen && p.kind == kParticle) noteFirst(p);
        if (p.stage == kLeft) {
            if (p.toSun) {
                receive(p);
            } else {
                arrive(p);
            }
        }
        if (p.stage == kMet && p.kind != kSurface && maxScatterings > 0 &&
            p.scatterings >= maxScatterings) {
            p.stage = kDone;
        }
#if AIR
        if (seen) meetAirBefore(p, way, lane);
#endif
    }
    savePath(p, lane);
    atomicAdd(counters_.collisions, collisions_);
    atomicAdd(counters_.scatterings, scatterings_);
}
