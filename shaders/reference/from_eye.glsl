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
}

bool showsBackdrop() {
    return u_.sampling.y == 1;
}

/// Whether the path meets what repeats between periodic sides: the eye sees the grid once.
bool meetsRepeats(Path p) {
    return p.scatterings > 0 || p.toSun;
}

/// The ground fades into the horizon where it is seen directly, as with the other engines.
void passHaze(inout Path p) {
    float clear = exp(-distance(u_.eyeM.xyz, p.positionM) / kHazeLengthM);
    p.radiance += (1.0 - clear) * worthOf(p) * u_.skyHorizon.rgb;
    p.throughput *= clear;
}

void noteFirst(inout Path p) {
    p.firstM = distance(u_.eyeM.xyz, p.positionM);
}
