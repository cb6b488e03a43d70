// gather.comp: adds the results of one pass to the sums, and writes the mean image.
#version 450 core
layout(local_size_x = 8, local_size_y = 8) in;
#include "../shared/reference_layout.glsl"

layout(std430, binding = kResultsBuffer) readonly buffer Results {
    vec4 results_[];
};
// Sums: radiance, paths that met particles.
layout(rgba32f, binding = kGatherHalfImage) uniform image2D io_half;
// Of radiance; w: sum of first distances.
layout(rgba32f, binding = kGatherSquaresImage) uniform image2D io_squares;
layout(rgba32f, binding = kGatherOtherImage) readonly uniform image2D i_other;  // the other half
layout(rgba32f, binding = kGatherMeanImage) writeonly uniform image2D o_mean;
layout(location = kGatherFirstResultLocation) uniform int firstResult;
layout(location = kGatherPerPathLocation) uniform float perPath;  // 1 / paths in both halves

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(io_half);
    if (any(greaterThanEqual(pixel, size))) return;
    vec4 result = results_[firstResult + pixel.y * size.x + pixel.x];
    bool met = result.w >= 0.0;
    vec4 sum = imageLoad(io_half, pixel) + vec4(result.rgb, met ? 1.0 : 0.0);
    imageStore(io_half, pixel, sum);
    vec4 squares = imageLoad(io_squares, pixel) + vec4(result.rgb * result.rgb, max(result.w, 0.0));
    imageStore(io_squares, pixel, squares);
    imageStore(o_mean, pixel, (sum + imageLoad(i_other, pixel)) * perPath);
}
