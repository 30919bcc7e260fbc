// The contact shadow of a puck. surface.x: 0 under its middle, 1 where the shadow ends.
Painted paint() {
  float s = clamp(1.0 - surface.x, 0.0, 1.0);
  return Painted(vec3(0.0), vec3(0.0), 0.75 * s * s);
}
