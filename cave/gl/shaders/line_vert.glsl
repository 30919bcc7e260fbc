// A corner of a line's two triangles, already on the picture.
#version 150
in vec4 clip;
in vec2 corner_px;  // from the line's middle; half the line's width
in vec4 ink;
noperspective out vec2 across_px;
noperspective out vec4 colourHere;

void main() {
  gl_Position = clip;
  across_px = corner_px;
  colourHere = ink;
}
