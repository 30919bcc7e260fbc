// The ground on which the room stands: a line every metre, fading with the distance.
#version 150
uniform float size_m;  // of the square that is drawn
in vec2 place;
out vec4 colour;

void main() {
  vec2 at_m = (place - 0.5) * size_m;
  vec2 pixel_m = fwidth(at_m);
  vec2 off_m = abs(at_m - round(at_m));
  vec2 covered = clamp((0.006 + 0.5 * pixel_m - off_m) / pixel_m + 0.5, 0.0, 1.0);
  float line = max(covered.x, covered.y);
  float near = 1.0 - smoothstep(0.1 * size_m, 0.5 * size_m, length(at_m));
  colour = vec4(mix(vec3(0.30, 0.34, 0.40), vec3(0.55, 0.62, 0.70), line), near * mix(0.55, 0.75, line));
}
