// A mesh painted around its axis, so that one sees how it has turned and is bent: sectors alternately in its
// colour and pale, on its rim the other way round. The first sector has its middle on x. surface: an even
// number of sectors; radius.
const float kRimFrom = 0.86;  // of the radius
const vec3 kPale = vec3(0.75);

Painted paint() {
  float radius_m = max(length(place.xy), 1e-6);
  float turns = 0.5 * surface.x;
  float angle = turns * atan(place.y, place.x);
  // Over a pixel the cosine changes by the sine times its angle.
  float pixel_rad = max(turns * length(fwidth(place.xy)) / radius_m, 1e-5);
  float even = edge(cos(angle) / (max(abs(sin(angle)), 1e-2) * pixel_rad));
  float rim = edge((radius_m / surface.y - kRimFrom) / footprintOf(radius_m / surface.y));
  return Painted(mix(kPale, colour, even + rim - 2.0 * even * rim), vec3(0.0), 1.0);
}
