// A vertex of a body: from its place in the body's rest frame to where the eye sees it, and how it is lit there.

in vec4 vertexMC;   // from the body's centre, in its rest frame (metres)
in vec3 normalMC;
in vec3 surfaceMC;  // for painting

uniform int firstLeg;          // of this body, in legTexels
uniform int legCount;         // reached as LEG_COUNT: 1 for what rests
uniform float appears_m;       // c (t − t_o) before which the body did not exist
uniform mat4 clipFromHead;     // head frame, from the eye
uniform mat4 boardFromHead;    // displacements (c t, x, y, z)
uniform vec3 eyeOnBoard_m;     // where the eye receives the light
uniform vec3 lamps_m[3];       // at rest on the board
uniform float gloss;
uniform float nearer;          // share by which decals are drawn nearer than they are

out vec3 place;       // vertexMC, for painting
out vec3 surface;
out vec3 light;       // received by the surface: times its colour is what it sends to the eye (linear)
out float shine;      // mirrored to the eye by its varnish
out float boardTime_m;  // c (t − t_o) of the emission

const vec3 kLampColour = vec3(1.0, 0.90, 0.76);
const float kLampStrength_m2 = 1.1;  // light on a surface at 1 m that faces the lamp

/// The direction (in the body's rest frame, u = γβ its motion) in which light travels that travels along
/// `direction` on the board: aberration, a rotation-free boost of the light's four-vector (1, direction).
vec3 inBodyFrame(vec3 direction, float gamma, vec3 u) {
  return (direction + u * (dot(u, direction) / (gamma + 1.0) - 1.0)) / (gamma - dot(u, direction));
}

/// The hall's own light: soft, from above more than from below.
vec3 hallLight(vec3 normal) { return mix(vec3(0.34, 0.32, 0.29), vec3(0.66, 0.66, 0.68), 0.5 + 0.5 * normal.z); }

void main() {
  vec3 d = vertexMC.xyz;
  VertexEmission emission = solveEmission(firstLeg, LEG_COUNT, d);
  LegView leg = legAt(firstLeg, emission.leg);
  vec3 seen = seenFromEye(leg, emission.event);
  boardTime_m = boardTimeOf(leg, emission.event);
#ifdef CLOCK
  // A clock shows one time: when light left the middle of its face, a rectangle of width surfaceMC.z.
  vec2 fromMiddle = (surfaceMC.xy / vec2(4.0, 1.0) - 0.5) * surfaceMC.z * vec2(1.0, 0.4);
  vec3 right = cross(vec3(0.0, 0.0, 1.0), normalMC);
  VertexEmission middle = solveEmission(firstLeg, LEG_COUNT, d - right * fromMiddle.x - vec3(0.0, 0.0, fromMiddle.y));
  boardTime_m = boardTimeOf(legAt(firstLeg, middle.leg), middle.event);
#endif

  gl_Position = clipFromHead * vec4(seen * (1.0 - nearer), 1.0);
  gl_ClipDistance[0] = boardTime_m - appears_m;

  vec3 fromEye_m = (boardFromHead * vec4(-length(seen), seen)).yzw;
  vec3 onBoard_m = eyeOnBoard_m + fromEye_m;
  // A vertex that is catching up is lit as on its incoming leg: its colour must not flash.
  if (emission.catchingUp) leg = legAt(firstLeg, emission.leg - 1);
  float gamma = leg.toBoardTime.x;  // its first row takes (c t, x) to γ (c t + β·x)
  vec3 u = leg.toBoardTime.yzw;
  vec3 toEye = inBodyFrame(normalize(-fromEye_m), gamma, u);
  vec3 normal = normalMC * inversesqrt(max(dot(normalMC, normalMC), 1e-12));  // a spike of a mesh may have none

  light = hallLight(normal);
  shine = 0.0;
  for (int i = 0; i < 3; ++i) {
    vec3 ray = onBoard_m - lamps_m[i];
    vec3 toLamp = -inBodyFrame(normalize(ray), gamma, u);
    float strength = kLampStrength_m2 / (dot(ray, ray) + 0.3);
    float facing = max(dot(normal, toLamp), 0.0);
    light += kLampColour * (strength * facing);
    float mirrored = max(dot(normal, normalize(toLamp + toEye)), 0.0);
    shine += facing > 0.0 ? gloss * strength * pow(mirrored, 60.0) : 0.0;
  }
  place = d;
  surface = surfaceMC;
}
