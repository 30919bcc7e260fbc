// What a polished surface at rest, the floor and the table's wood, mirrors to the eye.
// Theory: app/doc/physics.md, Colour.
in vec3 mirrorNormal;          // even over a cell
// Uniforms, handed on (body_vert.glsl). Board frame.
flat in vec3 eyeHere_m, lampHere0_m, lampHere1_m, lampHere2_m;
flat in vec4 hallHere_m;       // from its middle to the walls towards x and y; heights of floor and ceiling
flat in float polish;          // Trowbridge and Reitz's α

/// The share that is mirrored at this cosine to the normal (Schlick 1994).
float mirroredAt(float facing, float most) {
  float grazing = 1.0 - facing, grazing2 = grazing * grazing;
  return 0.04 + most * grazing2 * grazing2 * grazing;
}

/// The lamp at this way from the surface, over its light here. Facets are as in highlight.glsl, with
///   (n·h)² = A/B,   A = (n·l + n·e)²,   B = |l + e|² = 2 + 2 l·e.
/// Reflectance and masking are those of the mirror direction: they hardly differ where facets are few.
float mirroredLamp(vec3 toLamp_m, vec3 normal, vec3 toEye, float facing, float inMirror) {
  vec3 toLamp = toLamp_m * inversesqrt(dot(toLamp_m, toLamp_m));
  float square = polish * polish;
  float both = max(dot(normal, toLamp), 0.0) + facing, sum = 2.0 + 2.0 * dot(toLamp, toEye);
  float facets = sum / (both * both * (square - 1.0) + sum);
  return inMirror * facets * facets;
}

/// The lamps, each over its light here. Computed in every pixel, as cells of a mesh are larger than their
/// images. A lamp's light and its mirror image have the same way: the image of light that arrives arrives
/// with it.
vec3 mirroredLamps(vec3 normal, vec3 toEye) {
  float facing = max(dot(normal, toEye), 0.0), square = polish * polish;
  float inMirror = 0.5 * mirroredAt(facing, 0.96) * square / (facing + sqrt(square + facing * facing));
  return vec3(mirroredLamp(lampHere0_m - place, normal, toEye, facing, inMirror),
              mirroredLamp(lampHere1_m - place, normal, toEye, facing, inMirror),
              mirroredLamp(lampHere2_m - place, normal, toEye, facing, inMirror));
}

/// Adds the mirror image of the hall to what the surface reflects. Approximate: walls and ceiling are lit as
/// this place is, and their borders are blurred as if they were some metres away.
vec3 withMirroredHall(vec3 reflects, vec3 normal, vec3 toEye) {
  const float kPerBlur_1_m = 1.5;
  float facing = max(dot(normal, toEye), 0.0);
  vec3 ray = 2.0 * facing * normal - toEye;
  vec2 away = abs(ray.xy), left_m = hallHere_m.xy - place.xy * sign(ray.xy);
  // The nearer wall, without dividing by both: left.x/away.x or left.y/away.y.
  float order = left_m.x * away.y - left_m.y * away.x;
  vec2 nearer = order < 0.0 ? vec2(left_m.x, away.x) : vec2(left_m.y, away.y);
  float height_m = place.z + ray.z * nearer.x / max(nearer.y, 1e-3);
  vec3 wall = mix(ray.x > 0.0 ? kWallX : kWallMinusX, ray.y > 0.0 ? kWallY : kWallMinusY,
                  edge(order * kPerBlur_1_m));
  wall = mix(kDado, wall, edge((height_m - hallHere_m.z - kDado_m) * kPerBlur_1_m));
  vec3 mirrored = mix(0.85 * wall, kCeiling, edge((height_m - hallHere_m.w) * kPerBlur_1_m));
  return mix(reflects, mirrored, mirroredAt(facing, 0.96 - polish));
}
