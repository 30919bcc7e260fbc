// Seven-segment digits, and rows of them.

/// Segments of a digit, bit 0 to 6: top, upper right, lower right, bottom, lower left, upper left, middle.
int segmentsOf(int digit) {
  // Then a minus sign.
  int[11] table = int[11](63, 6, 91, 79, 102, 109, 125, 7, 127, 111, 64);
  return table[digit];
}

/// Distance of p to the segment from a to b, in the measure that gives bevelled ends.
float toBar(vec2 p, vec2 a, vec2 b) {
  vec2 middle = 0.5 * (a + b);
  vec2 half_ = 0.5 * abs(b - a);
  vec2 q = max(abs(p - middle) - half_, 0.0);
  return q.x + q.y;
}

/// Distance to the nearest lit segment; the digit fills |x| ≤ 0.3, |y| ≤ 0.6.
float toDigit(vec2 p, int lit) {
  p.x -= 0.08 * p.y;  // a slight slant
  float d = 1.0;
  if ((lit & 1) != 0) d = min(d, toBar(p, vec2(-0.2, 0.6), vec2(0.2, 0.6)));
  if ((lit & 2) != 0) d = min(d, toBar(p, vec2(0.3, 0.1), vec2(0.3, 0.5)));
  if ((lit & 4) != 0) d = min(d, toBar(p, vec2(0.3, -0.5), vec2(0.3, -0.1)));
  if ((lit & 8) != 0) d = min(d, toBar(p, vec2(-0.2, -0.6), vec2(0.2, -0.6)));
  if ((lit & 16) != 0) d = min(d, toBar(p, vec2(-0.3, -0.5), vec2(-0.3, -0.1)));
  if ((lit & 32) != 0) d = min(d, toBar(p, vec2(-0.3, 0.1), vec2(-0.3, 0.5)));
  if ((lit & 64) != 0) d = min(d, toBar(p, vec2(-0.2, 0.0), vec2(0.2, 0.0)));
  return d;
}

const vec2 kPlace = vec2(1.1, 1.8);  // of a row of digits, in the measure of toDigit
const float kPointWide = 0.35;       // in places

/// How much of this pixel a row of up to twelve digits and its point cover. p.x: in places from the first;
/// p.y: in the measure of toDigit. `behind` of them stand behind the point (0: there is none). `digits`: four
/// bits a place, the last six places in .y, those before in .x, the last lowest.
float written(vec2 p, int places, int behind, ivec2 digits, float footprint) {
  float pointAt = float(places - behind);
  float x = p.x;
  if (behind > 0 && x > pointAt) x = max(x - kPointWide, pointAt);
  int at = int(clamp(floor(x), 0.0, float(places - 1)));
  int fromLast = places - 1 - at;
  int digit = fromLast < 6 ? (digits.y >> (4 * fromLast)) & 15 : (digits.x >> (4 * (fromLast - 6))) & 15;
  float far = toDigit(vec2((x - float(at) - 0.5) * kPlace.x, p.y), segmentsOf(digit)) - 0.12;
  if (behind > 0) {
    float inPoint = step(pointAt, p.x) * step(p.x, pointAt + kPointWide);
    vec2 fromPoint = vec2((p.x - pointAt - 0.5 * kPointWide) * kPlace.x, p.y + 0.56);
    far = min(mix(far, 1.0, inPoint), length(fromPoint) - 0.19);
  }
  return clamp(0.5 - far / footprint, 0.0, 1.0);
}
