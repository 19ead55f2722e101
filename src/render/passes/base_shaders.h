#pragma once

/// The source of the shaders of pass 2. World space is in metres, z up; colours are linear light.
namespace tumble::render {

/// The start of both fragment shaders. `finish(colour, mask)` writes a texel of the base image.
inline const char* const kBaseOutput = R"(
uniform float focus;       // m; 0 without depth of field
uniform float blur;        // its strength
uniform float fog_start;   // m
uniform vec3 horizon;      // colour that everything fades to
out uvec4 base;

// Physically the blur of a lens: 1 − focus/depth, with a range around the plane of focus where all is sharp.
float depth_mask(float depth) {
  if (focus <= 0.0) return 0.0;
  return clamp((abs(1.0 - focus / depth) - 0.12) * 1.9 * blur, 0.0, 0.95);
}

void finish(vec3 colour, float mask) {
  base = uvec4(vec4(sqrt(clamp(colour, 0.0, 1.0)), clamp(mask, 0.0, 1.0)) * 255.0 + 0.5);
}
)";

inline const char* const kBaseVertices = R"(
uniform mat4 clip_from_world, light_from_world;
uniform vec3 eye, right, up, forward;
uniform vec3 light_at;
uniform float shadow_offset;  // m along the normal, so that a surface does not shade itself
uniform float shadow_radius;  // m, half the width of a shadow's soft edge
uniform float motion;         // picture heights in a unit of tangent; 0 without motion blur

#ifdef SOLID                  // a round surface: its normal varies over a triangle
out vec3 round_normal;
vec3 normal;
flat out vec3 tangent, tint;
#else
flat out vec3 normal, tangent, tint;
#endif
flat out vec4 look_f;         // layer, plain, half extents of the face in m
flat out vec4 light_u, light_v;
out vec4 light_clip;
out vec3 at;
out vec2 uv, on_face;
out vec2 rate;                // of the picture, heights per second
out float diffuse;            // of the light, at the vertex

void main() {
  vec3 at_B = corner * half_extent;
  vec3 arm = axis_x * at_B.x + axis_y * at_B.y + axis_z * at_B.z;
  at = centre + arm;
  gl_Position = clip_from_world * vec4(at, 1.0);
  normal = axis_x * normal_B.x + axis_y * normal_B.y + axis_z * normal_B.z;
#ifdef SOLID
  round_normal = normal;
  tangent = normalize(cross(abs(normal.z) < 0.7 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0), normal));
  vec3 bitangent = cross(normal, tangent);
  on_face = vec2(0.0);
  look_f = vec4(look.x, look.w, 1e6, 1e6);  // no edges
  uv = tangent_B.xy * vec2(0.45, 0.55) + look.yz;
#else
  vec3 bitangent_B = abs(cross(normal_B, tangent_B));
  tangent = axis_x * tangent_B.x + axis_y * tangent_B.y + axis_z * tangent_B.z;
  vec3 bitangent = axis_x * bitangent_B.x + axis_y * bitangent_B.y + axis_z * bitangent_B.z;

  vec2 half_face = vec2(dot(tangent_B, half_extent), dot(bitangent_B, half_extent));
  on_face = vec2(dot(corner, tangent_B), dot(corner, bitangent_B)) * half_face;
  look_f = vec4(look.x, look.w, half_face);
  if (look.x < 0.5) {
    uv = on_face / half_face * 0.5 + 0.5;   // a crate's bands lie on its edges
  } else if (look.x > 4.5) {
    uv = at.xy * 0.25;                      // the ground stays where it is
  } else {
    vec2 along = half_face.x >= half_face.y ? on_face : on_face.yx;  // grain runs along
    uv = along * vec2(0.45, 0.55) + look.yz;
  }
#endif
  tint = tint_in;

  light_clip = light_from_world * vec4(at + normal * shadow_offset, 1.0);
  light_u = light_from_world * vec4(tangent * shadow_radius, 0.0);
  light_v = light_from_world * vec4(bitangent * shadow_radius, 0.0);
  diffuse = max(dot(normal, normalize(light_at - at)), 0.0);

  vec3 v = velocity + cross(spin, arm);
  vec3 away = at - eye;
  float depth = max(dot(away, forward), 0.1);
  vec2 place = vec2(dot(away, right), dot(away, up)) / depth;
  rate = (vec2(dot(v, right), dot(v, up)) - place * dot(v, forward)) / depth * motion;
}
)";

inline const char* const kBaseFragments = R"(
uniform sampler2DArray materials;
uniform sampler2DShadow depth_map;
uniform vec3 eye, forward;
uniform vec3 light_at;
uniform float texel_angle;     // tangent of a picture's pixel
uniform bool with_shadow, with_specular, per_vertex;

#ifdef SOLID
in vec3 round_normal;
vec3 normal;
flat in vec3 tangent, tint;
#else
flat in vec3 normal, tangent, tint;
#endif
flat in vec4 look_f;
flat in vec4 light_u, light_v;
in vec4 light_clip;
in vec3 at;
in vec2 uv, on_face;
in vec2 rate;
in float diffuse;

const vec3 kSun = vec3(1.32, 1.25, 1.12);
const vec3 kSky = vec3(0.36, 0.40, 0.47);
const vec3 kBounce = vec3(0.20, 0.18, 0.16);

// The lit part, 0 … 1: 16 lookups over a square of the surface itself, each of which compares four texels. Where the
// corners and the middle agree, nearly everywhere, they decide.
float lit_part() {
  vec3 s = light_clip.xyz / light_clip.w;
  if (light_clip.w <= 0.0 || max(abs(s.x), abs(s.y)) > 0.99) return 1.0;
  vec4 c_u = light_clip + light_u, c_v = light_clip + light_v;
  vec3 du = (c_u.xyz / c_u.w - s) * 0.5, dv = (c_v.xyz / c_v.w - s) * 0.5;
  s = s * 0.5 + 0.5;
  float corners = texture(depth_map, s - du - dv) + texture(depth_map, s + du - dv) +
                  texture(depth_map, s - du + dv) + texture(depth_map, s + du + dv);
  float middle = texture(depth_map, s);
  if (corners + middle == 0.0) return 0.0;
  if (corners + middle == 5.0) return 1.0;
  float sum = corners;
  for (int i = 0; i < 4; ++i) {
    float k = float(i) * (2.0 / 3.0) - 1.0;
    sum += texture(depth_map, s + du * k - dv * (1.0 / 3.0)) + texture(depth_map, s + du * k + dv * (1.0 / 3.0));
  }
  for (int i = 1; i < 3; ++i) {
    float k = float(i) * (2.0 / 3.0) - 1.0;
    sum += texture(depth_map, s + du * k - dv) + texture(depth_map, s + du * k + dv);
  }
  return sum / 16.0;
}

vec3 ambient(vec3 to_light) {
  vec3 light = mix(kBounce, kSky, normal.z * 0.5 + 0.5);
  // A weak fill from the other side keeps two faces in the shade apart.
  light += vec3(0.10) * max(dot(normal, vec3(-to_light.xy, 0.2)), 0.0);
  if (look_f.x < 4.5) light *= mix(0.62, 1.0, smoothstep(0.0, 1.5, at.z + max(normal.z, 0.0)));
  return light;
}

// Darker where a face ends, so that touching boxes stay apart; fades out where the line is finer than a pixel.
float edge_shade(float depth) {
  float pixel = depth * texel_angle;
  vec2 inside = look_f.zw - abs(on_face);
  float line = 1.0 - smoothstep(0.0, max(0.03, pixel * 1.25), min(inside.x, inside.y));
  float strength = look_f.x > 4.5 ? 0.0 : look_f.x > 3.5 ? 0.25 : 0.45;
  return 1.0 - strength * line * min(1.0, 0.06 / pixel);
}

void main() {
#ifdef SOLID
  normal = normalize(round_normal);
#endif
  float depth = dot(at - eye, forward);
  if (look_f.y > 0.5) {
    finish(tint, 0.0);
    return;
  }
  vec4 albedo = texture(materials, vec3(uv, look_f.x));
  vec3 colour = albedo.rgb * tint * edge_shade(depth);
  vec3 to_light = normalize(light_at - at), to_eye = normalize(eye - at);
  // The ground has no vertices near enough to light it by.
  float facing = per_vertex && look_f.x < 4.5 ? diffuse : max(dot(normal, to_light), 0.0);
  float lit = with_shadow && facing > 0.0 ? lit_part() : 1.0;
  colour *= ambient(to_light) + kSun * (facing * lit);
  if (with_specular && facing > 0.0) {
    float shine = max(dot(normal, normalize(to_light + to_eye)), 0.0);
    shine *= shine;
    shine *= shine;
    shine *= shine;
    shine *= shine;
    colour += kSun * (albedo.a * lit * (shine * shine) * 0.85);  // its 32nd power
  }
  float distance = length(at - eye);
  colour = mix(colour, horizon, smoothstep(fog_start, fog_start * 4.0, distance));
  float motion_mask = clamp((length(rate) - 0.10) * 1.5, 0.0, 0.9);
  finish(colour, depth_mask(depth) + motion_mask);
}
)";

inline const char* const kBackgroundFragments = R"(
uniform vec3 right, up, forward;   // right and up times the tangents of half the angle of view
uniform vec2 pixels;
uniform vec3 zenith;
void main() {
  vec2 place = gl_FragCoord.xy / pixels * 2.0 - 1.0;
  vec3 gaze = normalize(forward + right * place.x + up * place.y);
  finish(mix(horizon, zenith, smoothstep(0.0, 0.55, abs(gaze.z))), depth_mask(1e9));
}
)";

}  // namespace tumble::render
