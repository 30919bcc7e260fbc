// A rectangle that covers the viewport, from two triangles: llvmpipe copies it row by row.
#version 150
out vec2 place;  // 0 … 1 over the viewport, from its lower left
void main() {
  place = vec2(gl_VertexID == 1 || gl_VertexID == 2 || gl_VertexID == 4 ? 1.0 : 0.0,
               gl_VertexID == 2 || gl_VertexID == 4 || gl_VertexID == 5 ? 1.0 : 0.0);
  gl_Position = vec4(place * 2.0 - 1.0, 0.0, 1.0);
}
