// A clock's face: the board time at which light left its middle, in seconds and the tenths that have gone by,
// in seven-segment digits. The longer the number, the smaller they are. surface.xy: 0 … 4 over the face from
// the left, 0 … 1 over its height.
uniform int observedWhole_s;      // the observation's board time: whole seconds
uniform float observedPart_s;     // and the rest
uniform float lightSpeed_m_s;

const vec2 kFace = vec2(5.0, 2.0);   // in the measure of toDigit
const float kWritten = 4.8;          // of its width

/// Sets the place so far from the last.
void write(inout ivec2 digits, int fromLast, int digit) {
  if (fromLast < 6) digits.y |= digit << (4 * fromLast);
  else digits.x |= digit << (4 * (fromLast - 6));
}

Painted paint() {
  float part_s = observedPart_s + boardTime_m / lightSpeed_m_s;
  int tenths = 10 * observedWhole_s + int(floor(10.0 * part_s));

  ivec2 digits = ivec2(0);
  int places = 0;
  for (int left = abs(tenths); left > 0 || places < 2; left /= 10) write(digits, places++, left % 10);
  if (tenths < 0) write(digits, places++, 10);

  float across = float(places) + kPointWide;
  float scale = min(1.0, kWritten / (across * kPlace.x));
  // From the middle of the right border.
  vec2 p = (surface.xy * vec2(0.25, 1.0) - vec2(1.0, 0.5)) * kFace / scale;
  float footprint = max(length(fwidth(p)) * 0.7, 1e-4);
  p.x = across + (p.x + 0.5 * (kFace.x - kWritten) / scale) / kPlace.x;
  float lit = written(p, places, 1, digits, footprint);
  vec2 outside = abs(surface.xy - vec2(2.0, 0.5)) - vec2(2.0, 0.5);
  float bezel = max(edge(outside.x / footprintOf(outside.x)), edge(outside.y / footprintOf(outside.y)));
  return Painted(vec3(mix(0.008, 0.045, bezel)), lit * colour, 1.0);
}
