#version 450 core
// The bounds of a selected object: the cube around its unit ball or box, or the square around its flat shape.
struct Part {
    mat4 clip_from_unit;
    vec4 eye_in_unit;  // w 1: where rays start; w 0: where they all go
    uvec4 form;        // x: as enum OutlineForm
};
layout(std430, binding = 0) readonly buffer Parts { Part parts[]; };
layout(location = 0) uniform int u_first;  // of the parts of this draw
out vec3 v_unit;
out float v_depth;
flat out vec4 v_eye;
flat out uint v_form;
flat out uint v_id;

void main() {
    const int part = u_first + gl_InstanceID;
    // Two triangles a face; the first face is the square.
    const vec2 corners[6] = vec2[](vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, -1), vec2(1, 1), vec2(-1, 1));
    const vec2 corner = corners[gl_VertexID % 6];
    const int face = gl_VertexID / 6;
    v_unit = vec3(corner, 0);
    if (parts[part].form.x < 2u) {
        const float depth = face < 3 ? -1.0 : 1.0;
        const int axis = face % 3;
        v_unit = axis == 0 ? vec3(depth, corner) : axis == 1 ? vec3(corner.x, depth, corner.y) : vec3(corner, depth);
    }
    v_eye = parts[part].eye_in_unit;
    v_form = parts[part].form.x;
    v_id = uint(part) + 1u;
    gl_Position = parts[part].clip_from_unit * vec4(v_unit, 1);
    v_depth = gl_Position.z;
    gl_Position.z = 0;  // nothing is too near or too far
}
