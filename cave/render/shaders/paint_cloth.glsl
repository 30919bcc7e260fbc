// Cloth with a faint 10 cm grid and the game's three spots. surface.xy: length and width of the board (metres).
Painted paint() {
  vec2 at = place.xy * 10.0;
  vec2 grid = lines(at, 0.03, footprintOf(at));
  vec3 green = colour * (1.0 - 0.30 * max(grid.x, grid.y));
  // Its nap, as long as a tuft is larger than a pixel.
  const float kTuft_m = 0.004;
  float tufts = 1.0 - footprintOf(place.x + place.y) / kTuft_m;
  if (tufts > 0.0) green *= 1.0 + 0.22 * tufts * (noise(vec2(place.x + place.y, 2.5 * (place.x - place.y)) / kTuft_m) - 0.5);
  // The cushions take some of the hall's light from the cloth beside them.
  vec2 fromCushion_m = 0.5 * surface.xy - abs(place.xy);
  green *= 0.72 + 0.28 * clamp(min(fromCushion_m.x, fromCushion_m.y) / 0.05, 0.0, 1.0);
  float fromSpot_m = min(length(place.xy), length(vec2(abs(place.x) - 0.25 * surface.x, place.y)));
  return Painted(mix(vec3(0.75), green, edge(fromSpot_m - 0.008)), vec3(0.0), 1.0);
}
