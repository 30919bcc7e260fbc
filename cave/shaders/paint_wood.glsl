// Varnished wood with mother-of-pearl diamonds. surface: metres along the rail from its middle, metres outwards
// from the diamonds' line, spacing of the diamonds (0: none).
Painted paint() {
  float along = surface.x;
  float grain = sin(70.0 * surface.y + 3.0 * sin(2.3 * along) + 40.0 * place.z) +
                0.5 * sin(190.0 * surface.y + 5.0 * sin(3.1 * along));
  vec3 wood = colour * (1.0 + 0.10 * grain);
  float spacing = max(surface.z, 1e-3);
  float fromDiamond = abs(fract(along / spacing - 0.5) - 0.5) * spacing;
  float diamond = 1.0 - edge(fromDiamond / 0.009 + abs(surface.y) / 0.016 - 1.0);
  return Painted(mix(wood, vec3(0.80, 0.78, 0.70), surface.z > 0.0 ? diamond : 0.0), vec3(0.0), 1.0);
}
