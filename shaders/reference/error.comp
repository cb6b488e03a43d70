// error.comp: sums over each row of the image: radiance, and the variance of its mean.
#version 450 core
layout(local_size_x = 8) in;
#include "../shared/reference_layout.glsl"

layout(rgba32f, binding = kErrorHalfAImage) readonly uniform image2D i_halfA;
layout(rgba32f, binding = kErrorSquaresImage) readonly uniform image2D i_squares;
layout(rgba32f, binding = kErrorHalfBImage) readonly uniform image2D i_halfB;
layout(std430, binding = kErrorRowsBuffer) writeonly buffer Rows {
    vec2 rows_[];  // x: sum of means, y: of variances of means, over pixels and channels
};
layout(location = kErrorPathsLocation) uniform float paths;

void main() {
    ivec2 size = imageSize(i_squares);
    int row = int(gl_GlobalInvocationID.x);
    if (row >= size.y) return;
    vec2 sum = vec2(0.0);
    for (int x = 0; x < size.x; ++x) {
        ivec2 pixel = ivec2(x, row);
        vec3 mean = (imageLoad(i_halfA, pixel).rgb + imageLoad(i_halfB, pixel).rgb) / paths;
        vec3 spread = max(imageLoad(i_squares, pixel).rgb / paths - mean * mean, vec3(0.0));
        sum += vec2(dot(mean, vec3(1.0)), dot(spread, vec3(1.0)) / (paths - 1.0));
    }
    rows_[row] = sum;
}
