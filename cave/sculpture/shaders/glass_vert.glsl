// A corner of the glass of spacetime: an event of the board, where it stands in the room.
#version 150
in vec3 event;  // x, y, c t
uniform mat4 drawnFromEvent;
uniform mat4 clipFromDrawn;
uniform vec4 heightOfEvent;
uniform vec2 heights_m;  // of the present, and of the top
out vec3 drawnHere;
out float overPresent_m;

void main() {
  vec4 drawn = drawnFromEvent * vec4(event, 1.0);
  float height_m = dot(heightOfEvent, vec4(event, 1.0));
  gl_Position = clipFromDrawn * drawn;
  gl_ClipDistance[0] = height_m;
  gl_ClipDistance[1] = heights_m.y - height_m;
  drawnHere = drawn.xyz;
  overPresent_m = height_m - heights_m.x;
}
