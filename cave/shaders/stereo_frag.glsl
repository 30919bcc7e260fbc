// Packs the two pictures of a wall. Pictures are sRGB encoded and are passed on as they are.
#version 150
uniform sampler2D leftPicture;
uniform sampler2D rightPicture;
uniform int mode;           // as in stereo.cpp
uniform float windowHeight_px;
in vec2 place;
out vec4 colour;

// Red–cyan with the least rivalry: red from the left eye's luminance (Rec. 709), the rest from the right.
vec3 anaglyph(vec3 left, vec3 right) { return vec3(dot(left, vec3(0.2126, 0.7152, 0.0722)), right.gb); }

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
  colour = vec4(mode == 3 ? anaglyph(seenLeft, seenRight) : toRight ? seenRight : seenLeft, 1.0);
}
