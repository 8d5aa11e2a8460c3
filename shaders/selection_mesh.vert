#version 450 core
// A triangle of a selected object's mesh.
struct Part {
    mat4 clip_from_unit;
    vec4 eye_in_unit;
    uvec4 form;  // x: as enum OutlineForm
};
layout(std430, binding = 0) readonly buffer Parts { Part parts[]; };
layout(location = 0) uniform int u_part;
layout(location = 0) in vec3 position;
out vec3 v_unit;
out float v_depth;
flat out vec4 v_eye;
flat out uint v_form;
flat out uint v_id;

void main() {
    v_unit = position;
    v_eye = vec4(0);
    v_form = parts[u_part].form.x;
    v_id = uint(u_part) + 1u;
    gl_Position = parts[u_part].clip_from_unit * vec4(position, 1);
    v_depth = gl_Position.z;
    gl_Position.z = 0;  // nothing is too near or too far
}
