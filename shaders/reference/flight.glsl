// flight.glsl: how a path goes through the grid until it meets something or leaves. Included by
// trace.comp.
#pragma once

/// Finds where in the grid the way begins that lies ahead.
void aim(inout Path p) {
    vec4 u = draw(p);
    p.depth = -log(1.0 - u.x);
    p.flownM = 0.0;
    bool bent = bends(p);
    vec3 lowerM = vec3(0.0), upperM = u_.gridExtentM.xyz;
#if PERIODIC
    const float kLeastSlope = 1e-4, kFarM = 1e20;
    lowerM.xy = vec2(-kFarM);
    upperM.xy = vec2(kFarM);
    // A level path would never leave: a ten-thousandth of all are turned by less than that.
    if (!isOfEye(p)) {
        p.dir.z = p.dir.z < 0.0 ? min(p.dir.z, -kLeastSlope) : max(p.dir.z, kLeastSlope);
    }
#endif
    vec2 inside = bent ? partInBoxM(Ray(p.positionM, p.dir), lowerM, upperM)
                       : rayBox(p.positionM, p.dir, lowerM, upperM);
    if (inside.x >= inside.y || inside.y <= 0.0 || inside.x >= endOfSight(p)) {
        p.stage = kLeft;
        return;
    }
    if (bent) {
        p.positionM = pointAlong(Ray(p.positionM, p.dir), inside.x);
        bend(p, inside.x);
    } else if (inside.x > 0.0) {
        p.positionM += inside.x * p.dir;
    }
    if (isOfEye(p)) p.flownM = max(inside.x, 0.0);
    p.positionM = repeated(p.positionM);
    if (inside.x > 0.0) p.positionM = clamp(p.positionM, vec3(0.0), u_.gridExtentM.xyz);
    p.cell = cellAt(p.positionM);
    p.stage = kFlying;
#if AIR
    bool meets = !p.toSun && meetsAir(p);
    p.airM = meets ? drawAirM(altitudeM(p.positionM), p.dir.z, p.hero, u.yz) : kNoAirM;
#endif
}

#if PERIODIC
/// Whether the path has just come through a side of the domain.
bool begins(Path p, int axis) {
    float atM = p.positionM[axis];
    return axis < 2 && (p.dir[axis] > 0.0 ? atM <= 0.0 : atM >= u_.gridExtentM[axis]);
}

/// Puts a path that bends from wall to wall back on its ray, whose height it would lose sight of.
void follow(inout Path p) {
    Ray ray = Ray(u_.eyeM.xyz, p.axis);
    p.positionM.z = clamp(pointAlong(ray, p.flownM).z, 0.0, u_.gridExtentM.z);
    p.dir = p.axis;
    bend(p, p.flownM);
    p.cell = cellAt(p.positionM);
}
#endif

/// Goes from wall to wall, a few at most, until there may be a particle: then returns the bound
/// that says so, else 0.
float cross(inout Path p) {
    const int kWalls = 4;
    for (int i = 0; i < kWalls && p.stage == kFlying; ++i) {
        Stretch s = stretchAhead(p.positionM, p.dir, p.cell);
        float lengthM = s.lengthM;
#if AIR
        bool inAir = p.flownM + lengthM >= p.airM;
        if (inAir) lengthM = max(p.airM - p.flownM, 0.0);
#endif
        float sightM = max(endOfSight(p) - p.flownM, 0.0);
        bool fades = lengthM >= sightM;
        lengthM = min(lengthM, sightM);
        float depth = s.boundPerM * lengthM;
        if (depth > p.depth) {
            p.positionM += p.depth / s.boundPerM * p.dir;
            p.flownM += p.depth / s.boundPerM;
            return s.boundPerM;
        }
        p.depth -= depth;
        p.flownM += lengthM;
#if AIR
        if (inAir) {
            p.positionM += lengthM * p.dir;
            p.axis = p.dir;
            p.kind = kAir;
            p.stage = kMet;
            break;
        }
#endif
        if (fades || !crossWall(s, p.dir, p.positionM, p.cell)) p.stage = kLeft;
        if (bends(p)) bend(p, s.lengthM);
#if PERIODIC
        if (bends(p) && p.stage == kFlying && begins(p, s.axis)) follow(p);
#endif
    }
    return 0.0;
}

/// There is a particle with the chance that the extinction has of the bound. On the way to the sun
/// none stops the light, but each place takes that share of it.
void meet(inout Path p, float boundPerM) {
    ++collisions_;
    float share = totalExtinctionPerM(sampleMedium(p.positionM)) / boundPerM;
    vec4 u = draw(p);
    p.depth = -log(1.0 - u.x);
    if (!p.toSun) {
        if (u.y < share) {
            p.stage = kMet;
            p.kind = kParticle;
            if (!bends(p)) p.axis = p.dir;
        }
        return;
    }
    p.sunlight *= 1.0 - share;
    float faint = kFaint;
    if (savesOnSunlight(p)) faint /= worthOfSunlight(p);
    if (p.sunlight < faint) {
        bool goesOn = u.z * faint < p.sunlight;
        p.sunlight = goesOn ? faint : 0.0;
        if (!goesOn) p.stage = kLeft;
    }
}
