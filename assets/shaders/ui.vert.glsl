layout(location = 0) in vec2 position;  // pixels from the top left
layout(location = 1) in vec2 picture_place;
layout(location = 2) in vec4 color;
layout(location = 3) in vec4 panel;     // its middle and half its size, pixels
layout(location = 4) in float radius;   // pixels

uniform vec2 picture_size;

out vec2 place;
out vec2 from_middle;
out vec4 tint;
flat out vec2 half_size;
flat out float corner_radius;

void main() {
  place = picture_place;
  from_middle = position - panel.xy;
  tint = color;
  half_size = panel.zw;
  corner_radius = radius;
  gl_Position = vec4(position.x / picture_size.x * 2.0 - 1.0, 1.0 - position.y / picture_size.y * 2.0, 0.0, 1.0);
}
