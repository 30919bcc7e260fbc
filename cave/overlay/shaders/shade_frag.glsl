// Darkens what lies outside a cone around the direction of sight, and the whole picture.
#version 150
uniform vec3 corner_m;   // the wall's lower left corner from the eye, in the room
uniform vec3 across_m;   // its lower edge
uniform vec3 upwards_m;  // its left edge
uniform vec3 sight;      // unit vector
uniform float clear_rad;
uniform float soft_rad;
uniform float darkest;
uniform float black;  // of the whole picture
in vec2 place;
out vec4 colour;

void main() {
  vec3 to_m = corner_m + place.x * across_m + place.y * upwards_m;
  float off_rad = acos(clamp(dot(normalize(to_m), sight), -1.0, 1.0));
  float shade = darkest * smoothstep(clear_rad, clear_rad + soft_rad, off_rad);
  colour = vec4(0.0, 0.0, 0.0, max(shade, black));
}
