// from_detector.glsl: paths that begin at points of an instrument.
// app/render/engines/reference/trace_meter.h
#pragma once
#include "../shared/reference_blocks.glsl"

layout(std430, binding = kDetectorsBuffer) readonly buffer Detectors {
    DetectorBlock detectors_[];
};

uint keyOf(uint index) {
    return index;
}

void start(inout Path p, uint index) {
    DetectorBlock detector = detectors_[index % uint(u_.image.x)];
    p.positionM = mix(detector.lowerM.xyz, detector.upperM.xyz, draw(p).xyz);
    int kind = int(detector.lowerM.w);
    p.dir = detector.direction.xyz;
    p.axis = kind == kAbsorptionDetector ? vec3(0.0, 0.0, 1.0) : p.dir;
    p.direct = kind != kDiffuseFluxDetector;
    if (kind == kAbsorptionDetector) {
        p.throughput /= detector.direction.w;
        p.kind = kInside;
        p.stage = kMet;
    } else if (kind != kRadianceDetector) {
        p.kind = kSurface;
        p.stage = kMet;
    }
}

bool bends(Path p) {
    return false;
}

void bend(inout Path p, float lengthM) {}

bool reachesSeenGround(inout Path p) {
    return reachesGround(p);
}

vec3 seenGround(Path p) {
    return vec3(1.0);
}

vec3 seenMirrored(Path p) {
    return vec3(0.0);
}

vec3 seenSky(Path p) {
    return skyFrom(p.positionM, p.dir);
}

bool showsBackdrop() {
    return true;
}

bool isOfEye(Path p) {
    return false;
}

float endOfSight(Path p) {
    return 1e30;
}

#if AIR
bool meetsAir(Path p) {
    return true;
}

void meetAirBefore(inout Path p, vec3 dir, uint lane) {}
#endif

void passHaze(inout Path p) {}

void noteFirst(inout Path p) {}
