in vec3 direction;

out vec4 pixel;

void main() {
  vec3 d = normalize(direction);
  float near_sun = max(dot(d, to_sun), 0.0);
  float glow = near_sun * near_sun;
  for (int i = 0; i < 5; ++i) glow *= glow;  // to the power of 64, cheaper than pow
  vec3 sun = sun_light * (0.25 * glow + 4.0 * smoothstep(0.99965, 0.99985, near_sun)) * step(0.0, d.y);
  pixel = vec4(shown(sky(d) + sun), 1.0);
}
