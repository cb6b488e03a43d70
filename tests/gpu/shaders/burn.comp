// burn.comp: work whose amount the caller sets: sines, each of which waits for the one before.
#version 450 core
layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer Values {
    float values[];
};
layout(location = 0) uniform int u_rounds;

void main() {
    const uint i = gl_GlobalInvocationID.x;
    float value = values[i];
    for (int k = 0; k < u_rounds; ++k) value = sin(value + 1.0);
    values[i] = value;
}
