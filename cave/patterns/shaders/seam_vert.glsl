// A corner of a screen: its place in the window, and in the room.
#version 150
in vec2 inWindow;  // 0 … 1 from the lower left
in vec3 inRoom_m;
out vec3 room_m;
void main() {
  room_m = inRoom_m;
  gl_Position = vec4(inWindow * 2.0 - 1.0, 0.0, 1.0);
}
