// One triangle over the whole picture, behind everything.

uniform vec3 forward;
uniform vec3 right;
uniform vec3 up;

out vec3 direction;

void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  direction = forward + right * corner.x + up * corner.y;
  gl_Position = vec4(corner, 1.0, 1.0);
}
