// The shadow of glass: what it lets through of the light of a wide lamp. The higher it is, the paler is its
// shadow.
#version 150
in float overPresent_m;
uniform vec3 colour;
uniform vec4 look;  // taken, …, ahead (cave/sculpture/glass_drawer.h)
uniform vec2 heights_m;  // of the present, and of the top
out vec4 light;

const float kDarkness = 0.5, kPaler = 0.7;

void main() {
  float height = (overPresent_m + heights_m.x) / heights_m.y;
  float share = (overPresent_m > 0.0 ? look.w : 1.0) * (1.0 - kPaler * height);
  light = vec4(mix(vec3(1.0), kDarkness * colour, share * look.x), 1.0);
}
