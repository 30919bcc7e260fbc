// The board as it was written: sRGB, times how much it covers.
#version 150
uniform sampler2D written;
in vec2 place;
out vec4 colour;

void main() { colour = texture(written, place); }
