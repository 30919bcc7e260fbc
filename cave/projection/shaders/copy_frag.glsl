// Copies a picture as it is, alpha included: with an alpha of 1, Mesa 22.3's llvmpipe exchanges red and blue.
#version 150
uniform sampler2D picture;
in vec2 place;
out vec4 colour;
void main() { colour = texture(picture, place); }
