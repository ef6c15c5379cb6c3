in vec2 glyph_place;
in vec4 glyph_color;

uniform sampler2D atlas;

out vec4 pixel;

void main() { pixel = vec4(glyph_color.rgb, glyph_color.a * texture(atlas, glyph_place).r); }
