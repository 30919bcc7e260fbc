// Irregularities of materials: 0 to 1, soft over a cell of 1, the same on every machine.

float atKnot(uint n) { return float(((n ^ (n >> 15)) * 2246822519u) >> 16) * (1.0 / 65535.0); }

const uvec2 kStep = uvec2(1597334677u, 3812015801u);  // from knot to knot

float noise(vec2 p) {
  vec2 whole = floor(p);
  uvec2 at = uvec2(ivec2(whole)) * kStep;
  uvec2 next = at + kStep;
  vec2 f = p - whole;
  f = f * f * (3.0 - 2.0 * f);
  return mix(mix(atKnot(at.x ^ at.y), atKnot(next.x ^ at.y), f.x),
             mix(atKnot(at.x ^ next.y), atKnot(next.x ^ next.y), f.x), f.y);
}
