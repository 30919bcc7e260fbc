// A panel of words as it was written: sRGB, and how much it covers.
#version 150
uniform sampler2D words;
in vec2 place;
out vec4 colour;

void main() { colour = texture(words, place); }
