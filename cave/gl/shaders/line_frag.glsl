// Covers a pixel as far as the line does.
#version 150
noperspective in vec2 across_px;
noperspective in vec4 colourHere;
out vec4 colour;

void main() {
  float covered = clamp(across_px.y - abs(across_px.x) + 0.5, 0.0, 1.0);
  colour = vec4(colourHere.rgb, colourHere.a * covered);
}
