// Varnished wood with mother-of-pearl diamonds. surface: metres along the rail from its middle, metres outwards
// from the diamonds' line, spacing of the diamonds (0: none).
Painted paint() {
  float along = surface.x;
  // Years, wavy along the plank, and fine dark pores.
  float across = surface.y - 0.8 * place.z + 0.006 * sin(2.3 * along);
  float years = noise(vec2(1.6 * along, 110.0 * across)) + 0.5 * noise(vec2(3.0 * along + 7.0, 370.0 * across));
  float pores = smoothstep(0.62, 0.9, noise(vec2(28.0 * along, 900.0 * across)));
  float fine = clamp(1.5 - footprintOf(across) * 900.0, 0.0, 1.0);
  vec3 wood = colour * (0.62 + 0.5 * years) * (1.0 - 0.45 * fine * pores);
  float spacing = max(surface.z, 1e-3);
  float fromDiamond = abs(fract(along / spacing - 0.5) - 0.5) * spacing;
  float diamond = 1.0 - edge(fromDiamond / 0.009 + abs(surface.y) / 0.016 - 1.0);
  return Painted(mix(wood, vec3(0.80, 0.78, 0.70), surface.z > 0.0 ? diamond : 0.0), vec3(0.0), 1.0);
}
