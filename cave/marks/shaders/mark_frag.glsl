// Colours a mark: a flat colour, a soft light (style = −1), a disc (−2), or a plate with letters. For a
// plate, style is the sum of its number of places and 16 times its shape (cave/marks/mark_buffer.h: box,
// clock, flag), and each part of `text` has three letters. kCells: columns and rows of the picture of
// letters (cave/gl/letter_atlas.h).
in vec4 colourHere;
in vec2 place;  // on a plate places from its left border, 0 … 1 over its height; on a light or a disc −1 … 1
flat in float style;
flat in vec4 text;
uniform sampler2D letters;
out vec4 colour;

const vec2 kPlace = vec2(1.1, 1.8);  // width and height of a place

/// How much of this pixel a row of letters covers. p.x: in places from the first; p.y: 0 … 1.
float written(vec2 p, int places) {
  int at = clamp(int(floor(p.x)), 0, places - 1);
  int three = int(text[at / 3]);
  int letter = (three >> (8 * (2 - at % 3))) & 255;
  vec2 within = clamp(vec2(p.x - float(at), p.y), 0.0, 1.0);
  vec2 cell = vec2(letter % int(kCells.x), letter / int(kCells.x));
  return textureGrad(letters, (cell + within) / kCells, dFdx(p) / kCells, dFdy(p) / kCells).r;
}

vec4 plate() {
  int code = int(style + 0.5);
  int places = code & 15;
  int shape = code >> 4;
  float margin = shape == 0 ? 0.12 : shape == 1 ? 0.30 : 0.20;
  float across = float(places) + 2.0 * margin;
  float footprint = max(length(fwidth(place) * kPlace) * 0.7, 1e-4);
  float lit = written(vec2(place.x - margin, place.y), places);

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
  if (style < -1.5) {
    float r = length(place);
    colour = vec4(colourHere.rgb, colourHere.a * clamp((1.0 - r) / max(fwidth(r), 1e-4), 0.0, 1.0));
  } else if (style < -0.5) {
    float r = length(place);
    float core = max(1.0 - r, 0.0);
    colour = vec4(mix(colourHere.rgb, vec3(1.0), core * core), colourHere.a * core * core);
  } else {
    colour = style < 0.5 ? colourHere : plate();
  }
}
