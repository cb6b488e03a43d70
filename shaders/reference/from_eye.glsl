// from_eye.glsl: paths that begin at the eye, one through the middle of each pixel.
#pragma once

ivec2 pixelOf(uint index) {
    return ivec2(int(index) % u_.image.x, int(index) / u_.image.x);
}

/// The same in every part of an image: its number in the whole.
uint keyOf(uint index) {
    ivec2 pixel = pixelOf(index) + u_.whole.zw;
    return uint(pixel.y) * uint(u_.whole.x) + uint(pixel.x);
}

void start(inout Path p, uint index) {
    Ray ray = rayThrough(pixelOf(index));
    p.positionM = ray.originM;
    p.dir = ray.dir;
    p.axis = ray.dir;
}

/// Until it meets a particle a path is the eye's ray; `axis` is how it left the eye.
bool isOfEye(Path p) {
    return p.scatterings == 0 && !p.toSun;
}

/// The ray follows the round Earth.
bool bends(Path p) {
    return isOfEye(p) && u_.sky.z > 0.0;
}

/// Distance at which the eye's ray ends where it may never leave what repeats; a ray through air
/// does.
float endOfSight(Path p) {
#if PERIODIC
    if (isOfEye(p) && !hasAir()) return kSeenM;
#endif
    return 1e30;
}

/// Turns a path after so much of its way.
void bend(inout Path p, float lengthM) {
    p.dir = normalize(p.dir + vec3(0.0, 0.0, 2.0 * bendOf(p.axis) * lengthM));
}

Ray rayOf(Path p) {
    return Ray(u_.eyeM.xyz, p.axis);
}

/// A pixel at the horizon has some of both, as in backdrop.glsl.
void takeSideOfHorizon(inout Path p) {
    if (!hasAir() || u_.ground.w < 0.5) return;
    float above = pixelsAboveHorizon(p.axis);
    if (abs(above) >= 0.5) return;
    p.axis = besideHorizon(p.axis, draw(p).x < above + 0.5 ? 1.0 : -1.0);
}

bool reachesSeenGround(inout Path p) {
    takeSideOfHorizon(p);
    float groundM = groundDistanceM(rayOf(p));
    if (groundM > 0.0) p.positionM = groundPoint(rayOf(p), groundM);
    return groundM > 0.0;
}

/// What the ground's albedo is multiplied by where the path meets it.
vec3 seenGround(Path p) {
    return groundSeen(rayOf(p), groundDistanceM(rayOf(p)));
}

vec3 seenMirrored(Path p) {
    return groundMirrors(rayOf(p), p.positionM);
}

bool showsBackdrop() {
    return u_.sampling.y == 1;
}

/// Light of the air before a distance along a path's ray, and what the air leaves of other light.
vec3 lightOfAir(AirRay air, float distanceM) {
    return throughAir(air, distanceM, vec3(0.0), 1.0);
}
vec3 clearOfAir(AirRay air, float distanceM) {
    return throughAir(air, distanceM, vec3(1.0), 0.0);
}

const float kFarM = 1e30;
float endOfRayM_ = kFarM;  // of the eye's ray that has ended in this round

#if AIR
/// The eye's ray is seen through air as the tables have it; what light the box sends into it is
/// traced, at one place of each ray.
bool meetsAir(Path p) {
    return p.scatterings > 0;
}

/// Part of the ray that the box's air sends light into, before a distance. An eye below the ground
/// sees no air of the box, but that of one which stands on the ground.
vec2 tracedPartM(Ray ray, float untilM) {
    vec2 inside = partSeenM(ray, vec3(0.0), u_.gridExtentM.xyz);
#if PERIODIC
    // The tables, of which it takes the place, know no more.
    untilM = min(untilM, thinAirM(altitudeM(ray.originM), ray.dir.z) + kAirRangeM);
#endif
    return vec2(inside.x, altitudeM(ray.originM) < 0.0 ? 0.0 : min(inside.y, untilM));
}

/// Light of the air in that part by the tables: traced paths bring it.
vec3 tracedLight(Path p, float untilM) {
    vec2 partM = tracedPartM(rayOf(p), untilM);
    if (partM.x >= partM.y) return vec3(0.0);
    AirRay air = airRay(p.axis);
    return lightOfAir(air, partM.y) - lightOfAir(air, partM.x);
}

/// A way along which a constituent thins out as e^(-fallPerM x), about, and light that it sends.
struct Thinning {
    float fallPerM;
    float sent;
};

/// (1 - e^-kL) / k
float lengthOf(float fallPerM, float lengthM) {
    float x = fallPerM * lengthM;
    return abs(x) < 1e-3 ? lengthM * (1.0 - 0.5 * x) : (1.0 - exp(-x)) / fallPerM;
}

Thinning thinningOf(float perM, float heightM, float fromM, float up, float clearPerM,
                    float lengthM, float phase) {
    float fallPerM = up / heightM + clearPerM;
    float light = perM * densityAt(fromM, heightM) * (0.5 + 2.0 * kPi * phase);
    return Thinning(fallPerM, light * lengthOf(fallPerM, lengthM));
}

/// Density with which a length is drawn, and the length.
float densityOf(Thinning t, float atM, float lengthM) {
    return exp(-t.fallPerM * atM) / lengthOf(t.fallPerM, lengthM);
}
float drawLengthM(Thinning t, float lengthM, float u) {
    float x = t.fallPerM * lengthM;
    return abs(x) < 1e-3 ? u * lengthM : -log(1.0 - u * (1.0 - exp(-x))) / t.fallPerM;
}

/// The eye's ray, which left it in a direction, has ended. Goes on from a place of the air before
/// its end; what is at its end waits. Places are drawn as if height and what is left of light
/// changed evenly, of molecules or of haze by what they send; what they are off by goes into the
/// weight.
void meetAirBefore(inout Path p, vec3 dir, uint lane) {
    if (p.stage == kDone && !showsBackdrop()) return;
    Ray ray = Ray(u_.eyeM.xyz, dir);
    vec2 partM = tracedPartM(ray, p.stage == kDone ? kFarM : endOfRayM_);
    float lengthM = partM.y - partM.x;
    if (lengthM <= 0.0) return;
    AirRay air = airRay(dir);
    vec3 first = clearOfAir(air, partM.x), last = clearOfAir(air, partM.y);
    float clearPerM = log(max(first.g, 1e-20) / max(last.g, 1e-20)) / lengthM;
    float fromM = altitudeM(pointAlong(ray, partM.x));
    float up = (altitudeM(pointAlong(ray, partM.y)) - fromM) / lengthM;
    float versine = versineBetween(dir, u_.towardsSun.xyz);
    Thinning molecules = thinningOf(moleculesPerM.g, moleculesHeightM, fromM, up, clearPerM,
                                    lengthM, phaseOf(kMoleculesRow, versine).g);
    Thinning haze = thinningOf(hazePerM.g, hazeHeightM, fromM, up, clearPerM, lengthM,
                               phaseOf(kHazeRow, versine).g);
    float ofHaze = haze.sent / max(haze.sent + molecules.sent, 1e-30);
    vec4 u = draw(p);
    float atM =
        u.x < ofHaze ? drawLengthM(haze, lengthM, u.y) : drawLengthM(molecules, lengthM, u.y);
    atM = clamp(atM, 0.0, lengthM);
    float density = mix(densityOf(molecules, atM, lengthM), densityOf(haze, atM, lengthM), ofHaze);
    if (p.stage != kDone) suspend(p, lane);
    p.positionM = repeated(pointAlong(ray, partM.x + atM));
    p.throughput = clearOfAir(air, partM.x + atM) * boxAirAt(altitudeM(p.positionM)).extinction /
                   max(density, 1e-30);
    p.axis = dir;
    p.scatterings = 0;
    p.kind = kAir;
    p.veil = true;
    p.stage = kMet;
}
#else
vec3 tracedLight(Path p, float untilM) {
    return vec3(0.0);
}
#endif

/// The sky behind the grid, and the air before it.
vec3 seenSky(Path p) {
    return eyeSky(p.axis) - tracedLight(p, kFarM);
}

/// What is seen directly is seen through the air, as with the other engines.
void passAir(inout Path p, float distanceM) {
    AirRay air = airRay(p.axis);
    p.radiance += worthOf(p) * (lightOfAir(air, distanceM) - tracedLight(p, distanceM));
    p.throughput *= clearOfAir(air, distanceM);
}

/// So much of what is seen is clear, where there is no air; the rest has faded into the horizon.
void fade(inout Path p, float clear) {
    p.radiance += (1.0 - clear) * worthOf(p) * u_.skyHorizon.rgb;
    p.throughput *= clear;
}

/// The ground, in the place where it is seen.
void passHaze(inout Path p) {
    endOfRayM_ = distance(u_.eyeM.xyz, p.positionM);
    if (hasAir()) {
        passAir(p, endOfRayM_);
    } else {
        fade(p, exp(-endOfRayM_ / kHazeLengthM));
    }
}

void noteFirst(inout Path p) {
#if PERIODIC
    p.firstM = p.flownM;
    if (!hasAir()) fade(p, hazyCloud(vec3(1.0), vec3(0.0), p.firstM * length(p.axis.xy)).r);
#else
    p.firstM = distance(u_.eyeM.xyz, p.positionM);
#endif
    endOfRayM_ = p.firstM;
    if (hasAir()) passAir(p, p.firstM);
}
