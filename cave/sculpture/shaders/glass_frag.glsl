// Glass: the share of the light behind it that it lets through, or the light that it adds. A surface that is
// seen along itself is thicker. Tubes have flat sides: those at their borders, seen along themselves,
// come and go from place to place, and look as their neighbours do.
#version 150
in vec3 drawnHere;  // from the eye
in float overPresent_m;
uniform vec3 colour;
uniform vec4 look;  // taken, shine, edge, ahead (cave/sculpture/glass_drawer.h)
uniform int adds;
out vec4 light;

const float kBorder = 0.55;  // how far along itself a side counts as seen at most

void main() {
  vec3 normal = cross(dFdx(drawnHere), dFdy(drawnHere));
  float size = dot(normal, normal) * dot(drawnHere, drawnHere);
  float facing = abs(dot(normal, drawnHere)) * inversesqrt(max(size, 1e-30));
  float along = min(1.0 - min(facing, 1.0), kBorder) / kBorder;
  float share = overPresent_m > 0.0 ? look.w : 1.0;
  if (adds == 1) {
    light = vec4(colour * (share * mix(look.y, look.z, along * along)), 1.0);
  } else {
    light = vec4(mix(vec3(1.0), colour, share * look.x * (0.5 + 0.5 * along)), 1.0);
  }
}
