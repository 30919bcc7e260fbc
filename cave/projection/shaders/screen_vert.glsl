// A corner of the screen's triangles: its place in the window, and, still to be divided, in the flat wall's
// picture.
#version 150
uniform mat4 clipFromRoom;  // of the flat wall, for the eye
uniform vec2 size_px;       // of the flat wall's picture
uniform vec2 window_px;
in vec2 inWindow;  // 0 … 1 from the lower left
in vec3 inRoom_m;
in vec3 across_m, upwards_m;  // change of the place in the room over the window
out vec3 weightedPlace;       // in the picture, times its weight, and the weight
out vec2 cubic;

void main() {
  vec4 clip = clipFromRoom * vec4(inRoom_m, 1.0);
  weightedPlace = vec3(0.5 * clip.xy + 0.5 * clip.w, clip.w);
  gl_Position = vec4(inWindow * 2.0 - 1.0, 0.0, 1.0);
  // Where a pixel shows more than 1.25 texels the cubic filter would raise the contrast of fine stripes.
  vec4 across = clipFromRoom * vec4(across_m, 0.0), upwards = clipFromRoom * vec4(upwards_m, 0.0);
  vec2 at = clip.xy / clip.w, texels = 0.5 * size_px / clip.w;
  vec2 acrossPixel = texels * (across.xy - at * across.w) / window_px.x;
  vec2 upPixel = texels * (upwards.xy - at * upwards.w) / window_px.y;
  vec2 shown = sqrt(acrossPixel * acrossPixel + upPixel * upPixel);
  cubic = 1.0 - clamp(2.0 * (shown - 1.25), 0.0, 0.6);
}
