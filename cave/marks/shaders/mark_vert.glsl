// A corner of a mark, from the eye.
#version 150
in vec3 drawn_m;
in vec4 ink;
in vec2 on;
in float what;
in vec4 words;
in vec4 plate;  // its middle, and half its diagonal
uniform mat4 clipFromDrawn;
uniform float cutAt;  // the border that would cut plates: 1 right, −1 left, 0 none
out vec4 colourHere;
out vec2 place;
flat out float style;
flat out vec4 text;

bool leftOut() {
  if (what < 0.5 || cutAt == 0.0) return false;
  vec4 middle = clipFromDrawn * vec4(plate.xyz, 1.0);
  vec3 across = vec3(clipFromDrawn[0].x, clipFromDrawn[1].x, clipFromDrawn[2].x);
  return cutAt * middle.x + plate.w * length(across) > middle.w;
}

void main() {
  gl_Position = clipFromDrawn * vec4(drawn_m * 0.998, 1.0);  // before what it lies on
  if (leftOut()) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);  // outside the clip volume
  colourHere = ink;
  place = on;
  style = what;
  text = words;
}
