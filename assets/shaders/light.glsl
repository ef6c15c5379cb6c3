// Shared by every shader that makes colours: all light is linear until shown() turns it into a pixel.

uniform vec3 sky_top;
uniform vec3 sky_horizon;
uniform vec3 ground_color;
uniform vec3 to_sun;      // unit
uniform vec3 sun_light;   // black where there is no sun

// The sky's light from a direction, the ground's from below the horizon.
vec3 sky(vec3 direction) {
  float h = direction.y;
  vec3 above = mix(sky_horizon, sky_top, sqrt(clamp(h, 0.0, 1.0)));
  vec3 below = mix(mix(sky_horizon, ground_color, 0.35), ground_color, smoothstep(0.0, 0.5, -h));
  return mix(above, below, smoothstep(-0.002, 0.004, -h));
}

// Straight up to 0.8, then a soft shoulder: colours stay as their authors wrote them, and highlights do not clip.
vec3 shoulder(vec3 light) {
  const float start = 0.8;
  vec3 over = max(light - start, 0.0) / (1.0 - start);
  return min(light, start) + (1.0 - start) * over / (1.0 + over);
}

vec3 shown(vec3 light) {
  return to_srgb(shoulder(max(light, 0.0)));
}
