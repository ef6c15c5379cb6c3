// A line as a thin rectangle that faces the eye: drivers need not know lines wider than one pixel.

layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 color;

uniform mat4 matrix;
uniform vec2 half_width;  // in clip units at w = 1

out vec4 line_color;

// Both ends before the eye, else their directions on screen would be wrong.
vec4 in_front(vec4 end, vec4 other) {
  const float near = 0.01;
  return end.w >= near ? end : mix(end, other, clamp((near - end.w) / (other.w - end.w), 0.0, 1.0));
}

void main() {
  vec4 a = matrix * vec4(from, 1.0);
  vec4 b = matrix * vec4(to, 1.0);
  if (max(a.w, b.w) < 0.01) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  vec4 first = in_front(a, b);
  vec4 last = in_front(b, a);
  vec2 along = (last.xy / last.w - first.xy / first.w) / half_width;
  float size = length(along);
  vec2 across = size > 0.0 ? vec2(-along.y, along.x) / size : vec2(1.0, 0.0);
  vec4 end = gl_VertexID < 2 ? first : last;
  float side = gl_VertexID % 2 == 0 ? -1.0 : 1.0;
  gl_Position = end + vec4(across * half_width * side * end.w, -0.0005 * end.w, 0.0);  // just before what it lies on
  line_color = color;
}
