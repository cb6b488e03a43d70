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

/// Until it meets a particle a path follows its ray over the round Earth; `axis` is how it left the
/// eye.
bool bends(Path p) {
    return p.scatterings == 0 && !p.toSun && u_.sky.z > 0.0;
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

vec3 seenSky(Path p) {
    return eyeSky(p.axis);
}

bool showsBackdrop() {
    return u_.sampling.y == 1;
}

/// Whether the path meets what repeats between periodic sides: the eye sees the grid once.
bool meetsRepeats(Path p) {
    return p.scatterings > 0 || p.toSun;
}

/// What is seen directly is seen through the air, as with the other engines.
void passAir(inout Path p) {
    AirRay air = airRay(p.axis);
    float distanceM = distance(u_.eyeM.xyz, p.positionM);
    vec3 worth = worthOf(p);
    p.radiance += worth * throughAir(air, distanceM, vec3(0.0), 1.0);
    p.throughput *= throughAir(air, distanceM, vec3(1.0), 0.0);
}

/// The ground fades into the horizon where there is no air.
void passHaze(inout Path p) {
    if (hasAir()) {
        passAir(p);
        return;
    }
    float clear = exp(-distance(u_.eyeM.xyz, p.positionM) / kHazeLengthM);
    p.radiance += (1.0 - clear) * worthOf(p) * u_.skyHorizon.rgb;
    p.throughput *= clear;
}

void noteFirst(inout Path p) {
    p.firstM = distance(u_.eyeM.xyz, p.positionM);
    if (hasAir()) passAir(p);
}
