// Sprites that face the eye, many at once.

layout(location = 0) in vec4 particle;   // place in picture space, and half its size
layout(location = 1) in vec4 color;      // linear
layout(location = 2) in vec2 glow;       // and the share that is added to what is behind

uniform mat4 matrix;
uniform vec3 right;                      // of the picture, unit
uniform vec3 up;

out vec2 corner;
out vec3 place;
flat out vec4 tint;
flat out vec2 own_light;

void main() {
  corner = vec2(gl_VertexID % 2 == 0 ? -1.0 : 1.0, gl_VertexID < 2 ? -1.0 : 1.0);
  place = particle.xyz + (right * corner.x + up * corner.y) * particle.w;
  tint = color;
  own_light = glow;
  gl_Position = matrix * vec4(place, 1.0);
}
