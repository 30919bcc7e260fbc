// Covers a pixel as far as the letter does.
#version 150
in vec2 place;
in vec4 colourHere;
uniform sampler2D letters;
out vec4 colour;

void main() { colour = vec4(colourHere.rgb, colourHere.a * texture(letters, place).r); }
