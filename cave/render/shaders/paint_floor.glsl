// Tiles of half a metre, light and dark.
Painted paint() {
  vec2 at = place.xy * 2.0;
  vec2 footprint = footprintOf(at);
  vec2 grouts = lines(at, 0.016, footprint);
  // Light and dark in turn: the product of two waves of +1 and -1, each filtered by the box of a pixel from its integral.
  vec2 from = 0.5 * (at - 0.5 * footprint), to = from + 0.5 * footprint;
  vec2 wave = 2.0 * (abs(fract(from) - 0.5) - abs(fract(to) - 0.5)) / footprint;
  float dark = 0.5 - 0.5 * wave.x * wave.y;
  vec3 tile = mix(colour, colour * 0.55, dark);
  return Painted(mix(tile, vec3(0.10), max(grouts.x, grouts.y)), vec3(0.0), 1.0);
}
