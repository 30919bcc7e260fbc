// A tile of the picture: a point as large as it, moved out of sight if no edge runs through it.
#version 150
uniform sampler2D drawn;  // alpha: edge_frag.glsl
uniform ivec2 size_px;    // of what is drawn: the first columns and rows of the texture
uniform int tile_px;
uniform float leastStep;

void main() {
  int across = (size_px.x + tile_px - 1) / tile_px;
  // The last tiles lie within the picture, too, over a part of those before.
  ivec2 from = min(ivec2(gl_VertexID % across, gl_VertexID / across) * tile_px, size_px - tile_px);
  ivec2 first = max(from - 1, 0);
  ivec2 last = min(from + tile_px, size_px - 1);
  float least = 1.0;
  float most = 0.0;
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      float here = texelFetch(drawn, ivec2(x, y), 0).a;
      least = min(least, here);
      most = max(most, here);
    }
  }
  vec2 middle = vec2(from) + 0.5 * float(tile_px);
  bool even = most - least < leastStep;
  gl_Position = even ? vec4(0.0, 0.0, 2.0, 1.0) : vec4(2.0 * middle / vec2(size_px) - 1.0, 0.0, 1.0);
  gl_PointSize = float(tile_px);
}
