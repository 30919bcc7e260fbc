// Puts the picture where the projector's mesh says.
#version 150
uniform vec2 mirror;  // -1 along a mirrored axis, else 1
in vec2 inWindow;     // 0 … 1 from the lower left
in vec2 inPicture;    // the same
in float weight;      // of the place in the picture, between the points
in float light;       // share that passes
out vec2 windowPlace;
out float passing;
out vec3 weightedPlace;  // times its weight, and the weight
void main() {
  windowPlace = inWindow;
  passing = light;
  weightedPlace = vec3(inPicture * weight, weight);
  gl_Position = vec4(mirror * (inWindow * 2.0 - 1.0), 0.0, 1.0);
}
