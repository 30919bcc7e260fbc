// The planes of the room that move along its axes, where they cut a wall: x in red, y in green, z in blue.
#version 150
uniform vec3 first_m;      // where one plane of each axis is now
uniform float period_m;    // from plane to plane
uniform float halfLine_m;  // of a line, in the wall
in vec3 room_m;  // of the pixel's place on the screen
out vec4 colour;

void main() {
  vec3 normal = normalize(cross(dFdx(room_m), dFdy(room_m)));
  for (int axis = 0; axis < 3; ++axis) {
    // How fast the coordinate grows in the wall, at most; a plane nearly along the wall would flood it.
    float slope = sqrt(max(1.0 - normal[axis] * normal[axis], 0.0));
    float planes = (room_m[axis] - first_m[axis]) / period_m;
    float off_m = abs(planes - round(planes)) * period_m;
    colour[axis] = slope > 0.1 && off_m < halfLine_m * slope ? 1.0 : 0.0;
  }
  colour.a = 1.0;
}
