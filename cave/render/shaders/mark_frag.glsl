// Colours a mark: a flat colour, a soft light (style.x = −1), a disc (−2), or a plate with digits. For a
// plate, style.x is the sum of its number of places, 16 times the number of places behind the point (0: there
// is no point) and 256 times its shape (cave/render/mark_buffer.h: box, clock, flag). The digits are in
// style.yz, packed as in digits.glsl.
in vec4 colourHere;
in vec2 place;  // on a plate places from its left border, 0 … 1 over its height; on a light or a disc −1 … 1
flat in vec3 style;
out vec4 colour;

vec4 plate() {
  int code = int(style.x + 0.5);
  int places = code & 15;
  int behind = (code >> 4) & 15;
  int shape = code >> 8;
  float margin = shape == 0 ? 0.12 : shape == 1 ? 0.30 : 0.20;
  float across = float(places) + (behind > 0 ? kPointWide : 0.0) + 2.0 * margin;
  float footprint = max(length(fwidth(place) * kPlace) * 0.7, 1e-4);
  float lit = written(vec2(place.x - margin, (place.y - 0.5) * kPlace.y), places, behind,
                      ivec2(style.yz), footprint);

  // Its outline, with round corners: inside below 0.
  float radius = shape == 1 ? 0.5 : 0.08;
  vec2 q = (abs(place - vec2(0.5 * across, 0.5)) - vec2(0.5 * across, 0.5)) * kPlace + radius;
  float outside = length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - radius;
  float cover = clamp(0.5 - outside / footprint, 0.0, 1.0);
  float border = clamp(0.5 + (outside + (shape == 1 ? 0.16 : 0.07)) / footprint, 0.0, 1.0);
  vec3 ink = mix(colourHere.rgb, vec3(1.0), shape == 1 ? 0.4 : 0.0);
  vec3 shown = shape == 2 ? mix(colourHere.rgb, vec3(0.03), lit)
                          : mix(mix(vec3(0.03), ink, lit), colourHere.rgb, border);
  return vec4(shown, colourHere.a * cover);
}

void main() {
  if (style.x < -1.5) {
    float r = length(place);
    colour = vec4(colourHere.rgb, colourHere.a * clamp((1.0 - r) / max(fwidth(r), 1e-4), 0.0, 1.0));
  } else if (style.x < -0.5) {
    float r = length(place);
    float core = max(1.0 - r, 0.0);
    colour = vec4(mix(colourHere.rgb, vec3(1.0), core * core), colourHere.a * core * core);
  } else {
    colour = style.x < 0.5 ? colourHere : plate();
  }
}
