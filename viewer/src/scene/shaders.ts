/**
 * Threads and corner masses are drawn as quads that face the camera, shaded as the cylinders and
 * spheres they stand for: two triangles each, one draw call for all. Thin threads keep a least
 * width on the screen. Positions come from a texture, one texel a node: x, y, z, value.
 */
const common = /* glsl */ `
precision highp float;
precision highp sampler2D;
uniform sampler2D nodes;
uniform int texels;
uniform mat4 view;
uniform mat4 projection;
uniform float pixel;      // size of a pixel at distance 1
uniform vec4 range;       // low, 1 / (high - low) or 1 / log(high / low), logarithmic
vec4 node(float index) {
  int k = int(index);
  return texelFetch(nodes, ivec2(k % texels, k / texels), 0);
}
float placed(float value) {
  float t = range.z > 0.5 ? (value > 0.0 ? log(value / range.x) : 0.0) : value - range.x;
  return clamp(t * range.y, 0.0, 1.0);
}
`;

export const threadVertex = /* glsl */ `
${common}
in vec2 corner;           // across -1 or 1, along 0 or 1
in vec2 ends;
in float radius;
in float value;
uniform float least;      // pixels, half of the least width
uniform bool onNodes;
uniform float chosen;
out vec2 cap;             // across, and beyond the ends, in half widths
out float shade;
out vec3 side;
out vec3 facing;
flat out float marked;
void main() {
  vec4 a = node(ends.x), b = node(ends.y);
  vec3 pa = (view * vec4(a.xyz, 1.0)).xyz, pb = (view * vec4(b.xyz, 1.0)).xyz;
  vec3 line = pb - pa;
  float span = length(line);
  vec3 axis = span > 0.0 ? line / span : vec3(1.0, 0.0, 0.0);
  vec3 p = mix(pa, pb, corner.y);
  vec3 across = cross(axis, -p);
  float size = length(across);
  side = size > 1e-9 * length(p) ? across / size : vec3(1.0, 0.0, 0.0);
  facing = normalize(cross(side, axis));
  marked = float(gl_InstanceID) == chosen ? 1.0 : 0.0;
  float depth = max(-p.z, 1e-4);
  float half_width = max(radius, least * pixel * depth) * (1.0 + 1.4 * marked);
  float beyond = 2.0 * corner.y - 1.0;
  vec3 q = p + side * (corner.x * half_width) + axis * (beyond * half_width);
  q *= 1.0 - (1.0 + marked) * half_width / max(length(q), 1e-4);
  cap = vec2(corner.x, corner.y > 0.5 ? 1.0 + span / half_width : -1.0);
  cap.y -= 0.5 * span / half_width;
  shade = placed(onNodes ? mix(a.w, b.w, corner.y) : value);
  gl_Position = projection * vec4(q, 1.0);
}`;

export const threadFragment = /* glsl */ `
precision highp float;
precision highp sampler2D;
uniform sampler2D scale;
uniform vec3 mark;
in vec2 cap;
in float shade;
in vec3 side;
in vec3 facing;
flat in float marked;
out vec4 colour;
void main() {
  float u = clamp(cap.x, -1.0, 1.0);
  vec3 normal = normalize(side * u + facing * sqrt(1.0 - u * u));
  float light = 0.8 + 0.2 * max(0.0, dot(normal, normalize(vec3(-0.35, 0.6, 0.72))));
  vec3 base = texture(scale, vec2((shade * 255.0 + 0.5) / 256.0, 0.5)).rgb;
  colour = vec4(mix(base, mark, marked) * light, 1.0);
}`;

export const ballVertex = /* glsl */ `
${common}
in vec2 corner;
in float index;
in float radius;
uniform float least;
out vec2 place;
void main() {
  vec3 p = (view * vec4(node(index).xyz, 1.0)).xyz;
  float size = max(radius, least * pixel * max(-p.z, 1e-4));
  place = corner;
  vec3 q = p + vec3(corner * size, 0.0);
  q *= 1.0 - size / max(length(q), 1e-4);
  gl_Position = projection * vec4(q, 1.0);
}`;

export const ballFragment = /* glsl */ `
precision highp float;
uniform vec3 tint;
in vec2 place;
out vec4 colour;
void main() {
  float r2 = dot(place, place);
  if (r2 > 1.0) discard;
  vec3 normal = vec3(place, sqrt(1.0 - r2));
  float light = max(0.0, dot(normal, normalize(vec3(-0.35, 0.6, 0.72))));
  float gleam = pow(max(0.0, dot(normal, normalize(vec3(-0.2, 0.35, 0.95)))), 40.0);
  colour = vec4(tint * (0.5 + 0.5 * light) + 0.25 * gleam, 1.0);
}`;
