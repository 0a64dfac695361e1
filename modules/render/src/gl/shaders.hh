#pragma once

// Computations per vertex, for scenes and figures, and per sample, for scenes. docs/dev/render.md has the formula of
// the shading.

namespace whittle::render {

inline constexpr const char* vertex_shader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 texcoord;
layout(location = 3) in vec4 color;
uniform mat4 to_clip;
uniform float dot_size;
out vec3 surface_place;
out vec3 surface_normal;
out vec2 surface_texcoord;
out vec4 surface_color;
void main() {
  surface_place = position;
  surface_normal = normal;
  surface_texcoord = texcoord;
  surface_color = color;
  gl_PointSize = dot_size;
  gl_Position = to_clip * vec4(position, 1);
}
)";

inline constexpr const char* fragment_shader = R"(#version 330 core
const int mask = 1;
const int blend = 2;
const float ground = 0.15;
const float sky = 0.45;
const float head = 0.6;
in vec3 surface_normal;
in vec2 surface_texcoord;
in vec4 surface_color;
uniform sampler2D base_color_texture;
uniform vec4 base_color;
uniform int alpha_mode;
uniform float alpha_cutoff;
uniform vec3 to_eye;
uniform vec3 up;
out vec4 result;
void main() {
  vec4 color = base_color * surface_color * texture(base_color_texture, surface_texcoord);
  if (alpha_mode == mask && !(color.a >= alpha_cutoff)) discard;
  vec3 facing = gl_FrontFacing ? surface_normal : -surface_normal;
  float squared_length = dot(facing, facing);
  vec3 normal = squared_length > 1e-12 ? facing * inversesqrt(squared_length) : to_eye;
  float light = mix(ground, sky, 0.5 + 0.5 * dot(normal, up)) + head * max(dot(normal, to_eye), 0.0);
  result = clamp(vec4(color.rgb * light, alpha_mode == blend ? color.a : 1.0), 0.0, 1.0);
}
)";

}  // namespace whittle::render
