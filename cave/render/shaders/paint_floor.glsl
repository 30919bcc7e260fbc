// Tiles of half a metre, light and dark.
Painted paint() {
  vec2 at = place.xy * 2.0;
  float grout = max(lines(at.x, 0.016), lines(at.y, 0.016));
  // Light and dark in turn: parity of two half-wide pulse trains.
  float darkX = lines(0.5 * at.x - 0.25, 0.5);
  float darkY = lines(0.5 * at.y - 0.25, 0.5);
  float dark = darkX + darkY - 2.0 * darkX * darkY;
  vec3 tile = mix(colour, colour * 0.55, dark);
  return Painted(mix(tile, vec3(0.10), grout), vec3(0.0), 1.0);
}
