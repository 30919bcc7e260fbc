// Darkens what lies outside a cone around the direction of sight, and the whole picture.
#version 150
in vec3 to_m;
in float ahead_m;
flat in vec4 cone;
out vec4 colour;

void main() {
  float off_rad = acos(clamp(ahead_m * inversesqrt(dot(to_m, to_m)), -1.0, 1.0));
  float beyond = clamp((off_rad - cone.x) * cone.y, 0.0, 1.0);
  colour = vec4(0.0, 0.0, 0.0, max(cone.z * beyond * beyond * (3.0 - 2.0 * beyond), cone.w));
}
