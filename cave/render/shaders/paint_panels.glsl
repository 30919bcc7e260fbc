// Panels of one metre with joints, and a dark dado below. surface.xy: metres along the wall and above the floor;
// surface.z: height of the dado; of a ceiling, less what the lamps beside it add to its light.
Painted paint() {
  float joints = max(lines(surface.x, 0.016), lines(surface.y, 0.016));
  float dado = surface.z > 0.0 ? 1.0 - edge(surface.y - surface.z) : 0.0;
  float rail = 1.0 - edge(abs(surface.y - surface.z) - 0.02);
  vec3 wall = mix(colour, vec3(0.13, 0.055, 0.03), dado);
  wall = mix(wall, wall * 0.55, joints);
  wall *= surface.z > 0.0 ? 0.80 + 0.28 * smoothstep(0.0, 4.5, surface.y) : 0.8 - surface.z;
  return Painted(mix(wall, vec3(0.35, 0.23, 0.10), surface.z > 0.0 ? rail : 0.0), vec3(0.0), 1.0);
}
