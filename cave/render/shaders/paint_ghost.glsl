// Paints a ghost, a body at one moment: an unlit cage of stripes that one can look through. The stripes run
// one way for the board's now and both ways (CROSSED) for the head's now, so that the two can be told apart
// without colours. Between the stripes a trace of the body's own colour remains.
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
