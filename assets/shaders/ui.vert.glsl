layout(location = 0) in vec2 position;  // pixels from the top left
layout(location = 1) in vec2 atlas_place;
layout(location = 2) in vec4 color;

uniform vec2 picture_size;

out vec2 glyph_place;
out vec4 glyph_color;

void main() {
  glyph_place = atlas_place;
  glyph_color = color;
  gl_Position = vec4(position.x / picture_size.x * 2.0 - 1.0, 1.0 - position.y / picture_size.y * 2.0, 0.0, 1.0);
}
