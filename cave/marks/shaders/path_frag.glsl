// A puck's way: a line with a dot every tenth of a second and a larger one every second. Full as far as the
// puck is seen to have come, fading behind; then dashed as far as the way is known.
#version 150
in vec3 wayHere;
uniform vec3 colour;    // sRGB
uniform vec2 times_s;   // at which the puck is seen; up to which its way is known
uniform float past_s;   // how long it is drawn behind the puck
out vec4 ink;

float covered(float outside, float footprint) { return clamp(0.5 - outside / footprint, 0.0, 1.0); }

/// A dot of this radius at the nearest whole multiple of `every`.
float dotAt(float every, float radius_m, float footprint) {
  float off_m = (wayHere.y - every * round(wayHere.y / every)) * wayHere.z;
  return covered(length(vec2(off_m, wayHere.x)) - radius_m, footprint);
}

void main() {
  float footprint = max(fwidth(wayHere.x), 1e-5);
  float perPixel_s = max(fwidth(wayHere.y), 1e-6);
  float t = wayHere.y;
  float line = covered(abs(wayHere.x) - 0.0038, footprint);
  float dots = max(dotAt(0.1, 0.0075, footprint), dotAt(1.0, 0.0125, footprint));
  float toCome = clamp((t - times_s.x) / perPixel_s + 0.5, 0.0, 1.0);
  // Dashes between the dots: of 50 ms, with gaps of 50 ms.
  float dash = abs(fract(t / 0.1) - 0.5) < 0.25 ? 1.0 : 0.0;
  float ahead = max(0.7 * line * dash, 0.55 * dots);
  float behind = max(line, dots) * clamp(1.0 - (times_s.x - t) / past_s, 0.0, 1.0);
  float known = clamp((times_s.y - t) / perPixel_s + 0.5, 0.0, 1.0);
  ink = vec4(mix(colour, vec3(1.0), 0.3), 0.9 * mix(behind, ahead, toCome) * known);
}
