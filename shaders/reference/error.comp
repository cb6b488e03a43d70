// error.comp: sums over each row of the picture: radiance, and the variance of its mean.
#version 450 core
layout(local_size_x = 8) in;

layout(rgba32f, binding = 0) readonly uniform image2D i_halfA;
layout(rgba32f, binding = 1) readonly uniform image2D i_squares;
layout(rgba32f, binding = 2) readonly uniform image2D i_halfB;
layout(std430, binding = 7) writeonly buffer Rows {
    vec2 rows_[];  // x: sum of means, y: of variances of means, over pixels and channels
};
layout(location = 0) uniform float paths;

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
