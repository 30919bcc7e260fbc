// Varnished wood with mother-of-pearl diamonds. surface: metres along the rail from its middle, metres
// outwards from the diamonds' line, spacing of the diamonds (0: none).
Painted paint() {
  float along = surface.x;
  // Years, wavy along the plank, and fine dark pores.
  float wave = 2.0 * fract(0.366 * along) - 1.0;
  float across = surface.y - 0.8 * place.z + 0.024 * wave * (1.0 - abs(wave));
  float years = noise(vec2(1.6 * along, 110.0 * across)) + 0.5 * noise(vec2(3.0 * along + 7.0, 370.0 * across));
  float pores = soft(clamp(3.57 * noise(vec2(28.0 * along, 900.0 * across)) - 2.21, 0.0, 1.0));
  float fine = clamp(1.5 - 900.0 * footprintOf(across), 0.0, 1.0);
  float shade = (0.62 + 0.5 * years) * (1.0 - 0.45 * fine * pores);
  // Diamonds of 9 mm along the rail and 16 mm across.
  float fromDiamond = abs(fract(along / max(surface.z, 1e-3) - 0.5) - 0.5) * surface.z;
  float outside = 111.0 * fromDiamond + 62.5 * abs(surface.y) - 1.0;
  float diamond = surface.z > 0.0 ? 1.0 - edge(outside / footprintOf(outside)) : 0.0;
  return Painted(mix(colour * shade, vec3(0.80, 0.78, 0.70), diamond), vec3(0.0), 1.0);
}
