// A corner of a puck's way, at rest on the board: its light is on its way as the cloth's is.
#version 150
in vec2 place_m;
in vec3 way;                  // metres from the middle; board time there; speed
uniform mat4 clipFromDrawn;
uniform mat4 drawnFromBoard;  // displacements (c t, x, y, z)
uniform vec3 eyeOnBoard_m;
uniform float above_m;        // the cloth
out vec3 wayHere;

void main() {
  vec3 fromEye = vec3(place_m, above_m) - eyeOnBoard_m;
  vec3 drawn = (drawnFromBoard * vec4(-length(fromEye), fromEye)).yzw;
  gl_Position = clipFromDrawn * vec4(drawn * 0.998, 1.0);  // before the cloth
  wayHere = way;
}
