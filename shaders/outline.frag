#version 450 core
// Lines where the selected object of a pixel is another one than its neighbour's.
layout(binding = 0) uniform usampler2D u_ids;
layout(location = 1) uniform ivec2 u_low;   // the window's pixel that the first of u_ids is
layout(location = 2) uniform int u_width;   // of half a line in pixels
layout(location = 3) uniform vec3 u_color;
out vec4 color;

const ivec2 kAround[8] = ivec2[](ivec2(1, 0), ivec2(1, 1), ivec2(0, 1), ivec2(-1, 1), ivec2(-1, 0), ivec2(-1, -1),
                                 ivec2(0, -1), ivec2(1, -1));

// How many of the eight pixels at a distance show another object than `id`.
int differing(ivec2 at, int distance, uint id) {
    const ivec2 last = textureSize(u_ids, 0) - 1;
    int count = 0;
    for (int i = 0; i < 8; ++i) {
        const ivec2 p = at + kAround[i] * distance;
        // Nothing is known beyond the edge: no line there.
        if (p == clamp(p, ivec2(0), last) && texelFetch(u_ids, p, 0).r != id) ++count;
    }
    return count;
}

void main() {
    const ivec2 at = ivec2(gl_FragCoord.xy) - u_low;
    const uint id = texelFetch(u_ids, at, 0).r;
    // A straight edge is another object for three of eight; fewer are steps of a slanted one.
    const float line = min(float(differing(at, u_width, id)) / 3, 1);
    const float shadow = line < 1 ? 0.6 * min(float(differing(at, 2 * u_width, id)) / 3, 1) : 0;
    const float alpha = line + shadow * (1 - line);
    if (alpha == 0) discard;
    color = vec4(u_color * line / alpha, alpha);
}
