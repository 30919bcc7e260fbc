// What a polished surface at rest, the floor and the table's wood, mirrors to the eye.
// Theory: app/doc/physics.md, Colour.
in vec3 drawnFromEye_m;
in vec3 mirrorNormal;
uniform mat4 boardFromDrawn;
uniform vec3 eyeOnBoard_m;
uniform vec4 hall_m;           // from its middle to the walls towards x and y; heights of floor and ceiling
uniform vec3 hallColours[5];   // of the walls towards x, −x, y, −y, and of the ceiling

/// The way from the eye to where the pixel's ray meets the plane of its cell. Between the vertices of a cell
/// the place on the board is no linear function of the place in the picture.
vec3 seenOnBoard_m(vec3 normal) {
  vec3 toCell_m = place - eyeOnBoard_m;
  if (!ABERRATED) return toCell_m;
  vec3 ray = (boardFromDrawn * vec4(-length(drawnFromEye_m), drawnFromEye_m)).yzw;
  return ray * (dot(toCell_m, normal) / min(dot(ray, normal), -1e-3 * length(ray)));
}

/// The lamps, each over its light here. Computed in every pixel, as cells of a mesh are larger than their
/// images. A lamp's light and its mirror image have the same way: the image of light that arrives arrives
/// with it.
vec3 mirroredLamps(vec3 normal, vec3 toEye) {
  return vec3(highlight(normal, normalize(lampsFromEye_m[0] - fromEyeOnBoard_m), toEye),
              highlight(normal, normalize(lampsFromEye_m[1] - fromEyeOnBoard_m), toEye),
              highlight(normal, normalize(lampsFromEye_m[2] - fromEyeOnBoard_m), toEye));
}

/// Adds the mirror image of the hall to what the surface reflects. Approximate: walls and ceiling as if this
/// place's light fell on them, blurred by the surface's roughness.
vec3 withMirroredHall(vec3 reflects, vec3 normal, vec3 toEye) {
  float facing = max(dot(normal, toEye), 0.0);
  float grazing = 1.0 - facing, grazing2 = grazing * grazing;
  float share = 0.04 + (0.96 - roughness) * grazing2 * grazing2 * grazing;
  vec3 ray = 2.0 * facing * normal - toEye;
  vec3 from_m = eyeOnBoard_m + fromEyeOnBoard_m;
  vec2 ways_m = (hall_m.xy - from_m.xy * sign(ray.xy)) / max(abs(ray.xy), 1e-3);
  float way_m = min(ways_m.x, ways_m.y);
  float perBlur = 1.0 / (0.02 + 2.0 * roughness * way_m);
  vec3 wall = mix(ray.x > 0.0 ? hallColours[0] : hallColours[1], ray.y > 0.0 ? hallColours[2] : hallColours[3],
                  edge((ways_m.x - ways_m.y) * perBlur));
  float height_m = from_m.z + way_m * ray.z;
  wall = mix(kDado, wall, edge((height_m - hall_m.z - kDado_m) * perBlur));
  vec3 mirrored = mix(0.85 * wall, hallColours[4], edge((height_m - hall_m.w) * perBlur));
  return mix(reflects, mirrored, share);
}
