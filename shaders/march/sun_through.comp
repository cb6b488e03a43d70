// sun_through.comp: sunlight behind slices, by place across the light and slice, at half the
// resolution of the light: what clouds leave for the air.
//
// Layers of the batch that is held; the last is that behind the last slice.
#version 450 core
#include "../shared/march_layout.glsl"
layout(local_size_x = kSunThroughGroup, local_size_y = kSunThroughGroup) in;
#include "../shared/frame.glsl"
#include "../shared/light_layout.glsl"

layout(binding = kLightUnit) uniform sampler2DArray t_light;
layout(r16, binding = kSunThroughImage) writeonly uniform image3D o_through;
layout(location = kSunThroughLayerLocation) uniform int layer;  // to be written

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID);
    ivec3 size = imageSize(o_through);
    if (any(greaterThanEqual(texel, size.xy))) return;
    vec2 at = (vec2(texel) + 0.5) / vec2(size.xy);
    int held = min(kSlicesPerSunThrough * layer, u_.slices.x) - u_.slices.y;
    imageStore(o_through, ivec3(texel, layer), vec4(textureLod(t_light, vec3(at, held), 0.0).r));
}
