// Packs the two pictures of a wall. Pictures are sRGB encoded and are passed on as they are.
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
  bool toRight = false;
  vec2 at = place;
  if (mode == 1) {  // side by side
    toRight = place.x >= 0.5;
    at.x = fract(place.x * 2.0);
  } else if (mode == 2) {  // left on top
    toRight = place.y < 0.5;
    at.y = fract(place.y * 2.0);
  } else if (mode == 4) {  // rows
    toRight = (row & 1) == 1;
  } else if (mode == 5) {  // checkerboard
    toRight = ((row + column) & 1) == 1;
  }
  vec3 seenLeft = texture(leftPicture, at).rgb;
  vec3 seenRight = texture(rightPicture, at).rgb;
  vec3 shown = toRight ? seenRight : seenLeft;
  if (mode == 3) shown = anaglyph(seenLeft, seenRight);
  if (mode == 6) shown = anaglyph(seenLeft, vec3(luminance(seenRight)));
  colour = vec4(shown, 1.0);
}
