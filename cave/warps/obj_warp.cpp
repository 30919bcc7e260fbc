#include <utility>

#include "cave/mesh_files/obj_file.h"
#include "cave/mesh_files/warp_grid.h"
#include "cave/warps/warp_formats.h"
#include "engine/text/outside_file.h"

namespace carom {

Warp parseObjWarp(std::string_view content) {
  const ObjWishes wishes{.coordinates = 2,  // the window is flat
                         .farthest = kFarthestInWindow,
                         .farthestInPicture = kFarthestInWindow,
                         .isPaired = true,
                         .mostPoints = limitOf(InputKind::warp).most_MiB << 20U};  // a point takes a byte
  const ObjFile file = parseObj(content, wishes);
  WarpMesh mesh;
  for (std::size_t i = 0; i < file.points.size(); ++i)
    mesh.points.push_back({.inWindow = glm::vec2(0.5 * (glm::dvec2(file.points[i]) + 1.0)),
                           .inPicture = glm::vec2(file.inPicture[i])});
  for (const auto& [a, b, c] : file.triangles) mesh.triangles.push_back({a.point, b.point, c.point});
  return {mesh, mesh};
}

}  // namespace carom
