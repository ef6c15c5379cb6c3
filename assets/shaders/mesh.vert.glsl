// Meshes, many alike at once.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 row0;
layout(location = 3) in vec4 row1;
layout(location = 4) in vec4 row2;
layout(location = 5) in vec4 color;
layout(location = 6) in vec4 material;
layout(location = 7) in vec4 glow;
layout(location = 8) in vec2 uv;

uniform mat4 matrix;

out vec3 place;
out vec3 facing;
flat out vec4 surface_color;
flat out vec2 surface_material;
flat out vec3 surface_glow;
#ifdef TEXTURE
out vec2 once_place;           // once over each face
out vec3 repeat_place;         // in repeats from the mesh's middle
out vec3 own_normal;           // in the mesh's own space
flat out float repeats;        // 0: once over each face
#endif

void main() {
  vec4 p = vec4(position, 1.0);
  place = vec3(dot(row0, p), dot(row1, p), dot(row2, p));
  // The rows of the matrix of cofactors: turns normals rightly whatever the scale.
  facing = vec3(dot(cross(row1.xyz, row2.xyz), normal), dot(cross(row2.xyz, row0.xyz), normal),
                dot(cross(row0.xyz, row1.xyz), normal));
  surface_color = color;
  surface_material = material.xy;
  surface_glow = glow.rgb;
#ifdef TEXTURE
  vec3 scale = sqrt(row0.xyz * row0.xyz + row1.xyz * row1.xyz + row2.xyz * row2.xyz);
  once_place = uv;
  repeats = material.w;
  repeat_place = position * scale / max(material.w, 1e-6);
  own_normal = normal;
#endif
  gl_Position = matrix * vec4(place, 1.0);
}
