// A clock's face: the board time at which light left its middle, in seconds and tenths, in seven-segment
// digits; after 999.9 it begins again. surface.xy: 0 … 4 over the four places from the left, 0 … 1
// over their height.
uniform int observedWhole_s;      // the observation's board time: whole seconds
uniform float observedPart_s;     // and the rest
uniform float lightSpeed_m_s;

/// What stands at `position` (0 … 3 from the left) for a time in tenths of a second: up to three digits, the point,
/// tenths; the sign stands before the first digit.
int digitAt(int position, int tenths) {
  int size = abs(tenths);
  if (position == 3) return size % 10;
  if (position == 2) return (size / 10) % 10;
  int unit = position == 1 ? 100 : 1000;
  if (size >= unit) return (size / unit) % 10;
  bool afterwardsADigit = position == 1 || size >= 100;
  return tenths < 0 && afterwardsADigit ? 10 : 11;
}

Painted paint() {
  float part_s = observedPart_s + boardTime_m / lightSpeed_m_s;
  int tenths = 10 * observedWhole_s + int(floor(10.0 * part_s));

  int position = int(clamp(floor(surface.x), 0.0, 3.0));
  vec2 p = vec2((surface.x - float(position) - 0.5) * 1.25, (surface.y - 0.5) * 2.0);
  float footprint = max(length(vec2(fwidth(surface.x) * 1.25, fwidth(surface.y) * 2.0)) * 0.7, 1e-4);
  float lit = clamp((0.11 - toDigit(p, segmentsOf(digitAt(position, tenths)))) / footprint + 0.5, 0.0, 1.0);
  float fromPoint = length(vec2((surface.x - 3.0) * 1.25, (surface.y - 0.15) * 2.0));
  lit = max(lit, clamp((0.17 - fromPoint) / footprint + 0.5, 0.0, 1.0));
  vec2 outside = abs(surface.xy - vec2(2.0, 0.5)) - vec2(2.0, 0.5);
  float bezel = max(edge(outside.x), edge(outside.y));
  return Painted(vec3(mix(0.008, 0.045, bezel)), lit * colour, 1.0);
}
