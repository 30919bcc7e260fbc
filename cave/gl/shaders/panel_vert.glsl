// A rectangle in the room.
#version 150
uniform mat4 clipFromRoom;
uniform vec3 lowerLeft_m;
uniform vec3 across_m;   // to its lower right
uniform vec3 upwards_m;  // to its upper left
out vec2 place;          // 0 … 1 from its lower left

void main() {
  place = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = clipFromRoom * vec4(lowerLeft_m + place.x * across_m + place.y * upwards_m, 1.0);
}
