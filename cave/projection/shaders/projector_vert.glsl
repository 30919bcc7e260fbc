// Puts the picture where the projector's mesh says.
#version 150
uniform vec2 mirror;  // -1 along what is mirrored, else 1
in vec2 inWindow;     // 0 … 1 from the lower left
in vec2 inPicture;    // the same
out vec2 windowPlace;
out vec2 picturePlace;
void main() {
  windowPlace = inWindow;
  picturePlace = inPicture;
  gl_Position = vec4(mirror * (inWindow * 2.0 - 1.0), 0.0, 1.0);
}
