// A pixel at an edge takes as much of its neighbour's colour as the neighbour covers of it.
//
// Edges are sought in the tone, TONE of a pixel. In the session's pictures that is alpha: there the surfaces are as
// bright as if each were painted evenly (surface_frag.glsl), since what is painted on a surface is smooth already. The search is that of T. Lottes, FXAA 3.11 (NVIDIA, 2011): from a
// pixel along the edge to both sides, up to where the edge goes on in another row. The share is that of A. Reshetov,
// Morphological antialiasing (High Performance Graphics 2009): between two such places, k pixels apart, the edge is
// a straight line from half a pixel on this side of the border of the rows to half a pixel on the other. Of the pixel
// from j to j + 1 it cuts off
//   ∫ max(0, 1/2 − x/k) dx from j to j + 1.
uniform sampler2D drawn;
uniform ivec2 size_px;  // of what is drawn: the first columns and rows of the texture
uniform int left_px;    // column of the picture in which it begins
uniform float leastStep;
out vec4 colour;

const int kFarthest_px = 16;  // that an edge is followed

ivec2 within(ivec2 at) { return clamp(at, ivec2(0), size_px - 1); }
float toneAt(ivec2 at) { return TONE(texelFetch(drawn, within(at), 0)); }

/// The share of the pixel from j to j + 1 that lies beyond the edge.
float cutOff(float j, float k) {
  float h = clamp(0.5 * k - j, 0.0, 1.0);
  return h * (0.5 - (j + 0.5 * h) / k);
}

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy) - ivec2(left_px, 0);
  float m = toneAt(here);
  float north = toneAt(here + ivec2(0, 1)), south = toneAt(here - ivec2(0, 1));
  float east = toneAt(here + ivec2(1, 0)), west = toneAt(here - ivec2(1, 0));
  float most = max(max(max(north, south), max(east, west)), m);
  float least = min(min(min(north, south), min(east, west)), m);
  if (most - least < leastStep) discard;

  // Along rows or along columns: where the second differences across are the larger ones, corners included.
  float ne = toneAt(here + ivec2(1, 1)), sw = toneAt(here - ivec2(1, 1));
  float nw = toneAt(here + ivec2(-1, 1)), se = toneAt(here + ivec2(1, -1));
  float acrossRows = abs(nw + sw - 2.0 * west) + 2.0 * abs(north + south - 2.0 * m) + abs(ne + se - 2.0 * east);
  float acrossColumns = abs(nw + ne - 2.0 * north) + 2.0 * abs(west + east - 2.0 * m) + abs(sw + se - 2.0 * south);
  bool inRow = acrossRows >= acrossColumns;
  float up = inRow ? north : east;
  float down = inRow ? south : west;
  bool upper = abs(up - m) >= abs(down - m);
  ivec2 along = inRow ? ivec2(1, 0) : ivec2(0, 1);
  ivec2 across = (upper ? 1 : -1) * (inRow ? ivec2(0, 1) : ivec2(1, 0));
  float step_ = (upper ? up : down) - m;
  float middle = m + 0.5 * step_;

  // How far the edge runs to either side, and to which side of it the tone turns there.
  vec2 run_px = vec2(float(kFarthest_px));
  vec2 turn = vec2(0.0);
  bvec2 running = bvec2(true);
  for (int i = 1; i <= kFarthest_px && any(running); ++i) {
    ivec2 ahead = here + i * along, behind = here - i * along;
    vec2 off = 0.5 * vec2(toneAt(ahead) + toneAt(ahead + across), toneAt(behind) + toneAt(behind + across)) - middle;
    bvec2 ends = greaterThanEqual(abs(off), vec2(0.25 * abs(step_)));
    if (running.x && ends.x) { run_px.x = float(i); turn.x = off.x; running.x = false; }
    if (running.y && ends.y) { run_px.y = float(i); turn.y = off.y; running.y = false; }
  }
  bool first = run_px.x < run_px.y;
  // The edge comes over to this pixel's row where the tone turns to the neighbour's.
  bool comesOver = (first ? turn.x : turn.y) * step_ > 0.0;
  float share = comesOver ? cutOff(min(run_px.x, run_px.y) - 1.0, run_px.x + run_px.y - 1.0) : 0.0;
  vec4 ours = texelFetch(drawn, here, 0), theirs = texelFetch(drawn, within(here + across), 0);
  colour = mix(ours, theirs, share);
}
