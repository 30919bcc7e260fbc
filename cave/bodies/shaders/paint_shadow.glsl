// Paints a puck's shadow. surface.x: 0 where the light of one kind is hidden completely, 1 where none of it
// is; surface.y: the share of the cloth's light that is of this kind. The shadow covers the encoded picture
// (sRGB), which is about the root 2.2 of light.
Painted paint() {
  float s = clamp(1.0 - surface.x, 0.0, 1.0);
  return Painted(vec3(0.0), vec3(0.0), 1.0 - pow(1.0 - surface.y * s * s * (3.0 - 2.0 * s), 1.0 / 2.2));
}
