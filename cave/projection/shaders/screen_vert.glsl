// A corner of the screen's triangles: its place in the window, and, still to be divided, in the flat wall's
// picture.
#version 150
uniform mat4 clipFromRoom;  // of the flat wall, for the eye
in vec2 inWindow;           // 0 … 1 from the lower left
in vec3 inRoom_m;
out vec3 weightedPlace;  // in the picture, times its weight, and the weight
void main() {
  vec4 clip = clipFromRoom * vec4(inRoom_m, 1.0);
  weightedPlace = vec3(0.5 * clip.xy + 0.5 * clip.w, clip.w);
  gl_Position = vec4(inWindow * 2.0 - 1.0, 0.0, 1.0);
}
