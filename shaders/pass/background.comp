// background.comp: puts sky and ground behind the eye buffer: T L_bg of Eq. 5. The ground shows the
// shadow of the cloud.
#version 450 core
layout(local_size_x = 8, local_size_y = 8) in;
#include "../lib/sky.glsl"
#include "frame.glsl"

layout(binding = 4) uniform sampler2DArray t_light;
layout(rgba32f, binding = 0) readonly uniform image2D i_eye;
layout(rgba32f, binding = 1) writeonly uniform image2D o_linear;
layout(location = 0) uniform int lastLayer;

/// Share of sunlight that reaches a point of the ground: what is left in the light buffer after the
/// last slice.
float sunOnGround(vec3 positionM) {
    vec2 at = lightCoordinate(positionM);
    if (u_.slices.x == 0 || any(lessThan(at, vec2(0.0))) || any(greaterThan(at, vec2(1.0)))) {
        return 1.0;
    }
    return textureLod(t_light, vec3(at, lastLayer), 0.0).r;
}

vec3 groundRadiance(vec3 positionM, float distanceM) {
    float high = max(u_.towardsSun.z, 0.0);
    vec3 light = u_.sunRadiance.rgb * high * sunOnGround(positionM) + u_.ambient.rgb;
    return hazyGround(u_.ground.rgb * light, u_.skyHorizon.rgb, distanceM);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, u_.picture.xy))) return;
    Ray ray = rayThrough(pixel);
    vec3 behind = skyRadiance(ray.dir.z, u_.skyZenith.rgb, u_.skyHorizon.rgb);
    float groundM = groundDistanceM(ray);
    if (groundM > 0.0) behind = groundRadiance(ray.originM + groundM * ray.dir, groundM);
    vec4 eye = imageLoad(i_eye, pixel);
    imageStore(o_linear, pixel, vec4(eye.rgb + eye.a * behind, 1.0 - eye.a));
}
