// A thin sheet of glass adds as much light seen from any side. Most pixels of glass show sheets.
#version 150
uniform vec3 colour;
uniform vec4 look;  // shine (cave/sculpture/glass_drawer.h)
out vec4 light;

void main() { light = vec4(look.y * colour, 1.0); }
