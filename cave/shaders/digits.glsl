// Seven-segment digits.

/// Segments of a digit, bit 0 to 6: top, upper right, lower right, bottom, lower left, upper left, middle; 7: a leg
/// below the middle.
int segmentsOf(int digit) {
  // Then a minus sign, a blank, a degree sign, an m.
  int[14] table = int[14](63, 6, 91, 79, 102, 109, 125, 7, 127, 111, 64, 0, 99, 212);
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
  if ((lit & 128) != 0) d = min(d, toBar(p, vec2(0.0, -0.5), vec2(0.0, -0.1)));
  return d;
}
