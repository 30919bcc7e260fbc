// Cloth with a faint 10 cm grid and the game's three spots. surface.xy: length and width of the board
// (metres).
Painted paint() {
  vec2 at = place.xy * 10.0;
  vec2 footprint = footprintOf(at);
  vec2 grid = lines(at, 0.03, footprint, 1.0 / footprint);
  float shade = 1.0 - 0.30 * max(grid.x, grid.y);
  // Its nap, as long as a tuft, of 4 mm, is larger than a pixel.
  float tufts = max(1.0 - 25.0 * (footprint.x + footprint.y), 0.0);
  shade *= 1.0 + 0.22 * tufts * (noise(vec2(250.0, 625.0) * vec2(place.x + place.y, place.x - place.y)) - 0.5);
  // The cushions take some of the hall's light from the cloth beside them.
  vec2 fromCushion_m = 0.5 * surface.xy - abs(place.xy);
  shade *= 0.72 + 0.28 * clamp(20.0 * min(fromCushion_m.x, fromCushion_m.y), 0.0, 1.0);
  // Spots of 8 mm: the square of the way from the nearest one changes over a pixel by twice that way times
  // the pixel.
  vec2 way = vec2(min(abs(at.x), abs(abs(at.x) - 2.5 * surface.x)), abs(at.y));
  float spots = 1.0 - edge((dot(way, way) - 0.0064) / (2.0 * dot(way, footprint)));
  return Painted(mix(colour * shade, vec3(0.75), spots), vec3(0.0), 1.0);
}
