// backdrop.glsl: sky and ground, L_bg of Eq. 5. The ground shows the shadow of the cloud: what is
// left of the light behind the last slice.
#pragma once
#include "../lib/sky.glsl"
#include "../shared/frame.glsl"
#include "../shared/light_layout.glsl"

layout(binding = kLightUnit) uniform sampler2DArray t_light;

/// Share of sunlight that reaches a point of the ground.
float sunOnGround(vec3 positionM, int lastLayer) {
    vec2 at = lightCoordinate(positionM);
    if (u_.slices.x == 0 || any(lessThan(at, vec2(0.0))) || any(greaterThan(at, vec2(1.0)))) {
        return 1.0;
    }
    return textureLod(t_light, vec3(at, lastLayer), 0.0).r;
}

vec3 backdrop(Ray ray, int lastLayer) {
    if (u_.sampling.y == 0) return vec3(0.0);
    float groundM = groundDistanceM(ray);
    if (groundM <= 0.0) return skyRadiance(ray.dir.z, u_.skyZenith.rgb, u_.skyHorizon.rgb);
    float high = max(u_.towardsSun.z, 0.0);
    float sun = sunOnGround(ray.originM + groundM * ray.dir, lastLayer);
    vec3 light = u_.sunRadiance.rgb * high * sun + u_.ambient.rgb;
    return hazyGround(u_.ground.rgb * light, u_.skyHorizon.rgb, groundM);
}
