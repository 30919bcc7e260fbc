// A pixel of a curved screen's window, from the picture of a flat wall.
#version 150
uniform sampler2D piece;  // decoded to light
uniform vec2 texel_1;     // a texel, as a share of it
in vec3 weightedPlace;
out vec4 colour;

// sRGB, IEC 61966-2-1, its power of 1/2.4 by roots of two, a quarter of a code off at most, which in software
// takes a fraction of the time (I. Taylor, "sRGB approximations for HLSL", 2012).
vec3 codeOf(vec3 light) {
  vec3 low = light * 12.92, s2 = sqrt(light), s4 = sqrt(s2), s8 = sqrt(s4);
  vec3 high = 0.662002687 * s2 + 0.684122060 * s4 - 0.323583601 * s8 - 0.0225411470 * light;
  return mix(high, low, vec3(lessThanEqual(light, vec3(0.0031308))));
}

// The texel with these indices, as light; the filter between texels is off.
vec3 texel(float x, float y) { return texture(piece, vec2(x, y) * texel_1).rgb; }

// The cubic of Catmull and Rom through four texels each way; where more than 1.25 of them are shown by a
// pixel it would raise the contrast of fine stripes, and is mixed with the linear filter. The four texels in
// the corners, whose weights are below 0.006, are left out (J. Jimenez, "Filmic SMAA", SIGGRAPH 2016). Twelve
// texels take less time in software than five places between them that the sampler filters.
vec3 lightAt(vec2 place) {
  vec2 at = place / texel_1, t1 = floor(at - 0.5) + 0.5, f = at - t1;
  vec2 shown = sqrt(dFdx(at) * dFdx(at) + dFdy(at) * dFdy(at));
  vec2 linear = clamp(2.0 * (shown - 1.25), 0.0, 0.6);
  vec2 w0 = (1.0 - linear) * f * (-0.5 + f * (1.0 - 0.5 * f));
  vec2 w1 = mix(1.0 + f * f * (-2.5 + 1.5 * f), 1.0 - f, linear);
  vec2 w2 = mix(f * (0.5 + f * (2.0 - 1.5 * f)), f, linear);
  vec2 w3 = (1.0 - linear) * f * f * (-0.5 + 0.5 * f);
  vec2 t0 = t1 - 1.0, t2 = t1 + 1.0, t3 = t1 + 2.0;
  vec3 light = w1.y * (w0.x * texel(t0.x, t1.y) + w1.x * texel(t1.x, t1.y) + w2.x * texel(t2.x, t1.y) +
                       w3.x * texel(t3.x, t1.y));
  light += w2.y * (w0.x * texel(t0.x, t2.y) + w1.x * texel(t1.x, t2.y) + w2.x * texel(t2.x, t2.y) +
                   w3.x * texel(t3.x, t2.y));
  light += w0.y * (w1.x * texel(t1.x, t0.y) + w2.x * texel(t2.x, t0.y));
  light += w3.y * (w1.x * texel(t1.x, t3.y) + w2.x * texel(t2.x, t3.y));
  return clamp(light / (w1.y + w2.y + (w0.y + w3.y) * (w1.x + w2.x)), 0.0, 1.0);
}

void main() {
  vec2 place = weightedPlace.xy / weightedPlace.z;
  bool outside = weightedPlace.z <= 0.0 || any(lessThan(place, vec2(0.0))) || any(greaterThan(place, vec2(1.0)));
  colour = vec4(outside ? vec3(0.0) : codeOf(lightAt(place)), 1.0);
}
