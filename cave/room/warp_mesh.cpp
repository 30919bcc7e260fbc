#include "cave/room/warp_mesh.h"

namespace carom {

Warp straightWarp() {
  WarpMesh mesh;
  for (const glm::vec2 corner : {glm::vec2(0, 0), {1, 0}, {0, 1}, {1, 1}})
    mesh.points.push_back({.inWindow = corner, .inPicture = corner});
  mesh.triangles = {{0, 1, 2}, {2, 1, 3}};
  return {mesh, mesh};
}

Warp skewWarp(const SkewedScreen& screen) {
  const glm::dmat3 pictureOf = pictureFromWindow(screen);
  Warp warp = straightWarp();
  for (WarpMesh* mesh : {&warp.left, &warp.right}) {
    for (WarpPoint& point : mesh->points) {
      const glm::dvec3 place = pictureOf * glm::dvec3(glm::dvec2(point.inWindow), 1.0);
      point.inPicture = glm::vec2(glm::dvec2(place) / place.z);
      point.weight = static_cast<float>(place.z);
    }
  }
  return warp;
}

}  // namespace carom
