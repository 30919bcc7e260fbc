// One triangle that covers the wall's picture, and all that its shade needs: what rests for the whole wall
// goes to the pixels as varyings, since llvmpipe reads a uniform for each pixel anew.
#version 150
uniform vec3 corner_m;   // the wall's lower left corner from the eye, in the room
uniform vec3 across_m;   // its lower edge
uniform vec3 upwards_m;  // its left edge
uniform vec3 sight;      // unit vector
uniform float clear_rad;
uniform float soft_rad;
uniform float darkest;
uniform float black;  // of the whole picture
out vec3 to_m;        // from the eye to the place on the wall
out float ahead_m;    // the part of it along the direction of sight
flat out vec4 cone;   // clear_rad, 1/soft_rad, darkest, black

void main() {
  vec2 place = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
  to_m = corner_m + place.x * across_m + place.y * upwards_m;
  ahead_m = dot(to_m, sight);
  cone = vec4(clear_rad, 1.0 / soft_rad, darkest, black);
  gl_Position = vec4(place * 2.0 - 1.0, 0.0, 1.0);
}
