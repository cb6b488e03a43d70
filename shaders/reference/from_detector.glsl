// from_detector.glsl: paths that begin at points of an instrument.
// app/render/engines/reference/trace_meter.h
#pragma once

struct DetectorBlock {
    vec4 lowerM;  // w: kind, as DetectorKind
    vec4 upperM;
    vec4 direction;  // unit; w: the largest absorption that its points can have, 1/m
};
layout(std430, binding = 6) readonly buffer Detectors {
    DetectorBlock detectors_[];
};

const int kRadiance = 0, kFlux = 1, kDiffuseFlux = 2, kAbsorption = 3;

uint keyOf(uint index) {
    return index;
}

void start(inout Path p, uint index) {
    DetectorBlock detector = detectors_[index % uint(u_.picture.x)];
    p.positionM = mix(detector.lowerM.xyz, detector.upperM.xyz, draw(p).xyz);
    int kind = int(detector.lowerM.w);
    p.dir = detector.direction.xyz;
    p.axis = kind == kAbsorption ? vec3(0.0, 0.0, 1.0) : p.dir;
    p.direct = kind != kDiffuseFlux;
    if (kind == kAbsorption) {
        p.weight /= detector.direction.w;
        p.kind = kInside;
        p.stage = kMet;
    } else if (kind != kRadiance) {
        p.kind = kSurface;
        p.stage = kMet;
    }
}

bool showsBackdrop() {
    return true;
}

void passHaze(inout Path p) {}

void noteFirst(inout Path p) {}
