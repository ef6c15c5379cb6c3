// One sun with shadow, lamps, light from sky and ground, and a sheen: enough for a grey box to look like a thing.

in vec3 place;
in vec3 facing;
flat in vec4 surface_color;
flat in vec2 surface_material;
flat in vec3 surface_glow;

uniform vec3 light_above;       // from all around, on what faces up and on what faces down
uniform vec3 light_below;
uniform float exposure;

out vec4 pixel;

float pow2(float x) { return x * x; }

// GGX with the visibility of Karis's fit for small devices (SIGGRAPH 2015, "Optimizing PBR for Mobile"), times pi.
float shine(vec3 normal, vec3 to_eye, vec3 to_light, float roughness) {
  vec3 middle = normalize(to_light + to_eye);
  float a2 = roughness * roughness * roughness * roughness;
  float d = pow2(max(dot(normal, middle), 0.0)) * (a2 - 1.0) + 1.0;
  return a2 / (4.0 * max(0.1, pow2(dot(to_light, middle))) * (roughness + 0.5) * d * d);
}

#ifdef SHADOW
uniform sampler2DShadow shadow_map;   // SHADOW maps side by side, the nearer first
uniform mat4 shadow_matrix;           // to the map's 0..1 and depth
uniform float shadow_texel;           // m in the world
#if SHADOW > 1
uniform mat4 far_shadow_matrix;
uniform float far_shadow_texel;
#endif
uniform vec2 shadow_step;             // one texel in the texture's own units
uniform float shadow_distance;        // m

// How much of the sun is seen, 0..1: SHADOW_TAPS x SHADOW_TAPS looks, each of them smooth over a texel.
float sun_seen(vec3 normal, float toward_sun, float away) {
  // Off the surface by as much as the filter reaches, more where the light grazes: no stripes on lit faces, and no gap
  // below standing things, since the way is along the normal.
  float off = 1.0 + 2.0 * sqrt(1.0 - toward_sun * toward_sun);
  vec3 p = (shadow_matrix * vec4(place + normal * (off * shadow_texel), 1.0)).xyz;
  bool outside = any(lessThan(p, vec3(0.004))) || any(greaterThan(p, vec3(0.996)));
#if SHADOW > 1
  vec3 q = (far_shadow_matrix * vec4(place + normal * (off * far_shadow_texel), 1.0)).xyz;
  p = outside ? q + vec3(1.0, 0.0, 0.0) : p;
  outside = outside && (any(lessThan(q, vec3(0.0))) || any(greaterThan(q, vec3(1.0))));
  p.x *= 0.5;
#endif
  float lit = 0.0;
  const float start = 0.5 * float(SHADOW_TAPS - 1);
  for (int i = 0; i < SHADOW_TAPS * SHADOW_TAPS; ++i) {
    vec2 tap = vec2(float(i % SHADOW_TAPS), float(i / SHADOW_TAPS)) - start;
    lit += texture(shadow_map, vec3(p.xy + tap * 1.5 * shadow_step, p.z));
  }
  lit *= 1.0 / float(SHADOW_TAPS * SHADOW_TAPS);
  float fade = outside ? 1.0 : smoothstep(0.8, 1.0, away / shadow_distance);
  return mix(lit, 1.0, fade);
}
#endif

#ifdef LAMPS
uniform int lamp_count;
uniform vec4 lamp_place[LAMPS];   // and 1 / range
uniform vec4 lamp_light[LAMPS];   // and 1 / the width of a spot's soft rim, in cosines
uniform vec4 lamp_axis[LAMPS];    // and the cosine at which a spot ends

// What one lamp gives before the surface turns it away: inverse-square with a window that ends it at its range
// (Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013).
vec3 lamp(int i, out vec3 to_lamp) {
  vec3 way = lamp_place[i].xyz - place;
  float squared = dot(way, way);
  to_lamp = way * inversesqrt(max(squared, 1e-8));
  float share = squared * pow2(lamp_place[i].w);
  float window = pow2(clamp(1.0 - share * share, 0.0, 1.0));
  float cone = clamp((dot(-to_lamp, lamp_axis[i].xyz) - lamp_axis[i].w) * lamp_light[i].w, 0.0, 1.0);
  return lamp_light[i].rgb * (window * cone * cone * (3.0 - 2.0 * cone) / (16.0 * share + 0.0625));
}
#endif

#ifdef TEXTURE
in vec2 once_place;
in vec3 repeat_place;
in vec3 own_normal;
flat in float repeats;

uniform sampler2D picture;

// Laid on from the side that the surface faces most, upright where there is an up.
vec2 box_place() {
  vec3 side = abs(own_normal);
  vec3 p = repeat_place;
  if (side.y >= max(side.x, side.z)) return vec2(p.x, p.z * sign(own_normal.y));
  if (side.z >= side.x) return vec2(p.x * sign(own_normal.z), -p.y);
  return vec2(-p.z * sign(own_normal.x), -p.y);
}
#endif

void main() {
  vec4 base = surface_color;
  vec3 own_light = surface_glow * exposure;
#ifdef TEXTURE
  vec4 found = texture(picture, repeats > 0.0 ? box_place() : once_place);
#ifdef HOLES
  if (found.a < 0.5) discard;
#endif
  vec3 painted = found.rgb / max(found.a, 1e-4);
  base.rgb *= painted;
  own_light *= painted;
#ifdef BLEND
  base.a *= found.a;
#endif
#endif
  float away = length(place);
  vec3 to_eye = place * (-1.0 / max(away, 1e-6));
  vec3 normal = normalize(gl_FrontFacing ? facing : -facing);
  float roughness = clamp(surface_material.x, 0.05, 1.0);
  float metalness = surface_material.y;
  vec3 matt = base.rgb * (1.0 - metalness);
  vec3 mirror = mix(vec3(0.04), base.rgb, metalness);
  float edge = 1.0 - max(dot(normal, to_eye), 0.0);
  float grazing = edge * edge * edge * edge * edge;
  vec3 fresnel = mirror + (max(vec3(1.0 - roughness), mirror) - mirror) * grazing;

  float toward_sun = dot(normal, to_sun);
  // A little more from the sun's side: faces in the shade then differ too.
  vec3 around = mix(light_below, light_above, 0.5 + 0.5 * normal.y) * (0.9 + 0.1 * toward_sun);
  // Half as colourful as the sky itself: there is more around than the sky, and gold in the blue alone would be green.
  vec3 opposite = sky(reflect(-to_eye, normal));
  opposite = mix(vec3(dot(opposite, vec3(0.2126, 0.7152, 0.0722))), opposite, 0.5);
  vec3 mirrored = mix(opposite, around, roughness);
  vec3 light = matt * around + fresnel * mirrored;

#ifdef SHADOW
  float seen = toward_sun > 0.0 ? sun_seen(normal, toward_sun, away) : 0.0;
#else
  const float seen = 1.0;
#endif
  light += sun_light * (max(toward_sun, 0.0) * seen) * (matt + fresnel * shine(normal, to_eye, to_sun, roughness));
#ifdef LAMPS
  for (int i = 0; i < lamp_count; ++i) {
    vec3 to_lamp;
    vec3 given = lamp(i, to_lamp) * max(dot(normal, to_lamp), 0.0);
    light += given * (matt + fresnel * shine(normal, to_eye, to_lamp, roughness));
  }
#endif
  light += own_light;
  vec3 color = shown(through_air(light, -to_eye, away));
  pixel = vec4(color, base.a);
}
