// What leaves a projector. Light is counted as a share of the brightest.
#version 150
uniform sampler2D picture;  // sRGB encoded
uniform sampler2D blend;    // shares of light
uniform float black;        // light
uniform vec3 gain;          // light of white
uniform vec3 gamma;         // of the projector; 0: sRGB
in vec2 windowPlace;
in vec3 weightedPlace;
in float passing;  // share of the light, of the mesh
out vec4 colour;

// sRGB, IEC 61966-2-1.
vec3 lightOf(vec3 code) {
  vec3 low = code / 12.92;
  vec3 high = pow((code + 0.055) / 1.055, vec3(2.4));
  return mix(high, low, vec3(lessThanEqual(code, vec3(0.04045))));
}
vec3 codeOf(vec3 light) {
  if (gamma.x > 0.0) return pow(light, 1.0 / gamma);
  vec3 low = light * 12.92;
  vec3 high = 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055;
  return mix(high, low, vec3(lessThanEqual(light, vec3(0.0031308))));
}

void main() {
  vec2 picturePlace = weightedPlace.xy / weightedPlace.z;
  bool outside = any(lessThan(picturePlace, vec2(0.0))) || any(greaterThan(picturePlace, vec2(1.0)));
  vec3 light = outside ? vec3(0.0) : lightOf(texture(picture, picturePlace).rgb);
  light = black + (gain - black) * texture(blend, windowPlace).rgb * passing * light;
  colour = vec4(codeOf(light), 1.0);
}
