// A corner of a letter's two triangles, already on the picture.
#version 150
in vec4 clip;
in vec2 on;  // the picture of letters, 0 … 1
in vec4 ink;
out vec2 place;
out vec4 colourHere;

void main() {
  gl_Position = clip;
  place = on;
  colourHere = ink;
}
