// ground.glsl: farmland on a square survey, or waves of wind on a sea, so that ground has a scale.
//
// What colours are multiplied by, whose mean over the ground is 1 in each channel. All is tuned by
// eye.
#pragma once
#include "random.glsl"

const int kPlainGround = 0, kFieldGround = 1, kSeaGround = 2;

const float kSectionM = 1609.344f;  ///< a mile: the squares of the U.S. land survey
const float kFieldM = 0.5f * kSectionM;

/// In [0, 1): the same for every point of a square of ground.
vec4 squareOfGround(vec2 square, uint kind) {
    ivec2 cell = ivec2(floor(square));
    return unitsOf(randomWords(uvec4(uint(cell.x), uint(cell.y), kind, 0u)));
}

/// Smooth noise about 0, within 1/2, with bumps of one unit.
float bumpsOfGround(vec2 at, uint kind) {
    vec2 f = at - floor(at);
    vec2 s = f * f * f * (f * (f * 6.0f - 15.0f) + 10.0f);
    float lower =
        mix(squareOfGround(at, kind).x, squareOfGround(at + vec2(1.0f, 0.0f), kind).x, s.x);
    float upper = mix(squareOfGround(at + vec2(0.0f, 1.0f), kind).x,
                      squareOfGround(at + vec2(1.0f, 1.0f), kind).x, s.x);
    return mix(lower, upper, s.y) - 0.5f;
}

/// How much of a pattern is left where a pixel covers so much ground.
float seenOfGround(float patternM, float pixelM) {
    return 1.0f / (1.0f + 12.0f * pixelM * pixelM / (patternM * patternM));
}

/// How much of a pixel a line has whose middle is `awayM` away.
float lineOfGround(float awayM, float halfM, float pixelM) {
    float widthM = max(halfM, 0.5f * pixelM);
    return clamp((widthM - awayM) / widthM + 0.5f, 0.0f, 1.0f) * halfM / widthM;
}

/// By what grows there: pasture, a green crop, stubble or ripe grain, bare soil.
vec3 cropOfGround(float draw, float shade) {
    vec3 colour = draw < 0.36f   ? vec3(0.94f, 0.98f, 0.96f)
                  : draw < 0.62f ? vec3(0.7f, 0.94f, 0.7f)
                  : draw < 0.82f ? vec3(1.46f, 1.21f, 1.49f)
                                 : vec3(1.04f, 0.9f, 0.97f);
    return colour * (0.86f + 0.28f * shade);
}

/// A section is four fields, or two halves, or strips; in some quarters a well waters a circle.
vec3 sectionOfGround(vec2 at) {
    vec4 layout_ = squareOfGround(at, 1u);
    vec2 section = floor(at);
    vec2 within = at - section;
    vec2 parts = vec2(2.0f);
    if (layout_.x > 0.85f) {
        parts = layout_.y < 0.5f ? vec2(8.0f, 1.0f) : vec2(1.0f, 8.0f);
    } else if (layout_.x > 0.5f) {
        parts = layout_.y < 0.5f ? vec2(2.0f, 1.0f) : vec2(1.0f, 2.0f);
    }
    vec2 field = 8.0f * section + floor(within * parts);
    vec4 draw = squareOfGround(field, 2u);
    vec2 inField = within * parts - floor(within * parts) - 0.5f;
    bool watered = parts.x == parts.y && draw.z < 0.2f && dot(inField, inField) < 0.23f;
    // A circle has the colour of a green crop.
    return watered ? cropOfGround(0.5f, 0.3f + 0.5f * draw.y) : cropOfGround(draw.x, draw.y);
}

/// Grain of one size, where it is seen.
float grainOfGround(vec2 positionM, float sizeM, uint kind, float pixelM) {
    float seen = seenOfGround(sizeM, pixelM);
    return seen < 0.03f ? 0.0f : seen * bumpsOfGround(positionM / sizeM, kind);
}

/// `pixelM`: what a pixel covers.
vec3 fieldsOfGround(vec2 positionM, float pixelM) {
    float hills = bumpsOfGround(positionM / 9000.0f, 3u);
    float regions = bumpsOfGround(positionM / 41000.0f, 4u);
    float creeks = bumpsOfGround(positionM / 7000.0f, 5u) +
                   0.5f * bumpsOfGround(positionM / 2300.0f, 6u) +
                   0.2f * bumpsOfGround(positionM / 700.0f, 7u);
    float range = bumpsOfGround(positionM / 17000.0f, 8u) + 0.3f * creeks;
    vec3 pattern =
        mix(vec3(1.0f), sectionOfGround(positionM / kSectionM), seenOfGround(kFieldM, pixelM));
    // Rough pasture where the land is broken, with the grain of its slopes.
    float rough = smoothstep(0.1f, 0.16f, range);
    float slopes = grainOfGround(positionM, 1100.0f, 9u, pixelM) +
                   grainOfGround(positionM, 420.0f, 10u, pixelM);
    pattern = mix(pattern, vec3(1.0f + 0.35f * slopes), rough);
    vec2 toRoad = kSectionM * abs(positionM / kSectionM - floor(positionM / kSectionM + 0.5f));
    float road = max(lineOfGround(toRoad.x, 7.0f, pixelM), lineOfGround(toRoad.y, 7.0f, pixelM));
    pattern = mix(pattern, vec3(1.7f, 1.55f, 1.9f), 0.7f * road * (1.0f - rough));
    // Trees along creeks: some 10 000 m of ground to one of `creeks`.
    float wood = lineOfGround(abs(creeks) * 9000.0f, 90.0f, pixelM) * (0.6f + 0.8f * rough);
    pattern = mix(pattern, vec3(0.45f, 0.62f, 0.5f), 0.9f * min(wood, 1.0f));
    float growth = grainOfGround(positionM, 130.0f, 14u, pixelM) +
                   grainOfGround(positionM, 29.0f, 15u, pixelM) +
                   grainOfGround(positionM, 7.0f, 16u, pixelM) +
                   grainOfGround(positionM, 1.7f, 17u, pixelM);
    pattern *= 1.0f + 0.16f * growth;
    return pattern * (1.0f + 0.16f * hills * seenOfGround(9000.0f, pixelM) +
                      0.2f * regions * seenOfGround(41000.0f, pixelM));
}

/// Patches of wind.
vec3 seaOfGround(vec2 positionM, float pixelM) {
    vec2 turned =
        vec2(0.8f * positionM.x - 0.6f * positionM.y, 0.6f * positionM.x + 0.8f * positionM.y);
    float gusts = bumpsOfGround(turned * vec2(1.0f, 0.4f) / 700.0f, 11u);
    float slicks = 0.7f * bumpsOfGround(turned / 7300.0f, 12u) +
                   0.4f * bumpsOfGround(positionM / 3700.0f, 13u);
    return vec3(1.0f + 0.18f * gusts * seenOfGround(700.0f, pixelM) +
                0.22f * slicks * seenOfGround(6500.0f, pixelM));
}

/// Share of the light from above that a rough sea mirrors towards an eye, which looks down at it by
/// `down`, the sine of its depression. [Bruneton10] for a wind of 5 m/s, slopes of 0.17
/// [CoxMunk54].
float seaMirrors(float down) {
    const float kSlope = 0.17f;
    return 0.02f + 0.98f * pow(1.0f - down, 5.0f * exp(-2.69f * kSlope)) /
                       (1.0f + 22.7f * pow(kSlope, 1.5f));
}

/// The direction whose sky it shows: waves that face the eye are seen more of than others.
vec3 seaMirrorsFrom(vec3 dir) {
    const float kTilted = 0.12f;  // about; tuned by eye
    return normalize(vec3(dir.x, dir.y, kTilted - dir.z));
}

vec3 groundPattern(int kind, vec2 positionM, float pixelM) {
    if (kind == kFieldGround) return fieldsOfGround(positionM, pixelM);
    return kind == kSeaGround ? seaOfGround(positionM, pixelM) : vec3(1.0f);
}
