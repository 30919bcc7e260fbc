// A puck's shadow. surface.x: 0 where all of the light of its sort is hidden, 1 where nothing is; surface.y: what share
// of the cloth's light that is. What is drawn is covered as it stands on the screen, in sRGB: about the root 2.2 of light.
Painted paint() {
  float s = clamp(1.0 - surface.x, 0.0, 1.0);
  return Painted(vec3(0.0), vec3(0.0), 1.0 - pow(1.0 - surface.y * s * s * (3.0 - 2.0 * s), 1.0 / 2.2));
}
