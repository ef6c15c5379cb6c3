// A soft disc or a picture. What glows adds its light, what does not hides what is behind it.

in vec2 corner;
in vec3 place;
flat in vec4 tint;
flat in vec2 own_light;

uniform sampler2D picture;
uniform float exposure;
uniform bool is_picture;
uniform vec3 light_around;   // on something that has no sides

out vec4 pixel;              // colours times opacity

void main() {
  float squared = dot(corner, corner);
  float soft = clamp(1.0 - squared, 0.0, 1.0);
  soft = soft * soft * (3.0 - 2.0 * soft);
  vec4 shape = vec4(mix(soft, soft * soft, min(own_light.y * 2.5, 1.0)));  // light falls off faster than smoke
  if (is_picture) shape = texture(picture, vec2(0.5, 0.5) + vec2(0.5, -0.5) * corner);
  vec3 painted = shape.rgb / max(shape.a, 1e-4);
  float opacity = shape.a * tint.a;
  float away = length(place);
  vec3 light = tint.rgb * painted * max(light_around, vec3(own_light.x * exposure));
  vec3 color = shown(through_air(light, place / max(away, 1e-6), away));
  pixel = vec4(color * opacity, opacity * (1.0 - own_light.y));
}
