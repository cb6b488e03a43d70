// library.comp: calls functions of the shader library so that their values can be read back.
#version 450 core
layout(local_size_x = 64) in;
#include "../../../shaders/lib/noise.glsl"
#include "../../../shaders/lib/optics.glsl"
#include "../../../shaders/lib/phase_cornette_shanks.glsl"
#include "../../../shaders/lib/phase_double_hg.glsl"
#include "../../../shaders/lib/phase_draine.glsl"
#include "../../../shaders/lib/phase_hg.glsl"
#include "../../../shaders/lib/phase_table.glsl"
#include "../../../shaders/lib/sky.glsl"
#include "../../../shaders/lib/tonemap.glsl"

const int kFunctions = 12;
layout(std430, binding = 0) readonly buffer Inputs {
    vec4 inputs[];
};  // x, y in [0, 1]
layout(std430, binding = 1) writeonly buffer Outputs {
    float outputs[];
};

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(inputs.length())) return;
    vec2 u = inputs[i].xy;
    float cosTheta = 2.0 * u.x - 1.0;
    float theta = kPi * u.x;
    uint at = i * uint(kFunctions);
    outputs[at + 0] = hgValue(cosTheta, 0.85);
    outputs[at + 1] = hgCumulative(theta, 0.85);
    outputs[at + 2] = hgSample(u.x, 0.85);
    outputs[at + 3] = cornetteShanksValue(cosTheta, 0.85);
    outputs[at + 4] = cornetteShanksCumulative(theta, 0.85);
    outputs[at + 5] = billow(vec3(u, 0.37));
    outputs[at + 6] = wisp(vec3(u, 0.37));
    outputs[at + 7] = lightStepPrinted(u.x, u.y, 3.0 * u.y, 0.3, 0.5);
    outputs[at + 8] = lightStepConsistent(u.x, u.y, 3.0 * u.y, 0.9, 0.3, 0.5);
    outputs[at + 9] = phaseTableIndex(cosTheta, 1024);
    outputs[at + 10] = displayValue(vec3(6.0 * u.x), 1).g;
    outputs[at + 11] = skyRadiance(cosTheta, vec3(0.1), vec3(0.5)).r;
}
