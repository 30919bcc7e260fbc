// A mark: a flat colour; a soft light, style.x = −1; or a plate of style.x places, 16 more if a point stands before the
// last, on which style.y says the digits: four bits a place, the last place lowest.
in vec4 colourHere;
in vec2 place;  // on a plate 0 … places from the left, 0 … 1 over its height; on a light −1 … 1
flat in vec2 style;
out vec4 colour;

vec4 plate() {
  int places = int(style.x + 0.5);
  bool tenths = places >= 16;
  if (tenths) places -= 16;
  int at = int(clamp(floor(place.x), 0.0, float(places - 1)));
  int digit = (int(style.y + 0.5) >> (4 * (places - 1 - at))) & 15;
  vec2 p = vec2((place.x - float(at) - 0.5) * 1.15, (place.y - 0.5) * 1.9);
  float footprint = max(length(vec2(fwidth(place.x) * 1.15, fwidth(place.y) * 1.9)) * 0.7, 1e-4);
  float lit = clamp((0.12 - toDigit(p, segmentsOf(digit))) / footprint + 0.5, 0.0, 1.0);
  if (tenths) {
    vec2 q = abs(vec2((place.x - float(places - 1)) * 1.15, (place.y - 0.5) * 1.9 + 0.62));
    lit = max(lit, clamp((0.11 - max(q.x, q.y)) / footprint + 0.5, 0.0, 1.0));
  }
  // Its frame, in the digits' colour.
  float edge_ = min(min(place.x, float(places) - place.x) * 1.15, min(place.y, 1.0 - place.y) * 1.9);
  float frame = clamp((0.07 - edge_) / footprint + 0.5, 0.0, 1.0);
  return vec4(mix(vec3(0.04), colourHere.rgb, max(lit, frame)), colourHere.a);
}

void main() {
  if (style.x < -0.5) {
    float r = length(place);
    float core = max(1.0 - r, 0.0);
    colour = vec4(mix(colourHere.rgb, vec3(1.0), core * core), colourHere.a * core * core);
  } else {
    colour = style.x < 0.5 ? colourHere : plate();
  }
}
