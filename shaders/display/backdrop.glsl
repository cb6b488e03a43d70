// backdrop.glsl: sky and ground, L_bg of Eq. 5. The ground shows the shadow of the cloud: what is
// left of the light behind the last slice.
#pragma once
#include "../shared/light_layout.glsl"
#include "../sky/air.glsl"

layout(binding = kLightUnit) uniform sampler2DArray t_light;
#if FULL
// Diffuse light as a share of full light.
layout(binding = kGroundLightUnit) uniform sampler2D t_groundLight;
#endif

/// Share of sunlight that reaches a point of the ground.
float sunOnGround(vec3 positionM, int lastLayer) {
    vec2 at = lightCoordinate(positionM);
    if (u_.slices.x == 0) return 1.0;
#if !PERIODIC
    if (any(lessThan(at, vec2(0.0))) || any(greaterThan(at, vec2(1.0)))) return 1.0;
#endif
    return textureLod(t_light, vec3(at, lastLayer), 0.0).r;
}

#if FULL
vec3 groundLight(vec3 positionM, float sun) {
    vec2 at = repeated(positionM).xy * u_.sourcePerM.xy + u_.sourceOffset.xy;
    vec3 diffuse = textureLod(t_groundLight, at, 0.0).rgb;
#if !PERIODIC
    // What clouds send down beyond the voxels of light is not known: it fades away before.
    const float kFade = 0.15;
    vec2 inside = min(at, 1.0 - at);
    diffuse = mix(u_.farGround.rgb, diffuse, smoothstep(0.0, kFade, min(inside.x, inside.y)));
#endif
    return max(u_.towardsSun.z, 0.0) * sun * sunAt(0.0) * u_.sunRadiance.rgb + diffuse;
}
#else
vec3 groundLight(vec3 positionM, float sun) {
    return u_.sunRadiance.rgb * sunAt(0.0) * max(u_.towardsSun.z, 0.0) * sun + u_.ambient.rgb;
}
#endif

vec3 groundBehind(Ray ray, float groundM, int lastLayer) {
    vec3 positionM = groundPoint(ray, groundM);
    vec3 light = groundLight(positionM, sunOnGround(positionM, lastLayer));
    if (hasAir()) {
        vec3 sent =
            groundSeen(ray, groundM) * u_.ground.rgb * light + groundMirrors(ray, positionM);
        return throughAir(airRay(ray.dir), groundM, sent, 1.0);
    }
    return hazyGround(u_.ground.rgb * light, u_.skyHorizon.rgb, groundM);
}

/// What is behind the medium; `discShown`: of the sun's disc, what is left besides.
vec3 backdrop(Ray ray, int lastLayer, float discShown) {
    if (u_.sampling.y == 0) return vec3(0.0);
    float groundM = groundDistanceM(ray);
    float sky = skyShareOf(ray.dir);
    if (sky > 0.0 && sky < 1.0) {  // the pixel has some of both
        Ray lower = Ray(ray.originM, besideHorizon(ray.dir, -1.0));
        vec3 ground = groundBehind(lower, groundDistanceM(lower), lastLayer);
        return mix(ground, eyeSky(besideHorizon(ray.dir, 1.0)), sky) +
               (groundM <= 0.0 ? discShown * sunDisc(ray.dir) : vec3(0.0));
    }
    if (groundM <= 0.0) return eyeSky(ray.dir) + discShown * sunDisc(ray.dir);
    return groundBehind(ray, groundM, lastLayer);
}
