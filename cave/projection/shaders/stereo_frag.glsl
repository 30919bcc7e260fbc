// Packs the two pictures of a wall where the eyes share its pixels. Pictures are sRGB encoded and are passed
// on as they are.
#version 150
uniform sampler2D leftPicture;
uniform sampler2D rightPicture;
uniform int mode;           // as in stereo.cpp
uniform float windowHeight_px;
in vec2 place;
out vec4 colour;

float luminance(vec3 colour) { return dot(colour, vec3(0.2126, 0.7152, 0.0722)); }  // Rec. 709

// Red–cyan with the least rivalry: red from the left eye's luminance, the rest from the right.
vec3 anaglyph(vec3 left, vec3 right) { return vec3(luminance(left), right.gb); }

void main() {
  // The display's own row and column decide which eye's filter lies before a pixel.
  int row = int(windowHeight_px - gl_FragCoord.y);
  int column = int(gl_FragCoord.x);
  bool toRight = ((mode == 2 ? row : row + column) & 1) == 1;  // rows, or a checkerboard
  vec3 seenLeft = texture(leftPicture, place).rgb;
  vec3 seenRight = texture(rightPicture, place).rgb;
  vec3 shown = toRight ? seenRight : seenLeft;
  if (mode == 1) shown = anaglyph(seenLeft, seenRight);
  if (mode == 4) shown = anaglyph(seenLeft, vec3(luminance(seenRight)));
  colour = vec4(shown, 1.0);
}
