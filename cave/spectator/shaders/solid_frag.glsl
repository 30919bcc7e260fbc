// Soft light from above and a lamp beside the camera, so that bodies look round. A model's light, not the
// game's.
#version 150
uniform vec4 material;  // linear light reflected; how much it covers
uniform vec3 camera_m;
uniform vec3 up;
uniform vec3 toLamp;
in vec3 inRoom_m;
in vec3 outwards;
out vec4 colour;

void main() {
  vec3 toCamera = normalize(camera_m - inRoom_m);
  vec3 n = normalize(outwards);
  if (dot(n, toCamera) < 0.0) n = -n;
  float sky = 0.5 + 0.5 * dot(n, up);
  float lamp = max(dot(n, toLamp), 0.0);
  float shine = 0.25 * pow(max(dot(n, normalize(toLamp + toCamera)), 0.0), 40.0);
  vec3 light = material.rgb * (0.25 + 0.45 * sky + 0.75 * lamp) + shine;
  colour = vec4(pow(min(light, 1.0), vec3(1.0 / 2.2)), material.a);
}
