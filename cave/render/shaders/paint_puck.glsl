// A puck whose pattern shows how it is deformed and turned: twelve sectors and three rings on its faces,
// twenty-four marks on its rim. surface: radius, 1 on the rim and 0 on the faces, height of the rim.
Painted paint() {
  float radius_m = length(place.xy);
  float share = radius_m / surface.x;
  float angle = atan(place.y, place.x);
  // sin(nθ) has no seam at θ = ±π; its footprint there must not be taken across the seam.
  float sectors = sin(6.0 * angle);
  float turn = cos(6.0 * angle) * 6.0;
  float footprint = max(abs(turn) * length(vec2(fwidth(place.x), fwidth(place.y))) / max(radius_m, 1e-4), 1e-4);
  float sector = clamp(sectors / footprint + 0.5, 0.0, 1.0);
  float ring = edge(share - 0.58);
  float checker = sector + ring - 2.0 * sector * ring;

  vec3 dark = colour * 0.05;
  vec3 face = mix(colour, dark, checker);
  face = mix(colour, face, edge(share - 0.16) * (1.0 - edge(share - 0.90)));
  face = mix(dark, face, edge(abs(share - 0.16) - 0.025));

  float marks = sin(12.0 * angle);
  float mark = clamp(marks / max(2.0 * footprint, 1e-4) + 0.5, 0.0, 1.0);
  float band = 1.0 - edge(abs(place.z) - 0.30 * surface.z);
  vec3 rim = mix(colour, dark, mark * band);
  return Painted(mix(face, rim, step(0.5, surface.y)), vec3(0.0), 1.0);
}
