// A body in the view of the room from outside.
#version 150
uniform mat4 clipFromRoom;
uniform mat4 roomFromModel;
uniform mat3 normalsToRoom;
in vec3 place_m;
in vec3 normal;
out vec3 inRoom_m;
out vec3 outwards;

void main() {
  vec4 room_m = roomFromModel * vec4(place_m, 1.0);
  inRoom_m = room_m.xyz;
  outwards = normalsToRoom * normal;
  gl_Position = clipFromRoom * room_m;
}
