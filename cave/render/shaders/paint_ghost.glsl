// A body at a moment: no light, a cage of stripes through which one looks. Stripes one way for the board's moment,
// CROSSED for the head's, so that they can be told apart without colours. What is between keeps a breath of the body's
// own colour.
in vec3 fromEye_m;
uniform vec3 ghostColour;  // linear
uniform float hatch_m;     // from stripe to stripe

Painted paint() {
  float cage = lines((place.x + place.y + place.z) / hatch_m, 0.45);
  if (CROSSED) cage = max(cage, lines((place.x - place.y - place.z) / hatch_m, 0.45));
  // Seen along its surface: the outline.
  vec3 facet = cross(dFdx(fromEye_m), dFdy(fromEye_m));
  float facing = abs(dot(normalize(facet), normalize(fromEye_m)));
  cage = max(cage, 1.0 - smoothstep(0.05, 0.2, facing));
  return Painted(vec3(0.0), mix(colour, ghostColour, 0.25 + 0.75 * cage), mix(0.3, 0.95, cage));
}
