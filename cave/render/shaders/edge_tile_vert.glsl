// A tile of the picture: a point as large as it, moved out of sight if no edge runs through it.
uniform sampler2D drawn;  // TONE: edge_frag.glsl
uniform ivec2 size_px;    // of what is drawn: the first columns and rows of the texture
uniform float leastStep;

const int kTile_px = 8;
const int kLooked_px = kTile_px + 2;  // with the pixels around it

void main() {
  int across = (size_px.x + kTile_px - 1) / kTile_px;
  // The last tiles lie within the picture, too, over a part of those before.
  ivec2 from = min(ivec2(gl_VertexID % across, gl_VertexID / across) * kTile_px, size_px - kTile_px);
  ivec2 first = clamp(from - 1, ivec2(0), size_px - kLooked_px);
  float least = 1.0;
  float most = 0.0;
  for (int y = 0; y < kLooked_px; ++y) {  // always the same number: the compiler unrolls it
    for (int x = 0; x < kLooked_px; ++x) {
      float here = TONE(texelFetch(drawn, first + ivec2(x, y), 0));
      least = min(least, here);
      most = max(most, here);
    }
  }
  vec2 middle = vec2(from) + 0.5 * float(kTile_px);
  bool even = most - least < leastStep;
  gl_Position = even ? vec4(0.0, 0.0, 2.0, 1.0) : vec4(2.0 * middle / vec2(size_px) - 1.0, 0.0, 1.0);
  gl_PointSize = float(kTile_px);
}
