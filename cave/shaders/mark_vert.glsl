// A corner of a mark, from the eye.
#version 150
in vec3 drawn_m;
in vec4 ink;
in vec2 on;
in vec2 what;
uniform mat4 clipFromDrawn;
out vec4 colourHere;
out vec2 place;
flat out vec2 style;

void main() {
  gl_Position = clipFromDrawn * vec4(drawn_m * 0.998, 1.0);  // before what it lies on
  colourHere = ink;
  place = on;
  style = what;
}
