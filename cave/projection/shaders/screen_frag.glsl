// A pixel of a curved screen's window, from the picture of a flat wall.
#version 150
uniform sampler2D piece;  // decoded to light
in vec3 weightedPlace;
out vec4 colour;

// sRGB, IEC 61966-2-1.
vec3 codeOf(vec3 light) {
  vec3 low = light * 12.92;
  vec3 high = 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055;
  return mix(high, low, vec3(lessThanEqual(light, vec3(0.0031308))));
}

// The cubic of Catmull and Rom through four texels each way; where more than 1.25 of them are shown by a
// pixel it would raise the contrast of fine stripes, and is mixed with the linear filter. The two texels in
// the middle, whose weights have one sign, are taken together; the four in the corners, whose weights are
// below 0.006, are left out (J. Jimenez, "Filmic SMAA", SIGGRAPH 2016).
vec3 lightAt(vec2 place) {
  vec2 size = vec2(textureSize(piece, 0));
  vec2 at = place * size, middle = floor(at - 0.5) + 0.5, f = at - middle;
  vec2 shown = sqrt(dFdx(at) * dFdx(at) + dFdy(at) * dFdy(at));
  vec2 linear = clamp(2.0 * (shown - 1.25), 0.0, 0.6);
  vec2 w0 = (1.0 - linear) * f * (-0.5 + f * (1.0 - 0.5 * f));
  vec2 w1 = mix(1.0 + f * f * (-2.5 + 1.5 * f), 1.0 - f, linear);
  vec2 w2 = mix(f * (0.5 + f * (2.0 - 1.5 * f)), f, linear);
  vec2 w3 = (1.0 - linear) * f * f * (-0.5 + 0.5 * f);
  vec2 w12 = w1 + w2;
  vec2 p0 = (middle - 1.0) / size, p12 = (middle + w2 / w12) / size, p3 = (middle + 2.0) / size;
  vec3 light = texture(piece, p12).rgb * (w12.x * w12.y);
  light += texture(piece, vec2(p0.x, p12.y)).rgb * (w0.x * w12.y);
  light += texture(piece, vec2(p3.x, p12.y)).rgb * (w3.x * w12.y);
  light += texture(piece, vec2(p12.x, p0.y)).rgb * (w12.x * w0.y);
  light += texture(piece, vec2(p12.x, p3.y)).rgb * (w12.x * w3.y);
  float taken = w12.x * w12.y + (w0.x + w3.x) * w12.y + w12.x * (w0.y + w3.y);
  return clamp(light / taken, 0.0, 1.0);
}

void main() {
  vec2 place = weightedPlace.xy / weightedPlace.z;
  bool outside = weightedPlace.z <= 0.0 || any(lessThan(place, vec2(0.0))) || any(greaterThan(place, vec2(1.0)));
  colour = vec4(outside ? vec3(0.0) : codeOf(lightAt(place)), 1.0);
}
