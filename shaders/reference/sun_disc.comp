// sun_disc.comp: adds the sun's disc to an image, dimmed by the medium before it. Paths do not
// carry it: it outshines all else, so that their errors would be its own.
#version 450 core
#include "../shared/reference_layout.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
#include "../medium/ray_in_box.glsl"
#include "../medium/sample.glsl"
#include "../medium/total_extinction.glsl"
#include "../sky/air.glsl"

layout(rgba32f, binding = kSunDiscImage) uniform image2D io_mean;
layout(location = kSunDiscStepLocation) uniform float stepM;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, u_.image.xy)) || u_.sampling.y == 0) return;
    Ray ray = rayThrough(pixel);
    vec3 disc = sunDisc(ray.dir);
    if (disc.g <= 0.0 || groundDistanceM(ray) > 0.0) return;
    const float kNothing = 40.0;  // gets through
    vec2 insideM = insideBoxM(ray);
    float depth = 0.0;
    for (float atM = insideM.x; atM < insideM.y && depth < kNothing; atM += stepM) {
        float lengthM = min(stepM, insideM.y - atM);
        depth += lengthM * totalExtinctionPerM(sampleMedium(pointAlong(ray, atM + 0.5 * lengthM)));
    }
    vec4 seen = imageLoad(io_mean, pixel);
    imageStore(io_mean, pixel, vec4(seen.rgb + exp(-depth) * disc, seen.a));
}
