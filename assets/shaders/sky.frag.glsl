in vec3 direction;

uniform float fog_height;   // of the fog above the horizon, in sines of the elevation; 0: none

out vec4 pixel;

void main() {
  vec3 d = normalize(direction);
  float near_sun = max(dot(d, to_sun), 0.0);
  float glow = near_sun * near_sun;
  glow *= glow;
  glow *= glow;                             // to the power of 8
  float halo = glow * glow * glow * glow;   // 32
  halo *= halo * halo * halo;               // 128
  float disc = smoothstep(0.9993, 0.9997, near_sun);
  float open = step(0.0, d.y) * step(0.0, to_sun.y);
  vec3 sun = sun_light * (0.10 * glow + 0.30 * halo * halo + 6.0 * disc) * open;
  vec3 light = sky(d) + sun;
  float fogged = fog_height > 0.0 ? 1.0 - smoothstep(0.0, fog_height, d.y) : 0.0;
  light = mix(light, fog_color, fogged);
  pixel = vec4(shown(light), 1.0);
}
