// Irregularities of materials: 0 to 1, soft over a cell of 1, the same on every machine.

float atKnot(ivec2 at) {
  uint n = uint(at.x) * 1597334677u ^ uint(at.y) * 3812015801u;
  n = (n ^ (n >> 15)) * 2246822519u;
  return float((n ^ (n >> 13)) & 65535u) / 65535.0;
}

float noise(vec2 p) {
  vec2 whole = floor(p);
  ivec2 at = ivec2(whole);
  vec2 f = p - whole;
  f = f * f * (3.0 - 2.0 * f);
  return mix(mix(atKnot(at), atKnot(at + ivec2(1, 0)), f.x), mix(atKnot(at + ivec2(0, 1)), atKnot(at + ivec2(1, 1)), f.x),
             f.y);
}
