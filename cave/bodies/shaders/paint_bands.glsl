// A rod in bands of ten centimetres. surface.x: metres along it.
Painted paint() {
  return Painted(mix(colour, colour * 0.12, lines(5.0 * surface.x - 0.25, 0.5)), vec3(0.0), 1.0);
}
