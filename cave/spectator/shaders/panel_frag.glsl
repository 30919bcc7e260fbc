// What a wall shows, or an empty panel.
#version 150
uniform sampler2D shown;
uniform bool empty;
in vec2 place;
out vec4 colour;

void main() {
  if (empty) {
    colour = vec4(0.10, 0.13, 0.19, 1.0);
    return;
  }
  // The picture may be much finer than the panel: 16 points of what a pixel covers.
  vec2 x = dFdx(place), y = dFdy(place);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j)
      sum += texture(shown, place + x * (float(i) - 1.5) / 4.0 + y * (float(j) - 1.5) / 4.0).rgb;
  }
  colour = vec4(sum / 16.0, 1.0);
}
