// One sun with shadow, light from sky and ground, and a sheen: enough for a grey box to look like a thing.

in vec3 place;
in vec3 facing;
flat in vec4 surface_color;
flat in vec4 surface_material;

uniform sampler2DShadow shadow_map;
uniform mat4 shadow_matrix;
uniform float shadow_texel;     // m in the world; 0 where there is no shadow map
uniform float shadow_pixel;     // the same in the map's own units
uniform float shadow_distance;  // m

out vec4 pixel;

float pow2(float x) { return x * x; }

// How much of the sun is seen, 0..1.
float sun_seen(vec3 normal, float toward_sun) {
  // Off the surface by as much as the filter reaches, more where the light grazes: no stripes on lit faces, and no gap
  // below standing things, since the way is along the normal.
  float away = shadow_texel * (1.0 + 2.0 * sqrt(1.0 - toward_sun * toward_sun));
  vec3 p = (shadow_matrix * vec4(place + normal * away, 1.0)).xyz * 0.5 + 0.5;
  if (any(lessThan(p, vec3(0.0))) || any(greaterThan(p, vec3(1.0)))) return 1.0;
  float r = 0.75 * shadow_pixel;
  float lit = texture(shadow_map, p + vec3(-r, -r, 0.0)) + texture(shadow_map, p + vec3(r, -r, 0.0)) +
              texture(shadow_map, p + vec3(-r, r, 0.0)) + texture(shadow_map, p + vec3(r, r, 0.0));
  float fade = smoothstep(0.8, 1.0, length(place) / shadow_distance);
  return mix(lit * 0.25, 1.0, fade);
}

// Light from all around, half as colourful as sky and ground themselves.
vec3 ambient(vec3 normal) {
  vec3 light = mix(ground_color, mix(sky_horizon, sky_top, 0.5), 0.5 + 0.5 * normal.y);
  float grey = dot(light, vec3(0.2126, 0.7152, 0.0722));
  return mix(vec3(grey), light, 0.5) * (0.72 + 0.14 * normal.y);
}

// GGX with the visibility of Karis's fit for small devices (SIGGRAPH 2015, "Optimizing PBR for Mobile"), times pi.
float shine(vec3 normal, vec3 to_eye, float roughness) {
  vec3 middle = normalize(to_sun + to_eye);
  float a2 = roughness * roughness * roughness * roughness;
  float d = pow2(max(dot(normal, middle), 0.0)) * (a2 - 1.0) + 1.0;
  return a2 / (4.0 * max(0.1, pow2(dot(to_sun, middle))) * (roughness + 0.5) * d * d);
}

void main() {
  vec3 normal = normalize(facing);
  vec3 to_eye = normalize(-place);
  float roughness = clamp(surface_material.x, 0.05, 1.0);
  float metalness = surface_material.y;
  vec3 matt = surface_color.rgb * (1.0 - metalness);
  vec3 mirror = mix(vec3(0.04), surface_color.rgb, metalness);
  float edge = 1.0 - max(dot(normal, to_eye), 0.0);
  float grazing = edge * edge * edge * edge * edge;
  vec3 fresnel = mirror + (max(vec3(1.0 - roughness), mirror) - mirror) * grazing;

  vec3 around = ambient(normal);
  vec3 mirrored = mix(sky(reflect(-to_eye, normal)), around, roughness);
  vec3 light = matt * around + fresnel * mirrored;

  float toward_sun = dot(normal, to_sun);
  if (toward_sun > 0.0) {
    float seen = shadow_texel > 0.0 ? sun_seen(normal, toward_sun) : 1.0;
    light += sun_light * toward_sun * seen * (matt + fresnel * shine(normal, to_eye, roughness));
  }
  light += surface_color.rgb * surface_material.z;

  // Far things fade into the horizon.
  float far = dot(place, place) * 2.2e-6;
  float haze = far / (1.0 + far);
  pixel = vec4(shown(mix(light, sky_horizon, haze)), surface_color.a);
}
