// Letters and panels take coverage from the atlas, images their colours from a picture.

in vec2 place;
in vec2 from_middle;
in vec4 tint;
flat in vec2 half_size;
flat in float corner_radius;

uniform sampler2D picture;
uniform bool is_image;

out vec4 pixel;

// The share of a pixel that a rounded rectangle covers: by its distance to the rim, over one pixel.
float covered() {
  if (corner_radius <= 0.0) return 1.0;
  vec2 beyond = max(abs(from_middle) - (half_size - corner_radius), 0.0);
  return clamp(0.5 + corner_radius - length(beyond), 0.0, 1.0);
}

void main() {
  vec4 found = texture(picture, place);
  vec4 color = is_image ? vec4(to_srgb(found.rgb / max(found.a, 1e-4)), found.a) : vec4(1.0, 1.0, 1.0, found.r);
  pixel = vec4(color.rgb * tint.rgb, color.a * tint.a * covered());
}
