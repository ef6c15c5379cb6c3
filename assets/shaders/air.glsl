// Shared by every shader that makes colours: sky, fog and the way from light to pixels. All light is linear, and times
// the exposure already, until shown() turns it into a pixel.

uniform vec3 sky_top;
uniform vec3 sky_horizon;
uniform vec3 ground_color;
uniform vec3 to_sun;        // unit
uniform vec3 sun_light;     // black where there is no sun
uniform vec3 fog_color;
uniform vec3 fog;           // where it begins, m; 1 / its depth, 1/m; 1 where it looks like the sky behind
uniform float haze;         // share of far things that the air hides anyway, 1/m^2

// The sky's light from a direction, the ground's from below the horizon.
vec3 sky(vec3 direction) {
  float low = 1.0 - clamp(direction.y, 0.0, 1.0);
  float deep = clamp(-direction.y * 1.8, 0.0, 1.0);
  vec3 above = mix(sky_top, sky_horizon, low * low * low * low);
  return mix(above, ground_color, deep * (2.0 - deep));
}

// Light that comes from a thing at some distance, seen through the air. `toward` is the unit vector to it.
vec3 through_air(vec3 light, vec3 toward, float away) {
  float far = away * away * haze;
  float share = far / (1.0 + far);
#ifdef FOG
  float depth = clamp((away - fog.x) * fog.y, 0.0, 1.0);
  share = max(share, depth * depth * (3.0 - 2.0 * depth));
  return mix(light, mix(fog_color, sky(toward), fog.z), share);
#else
  return mix(light, sky_horizon, share);
#endif
}

// Straight up to 0.76, then a soft shoulder that keeps the hue and goes towards white only far beyond it: the curve of
// the Khronos PBR Neutral tone mapper (2024) without its toe. Colours stay as their authors wrote them.
vec3 tone(vec3 light) {
  const float start = 0.76;
  const float room = 1.0 - start;
  float peak = max(max(light.r, light.g), max(light.b, start));
  float squeezed = 1.0 - room * room / (peak + room - start);
  float whitened = 1.0 - 1.0 / (0.15 * (peak - squeezed) + 1.0);
  return mix(light * (squeezed / peak), vec3(squeezed), whitened);
}

vec3 shown(vec3 light) { return to_srgb(tone(max(light, 0.0))); }
