// Panels of one metre with joints, and a dark dado below. surface.xy: metres along the wall and above the
// floor; surface.z: height of the dado; of a ceiling, less what the lamps beside it add to its light.
Painted paint() {
  vec2 footprint = footprintOf(surface.xy);
  vec2 perMetre_px = 1.0 / footprint;
  vec2 joints = lines(surface.xy, 0.016, footprint, perMetre_px);
  bool isWall = surface.z > 0.0;
  float overDado = surface.y - surface.z;
  float dado = isWall ? 1.0 - edge(overDado * perMetre_px.y) : 0.0;
  float rail = isWall ? 1.0 - edge((abs(overDado) - 0.02) * perMetre_px.y) : 0.0;
  float shade = isWall ? 0.80 + 0.28 * soft(clamp(0.222 * surface.y, 0.0, 1.0)) : 0.8 - surface.z;
  vec3 wall = mix(colour, kDado, dado) * (shade * (1.0 - 0.45 * max(joints.x, joints.y)));
  return Painted(mix(wall, vec3(0.35, 0.23, 0.10), rail), vec3(0.0), 1.0);
}
