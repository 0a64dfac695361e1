// How faces are drawn, as GLSL.

export const vertexShader = `
in float value;
out vec3 place;
out vec3 direction;
out float shown;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  place = seen.xyz;
  direction = normalMatrix * normal;
  shown = value;
  gl_Position = projectionMatrix * seen;
}`;

const coding = `
vec3 decoded(vec3 srgb) {
  return mix(srgb / 12.92, pow((srgb + 0.055) / 1.055, vec3(2.4)), step(0.04045, srgb));
}
vec3 encoded(vec3 linear) {
  return mix(12.92 * linear, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, linear));
}`;

/** TEXCOORD is the attribute with the texture coordinates. Vertex colours are interpolated as the file means them. */
export const lookVertexShader = `${coding}
in vec2 TEXCOORD;
in vec4 tint;
out vec3 place;
out vec3 direction;
out vec2 texel;
out vec4 tinted;
uniform mat3 transform;
uniform bool isLinear;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  place = seen.xyz;
  direction = normalMatrix * normal;
  texel = (transform * vec3(TEXCOORD, 1.0)).xy;
  tinted = vec4(isLinear ? decoded(tint.rgb) : tint.rgb, tint.a);
  gl_Position = projectionMatrix * seen;
}`;

// The light comes from the eye, and a little from above.
const light = `
in vec3 place;
in vec3 direction;
uniform bool isSmooth;
vec3 normalHere() {
  vec3 flatNormal = normalize(cross(dFdx(place), dFdy(place)));
  return isSmooth && dot(direction, direction) > 0.0 ? normalize(direction) : flatNormal;
}
float light() {
  vec3 normal = normalHere();
  if (dot(normal, place) > 0.0) normal = -normal;
  return 0.35 + 0.5 * max(0.0, normal.z) + 0.15 * max(0.0, dot(normal, vec3(-0.4, 0.8, 0.45)));
}`;

// Less shadow than elsewhere leaves the colours of a scale apart.
const scaled = `
uniform float top;
uniform sampler2D scale;
vec3 scaled(float value, float light) {
  return texture(scale, vec2(clamp(value / top, 0.0, 0.9999), 0.5)).rgb * (0.6 + 0.4 * light);
}`;

/** A face seen from behind has another colour. */
export const faceShader = `${light}${scaled}
in float shown;
out vec4 colour;
uniform bool isScaled;
uniform bool isSigned;
uniform bool areNormals;
uniform float opacity;
uniform vec3 front;
uniform vec3 back;
void main() {
  if (areNormals) {
    vec3 seen = isSmooth || gl_FrontFacing ? normalHere() : -normalHere();
    colour = vec4(0.5 + 0.5 * (seen * mat3(viewMatrix)), opacity); // by the axes of the model
    return;
  }
  float value = isSigned ? abs(shown * 65535.0 - 32768.0) / 32767.0 : shown;
  vec3 own = gl_FrontFacing ? front : back;
  colour = vec4(isScaled ? scaled(value, light()) : own * light(), opacity);
}`;

/** Factor, image and vertex colour, multiplied in linear light. There is less shadow than elsewhere. */
export const lookShader = `${light}${coding}
in vec2 texel;
in vec4 tinted;
out vec4 colour;
uniform bool hasImage, isTinted, isLinear, isOpaque;
uniform sampler2D image;
uniform vec3 factor;
uniform float opacity, cutoff;
void main() {
  vec4 own = vec4(factor, opacity);
  if (hasImage) own *= texture(image, texel);
  if (isTinted) own *= vec4(isLinear ? tinted.rgb : decoded(tinted.rgb), tinted.a);
  if (own.a < cutoff) discard;
  colour = vec4(encoded(own.rgb) * (0.6 + 0.4 * light()), isOpaque ? 1.0 : own.a);
}`;

/** What is seen at each pixel: how far away it is, as the bytes of a number, and its light. */
export const placeShader = `${light}
layout(location = 0) out vec4 depth;
layout(location = 1) out vec4 lightness;
void main() {
  uint bits = floatBitsToUint(-place.z);
  depth = vec4(uvec4(bits, bits >> 8, bits >> 16, bits >> 24) & 255u) / 255.0;
  lightness = vec4(light());
}`;

export const lineVertexShader = `
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

/** Black where it is bright behind the line, white where it is dark. */
export const lineShader = `
uniform sampler2D behind;
out vec4 colour;
void main() {
  float brightness = dot(texelFetch(behind, ivec2(gl_FragCoord.xy), 0).rgb, vec3(0.299, 0.587, 0.114));
  colour = vec4(vec3(brightness > 0.4 ? 0.0 : 1.0), 0.5);
}`;

/** A triangle that covers the whole pane. */
export const paneShader = `
void main() {
  gl_Position = vec4(position, 1.0);
}`;

/** A value for each pixel, below 0 where there is none. */
export const pixelShader = `${scaled}
out vec4 colour;
uniform sampler2D values;
uniform sampler2D lights;
uniform sampler2D depths;
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float value = texelFetch(values, pixel, 0).r;
  if (value < 0.0) discard;
  colour = vec4(scaled(value, texelFetch(lights, pixel, 0).r), 1.0);
  gl_FragDepth = texelFetch(depths, pixel, 0).r;
}`;
