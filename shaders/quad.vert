#version 450 core
// A rectangle of the window as two triangles; (0, 0) of v_uv is its top left corner.
layout(location = 0) uniform vec4 u_place;  // left, top, right, bottom in clip space
out vec2 v_uv;

void main() {
    const vec2 corners[6] = vec2[](vec2(0, 0), vec2(0, 1), vec2(1, 1), vec2(0, 0), vec2(1, 1), vec2(1, 0));
    v_uv = corners[gl_VertexID];
    gl_Position = vec4(mix(u_place.xy, u_place.zw, v_uv), 0, 1);
}
