// The grid that warns of a wall, around the points of it to which head and hand are nearest.
#version 150
uniform vec2 size_m;       // of the wall
uniform vec3 warnings[2];  // from the wall's lower left (m); how strong
uniform float step_m;      // between lines
uniform float halfLine_m;
uniform float reach_m;  // around those points
in vec2 place;
out vec4 colour;

const vec3 amber = vec3(1.0, 0.62, 0.05);

void main() {
  vec2 at_m = place * size_m;
  vec2 pixel_m = fwidth(at_m);
  vec2 off_m = abs(at_m - round(at_m / step_m) * step_m);
  vec2 covered = clamp((max(vec2(halfLine_m), 0.6 * pixel_m) - off_m) / pixel_m + 0.5, 0.0, 1.0);
  float line = max(covered.x, covered.y);
  float strength = 0.0;
  for (int i = 0; i < 2; ++i) {
    float far = smoothstep(0.5 * reach_m, reach_m, distance(at_m, warnings[i].xy));
    strength = max(strength, warnings[i].z * (1.0 - far));
  }
  // The line over the picture, which is dimmed around it, so that it shows on white, too.
  float lit = 0.9 * line * strength;
  float covers = 1.0 - (1.0 - 0.3 * strength) * (1.0 - lit);
  colour = vec4(amber * lit / max(covers, 1e-4), covers);
}
