// Sheets of 10 cm, riveted together on both sides of each seam: their number tells how long the body is at
// rest.
const float kSheets_1_m = 10.0, kRivets_1_m = 50.0;

Painted paint() {
  float along = kSheets_1_m * place.x;
  float seam = lines(along, 0.05);
  // Rivets of 6 mm, 1 cm beside the seams and 2 cm apart up and across.
  float fromSeam_m = (0.5 - abs(fract(along) - 0.5)) / kSheets_1_m;
  float across = kRivets_1_m * (place.z + place.y);
  vec2 fromRivet_m = vec2(fromSeam_m - 0.01, (abs(fract(across) - 0.5) - 0.5) / kRivets_1_m);
  float pixel_m = footprintOf(across) / kRivets_1_m + 1e-6;
  float visible = clamp(2.0 - 1000.0 * pixel_m * 0.3, 0.0, 1.0);
  float rivet = visible * edge((0.003 - length(fromRivet_m)) / pixel_m);
  vec3 sheet = colour * (0.92 + 0.08 * step(0.5, fract(0.5 * along)));
  return Painted(mix(mix(sheet, min(1.35 * colour + 0.04, 1.0), rivet), colour * 0.18, seam), vec3(0.0), 1.0);
}
