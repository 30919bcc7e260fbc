// A soft puck: its colour with dark lines printed on its matter, so that strain can be seen: five rings and
// twelve spokes on a disc, squares on a rectangle. surface: radius of a disc, or 0; from line to line in
// metres; 0 on the faces and 1 on the side. Or its strain or heat as a colour, with the same lines.
in float told;
uniform int telling;  // 0: nothing, 1: strain, 2: heat

/// The size of this pixel across lines of equal x, in x's unit.
float across(float x) { return max(length(vec2(dFdx(x), dFdy(x))), 1e-6); }

/// What two sorts of lines cover of a pixel.
float either(float a, float b) { return a + b - a * b; }

/// How much of a pixel a line covers whose middle is `off_m` away; the pixel is `pixel_m` across it.
float inLine(float off_m, float pixel_m) {
  return edge((0.075 * surface.y - off_m) / pixel_m) * min(1.0, 0.15 * surface.y / pixel_m);
}

/// Of lines at the whole multiples of their distance.
float inLines(float x_m) {
  return inLine(abs(fract(x_m / surface.y - 0.5) - 0.5) * surface.y, across(x_m));
}

float printed() {
  bool onSide = surface.z > 0.5;
  if (surface.x <= 0.0) {
    // On a side one of the two does not change and would be a line all over it.
    vec2 pixels_m = fwidth(place.xy);
    if (onSide) return pixels_m.x > pixels_m.y ? inLines(place.x) : inLines(place.y);
    return either(inLines(place.x), inLines(place.y));
  }
  float radius_m = length(place.xy);
  vec2 once = place.xy / max(radius_m, 1e-6);
  vec2 twice = vec2(once.x * once.x - once.y * once.y, 2.0 * once.x * once.y);
  vec2 thrice = vec2(twice.x * once.x - twice.y * once.y, twice.x * once.y + twice.y * once.x);
  float beside_m = thrice.x * thrice.y * radius_m / 3.0;  // R sin 6φ/6: it vanishes at the spokes
  float spoke = inLine(abs(beside_m), across(beside_m));
  return onSide ? spoke : either(spoke, inLines(radius_m));
}

vec3 toldColour() {
  float share = 1.0 - exp(-abs(told) / 0.2);
  if (telling == 2) {
    vec3 warm = mix(vec3(0.05, 0.05, 0.07), vec3(0.9, 0.08, 0.02), min(2.0 * share, 1.0));
    return mix(warm, vec3(1.0, 0.85, 0.25), max(2.0 * share - 1.0, 0.0));
  }
  return mix(vec3(0.45), told < 0.0 ? vec3(0.02, 0.1, 0.9) : vec3(0.9, 0.06, 0.02), share);
}

Painted paint() {
  vec3 ground = telling > 0 ? toldColour() : colour;
  return Painted(mix(ground, 0.06 * ground, printed()), vec3(0.0), 1.0);
}
