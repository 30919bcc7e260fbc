// A puck whose pattern shows how it is deformed and turned: twelve sectors and three rings on its faces,
// twenty-four marks on its rim. surface: radius, 1 on the rim and 0 on the faces, height of the rim.

/// The product of two complex numbers: of directions, the one at the sum of their angles.
vec2 turned(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }

Painted paint() {
  float perRadius = inversesqrt(max(dot(place.xy, place.xy), 1e-12));
  vec2 once = place.xy * perRadius;
  vec2 thrice = turned(turned(once, once), once);
  vec2 six = turned(thrice, thrice);
  vec2 twelve = turned(six, six);
  // Over a pixel their sines change by their cosines times its angle, n times over.
  float pixel_rad = max(length(fwidth(place.xy)) * perRadius, 1e-5);
  float sector = edge(six.y / (6.0 * max(abs(six.x), 1e-2) * pixel_rad));
  float mark = edge(twelve.y / (12.0 * max(abs(twelve.x), 1e-2) * pixel_rad));

  float share = dot(place.xy, once) / surface.x;
  float perShare_px = 1.0 / footprintOf(share);
  float ring = edge((share - 0.58) * perShare_px);
  float checker = sector + ring - 2.0 * sector * ring;
  float paintedOver = edge((share - 0.16) * perShare_px) * (1.0 - edge((share - 0.90) * perShare_px));
  float hub = edge((abs(share - 0.16) - 0.025) * perShare_px);
  float onFace = 1.0 - hub * (1.0 - checker * paintedOver);
  float band = 1.0 - edge((abs(place.z) - 0.30 * surface.z) / footprintOf(place.z));
  return Painted(mix(colour, colour * 0.05, surface.y < 0.5 ? onFace : mark * band), vec3(0.0), 1.0);
}
