// Tiles of half a metre, light and dark.
Painted paint() {
  vec2 at = place.xy * 2.0;
  vec2 footprint = footprintOf(at);
  vec2 perTile_px = 1.0 / footprint;
  vec2 grouts = lines(at, 0.016, footprint, perTile_px);
  // Light and dark in turn: the product of two waves of +1 and -1, each filtered by the box of a pixel from
  // its integral.
  vec2 from = 0.5 * (at - 0.5 * footprint), to = from + 0.5 * footprint;
  vec2 wave = 2.0 * (abs(fract(from) - 0.5) - abs(fract(to) - 0.5)) * perTile_px;
  float shade = 0.775 + 0.225 * wave.x * wave.y;
  return Painted(mix(colour * shade, vec3(0.10), max(grouts.x, grouts.y)), vec3(0.0), 1.0);
}
