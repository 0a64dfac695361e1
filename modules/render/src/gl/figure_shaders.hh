#pragma once

// How figures are drawn: as the page of `whittle report` draws them (modules/report/viewer/src/shaders.js).

namespace whittle::render {

inline constexpr const char* figure_fragment_shader = R"(#version 330 core
const int mask = 1;
const int blend = 2;
const int soft = 1;
const int normals = 2;
const int no_shade = 3;
in vec3 surface_place;
in vec3 surface_normal;
in vec2 surface_texcoord;
in vec4 surface_color;
uniform sampler2D base_color_texture;
uniform vec4 base_color;
uniform int alpha_mode;
uniform float alpha_cutoff;
uniform int shade;
uniform bool has_back;
uniform vec3 back;
uniform vec3 eye;
uniform vec3 right;
uniform vec3 up;
uniform vec3 to_eye;
out vec4 result;
vec3 encoded(vec3 linear) {
  return mix(12.92 * linear, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, linear));
}
vec3 facing_normal() {
  float squared_length = dot(surface_normal, surface_normal);
  vec3 normal = squared_length > 1e-12 ? surface_normal * inversesqrt(squared_length) : to_eye;
  return dot(normal, surface_place - eye) > 0.0 ? -normal : normal;
}
float light() {
  vec3 normal = facing_normal();
  vec3 seen = vec3(dot(normal, right), dot(normal, up), dot(normal, to_eye));
  return 0.35 + 0.5 * max(0.0, seen.z) + 0.15 * max(0.0, dot(seen, vec3(-0.4, 0.8, 0.45)));
}
void main() {
  vec4 color = base_color * surface_color * texture(base_color_texture, surface_texcoord);
  if (alpha_mode == mask && !(color.a >= alpha_cutoff)) discard;
  vec3 shown = encoded(clamp(color.rgb, 0.0, 1.0));
  if (has_back && !gl_FrontFacing) shown = back;
  if (shade == normals) {
    shown = 0.5 + 0.5 * normalize(surface_normal);
  } else if (shade != no_shade) {
    shown *= shade == soft ? 0.6 + 0.4 * light() : light();
  }
  result = clamp(vec4(shown, alpha_mode == blend ? color.a : 1.0), 0.0, 1.0);
}
)";

}  // namespace whittle::render
