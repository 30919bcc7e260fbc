// A pixel of a curved screen's window, from the picture of a flat wall.
#version 150
uniform sampler2D piece;  // sRGB encoded; the filter between texels is off
uniform vec2 size_px;     // of the piece
uniform vec2 texel_1;     // a texel, as a share of it
in vec3 weightedPlace;
out vec4 colour;

// Light of a code c as c²(0.73 + 0.27 c), within 0.0026 of sRGB's (IEC 61966-2-1), and the code of light by the
// cubic in its root that is the inverse, within a sixteenth of a code (least squares): in software this takes a
// fraction of the time of powers.
vec3 lightOf(vec3 code) { return code * code * (0.73 + 0.27 * code); }
vec3 codeOf(vec3 light) {
  vec3 root = sqrt(light);
  return root * (1.165082 + root * (-0.216115 + 0.051222 * root));
}

// The light of the texel with these indices and a half.
vec3 texel(float x, float y) { return lightOf(textureLod(piece, vec2(x, y) * texel_1, 0.0).rgb); }

// The cubic of Catmull and Rom through four texels each way; where more than 1.25 of them are shown by a
// pixel it would raise the contrast of fine stripes, and is mixed with the linear filter. Of the twelve texels
// round the inner four only four are read, the nearest on each side: to the next one outwards, light is taken
// to change by as much as beside it. This is exact where the light is a sum of one part that changes across
// and one that changes upwards; what it neglects has a sixteenth of the weight at most.
vec3 lightAt(vec2 place) {
  vec2 at = place * size_px, t1 = floor(at - 0.5) + 0.5, f = at - t1, t2 = t1 + 1.0;
  vec2 shown2 = dFdx(at) * dFdx(at) + dFdy(at) * dFdy(at);  // texels, squared
  vec2 cubic = 1.0 - clamp(0.71 * (shown2 - 1.5625), 0.0, 0.6);
  vec2 before = cubic * f * (-0.5 + f * (1.0 - 0.5 * f)), after = cubic * f * f * (-0.5 + 0.5 * f);
  vec2 second = mix(f, f * (0.5 + f * (1.5 - f)), cubic);  // with what is beyond it; the first has the rest
  vec3 p11 = texel(t1.x, t1.y), p21 = texel(t2.x, t1.y), p12 = texel(t1.x, t2.y), p22 = texel(t2.x, t2.y);
  bool isLeft = f.x < 0.5, isLow = f.y < 0.5;
  vec2 nearest = vec2(isLeft ? t1.x : t2.x, isLow ? t1.y : t2.y);
  vec3 light = mix(mix(p11, p21, second.x), mix(p12, p22, second.x), second.y);
  light += before.x * (texel(t1.x - 1.0, nearest.y) - (isLow ? p11 : p12));
  light += after.x * (texel(t2.x + 1.0, nearest.y) - (isLow ? p21 : p22));
  light += before.y * (texel(nearest.x, t1.y - 1.0) - (isLeft ? p11 : p21));
  light += after.y * (texel(nearest.x, t2.y + 1.0) - (isLeft ? p12 : p22));
  return clamp(light, 0.0, 1.0);
}

void main() {
  vec2 place = weightedPlace.xy / max(weightedPlace.z, 1e-9);  // behind the eye: far outside
  bool outside = any(greaterThan(abs(place - 0.5), vec2(0.5)));
  colour = vec4(outside ? vec3(0.0) : codeOf(lightAt(place)), 1.0);
}
