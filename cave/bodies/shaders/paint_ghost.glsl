// Paints a ghost, a body at one moment: clear glass of one colour, with an outline. Stripes in it run one
// way for the board's now and both ways (CROSSED) for the head's now, so that the two can be told apart
// without colours. A trace of the body's own colour remains.
in vec3 fromEye_m;
uniform vec3 ghostColour;  // linear
uniform float hatch_m;     // from stripe to stripe

Painted paint() {
  float cage = lines((place.x + place.y + place.z) / hatch_m, 0.45);
  if (CROSSED) cage = max(cage, lines((place.x - place.y - place.z) / hatch_m, 0.45));
  // Seen along its surface: the outline.
  vec3 facet = cross(dFdx(fromEye_m), dFdy(fromEye_m));
  float facing = abs(dot(normalize(facet), normalize(fromEye_m)));
  float outline = 1.0 - smoothstep(0.05, 0.2, facing);
  float cover = mix(mix(0.42, 0.75, cage), 0.95, outline);
  return Painted(vec3(0.0), mix(colour, ghostColour, 0.75), cover);
}
