// frame_block.glsl: the numbers of one frame, of either engine, seen by GLSL (std140) and by C++
// (GLM).
//
// Only 16-byte members, so that both lay it out alike. Grid space: metres from the lower corner of
// the volume, axes as in world space. Slice i of n is the plane dot(normal, p) = firstM + (i + 1/2)
// spacingM; the light meets slice 0 first. The slices of the march face the sun and carry light
// alone.
#pragma once
#include "sizes.glsl"

const int kFrameBinding = 0;  // of the uniform block

const int kMaxClasses = kSpeciesCount;  // each species may be a class of its own

struct ClassBlock {
    vec4 colourAlbedo;  ///< rgb: colour × single-scattering albedo; w: albedo
    vec4 noise;         ///< x: amount, y and w: 1 / tile length in m, along x and z, and along y;
                        ///< z: 0 billow, 1 wisp
    vec4 forward;  ///< albedo times the share of light that counts as not scattered, where voxels
                   ///< of light are thin (x), thick (y) and very thick (z)
};

struct FrameBlock {
    vec4 eyeM;        ///< xyz in grid space; w: height above sea level of the grid's lower corner
    vec4 forward;     ///< unit; w: 1 when eye order is light order (front to back), else -1
    vec4 right;       ///< scaled by tan(fov/2) aspect
    vec4 up;          ///< scaled by tan(fov/2)
    vec4 normal;      ///< unit, from the light's side to the other; w: firstM
    vec4 towardsSun;  ///< unit; w: length of a light ray between two slices, m
    vec4 lightU;      ///< unit, across the light; w: coordinate of the light buffer's left edge, m
    vec4 lightV;      ///< likewise
    vec4 lightScale;  ///< xy: 1 / size of the light buffer in m; z: spacingM; w: ring radius in m
    vec4 march;       ///< xyz: shortest steps per m along each axis; w: share of the image that a
                      ///< longer step may dim, where steps adapt
    vec4 boxLowerM;   ///< occupied part of the volume
    vec4 boxUpperM;
    vec4 gridExtentM;     ///< of the whole volume
    vec4 cloudyAir;       ///< xy: distances between which clouds change what air sends, z: pixels
                          ///< between two rays of their table, w: 1 where there is one
    vec4 mixtureExtentM;  ///< of the half-resolution texture of the march, which between periodic
                          ///< sides divides the width evenly
    vec4 brickM;          ///< size of an occupancy brick
    vec4 forwardShare;    ///< x: CP(θ_f/4), y: CP(θ_f/2), z: cut-off transmittance of the eye
    vec4 lightPerM;       ///< of the voxels of light: their texture's coordinate is a point
    vec4 lightOffset;     ///< times this and this added
    vec4 sourcePerM;      ///< likewise of the light in them, which may be coarser
    vec4 sourceOffset;
    vec4 farGround;    ///< rgb: diffuse light, as a share of full light, of ground far away
    vec4 sky;          ///< x: 1 where the tables have it, else a gradient; y: sine of the
                       ///< horizon's elevation; z: how rays bend, 1/m; w: intensity of the sun
    vec4 sunRadiance;  ///< rgb: colour × intensity
    vec4 disc;         ///< xyz: unit, towards the sun's disc as the eye sees it
    vec4 discLight;    ///< rgb: irradiance of all of it at the eye, but for cloud and ground
    vec4 moon;         ///< xyz: from the moon towards the sun; w: 1 where it stands in its place
    vec4 skyZenith;    ///< rgb × intensity; with tables both are the intensity of the sun; w: kind
                       ///< of ground, shaders/lib/ground.glsl
    vec4 skyHorizon;   ///< rgb × intensity
    vec4 ambient;      ///< rgb: radiance that skylight gives a sample under open sky
    vec4 ground;       ///< rgb: radiance in full light, an irradiance of 4 pi; w: 1 when visible
    vec4 moved;        ///< xy: how far a grid that moves has gone over the ground, m
    vec4 shifted;      ///< xy: whole widths of the domain by which the eye stands further, m: a
                       ///< field that repeats looks the same from there, its ground does not
    ivec4
        slices;  ///< x: count, y: first of this batch, z: count of this batch, w: number of classes
    ivec4 sampling;  ///< x: number of this image among those averaged at rest; y: 1 for sky and
                     ///< ground behind the medium
    ivec4 image;     ///< xy: size in pixels, zw: size of the light buffer
    ivec4 whole;     ///< xy: size of the image that this is a part of; zw: lower left pixel in it
    ClassBlock classes[kMaxClasses];
};
