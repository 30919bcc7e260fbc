#include "cave/spectator/viewer_model.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "cave/mesh/mesh_builder.h"

namespace carom {
namespace {

constexpr glm::vec3 kWand(0.75F, 0.72F, 0.65F);
constexpr double kLowest_m = 0.5;  // least height of the eyes above the floor for a coat below them

/// Returns a body without arms: a coat, wider than deep.
vtkSmartPointer<vtkPolyData> coat() {
  constexpr std::array<glm::dvec2, 9> kProfile{{{0.0, 0.0},
                                                {0.15, 0.01},
                                                {0.15, 0.06},
                                                {0.125, 0.45},
                                                {0.14, 0.62},
                                                {0.20, 0.78},
                                                {0.17, 0.85},
                                                {0.055, 0.88},
                                                {0.05, 0.97}}};  // radius, height
  constexpr double kDeep = 0.68;
  constexpr int kAround = 40, kUp = 48;
  MeshBuilder mesh;
  mesh.addPatch(kAround, kUp, [&](double u, double v) {
    const double place = v * (kProfile.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(place), kProfile.size() - 2);
    const double share = glm::smoothstep(0.0, 1.0, place - static_cast<double>(i));
    const double radius = glm::mix(kProfile[i].x, kProfile[i + 1].x, share);
    const double height = glm::mix(kProfile[i].y, kProfile[i + 1].y, place - static_cast<double>(i));
    return PatchPoint{{radius * std::cos(2.0 * M_PI * u), kDeep * radius * std::sin(2.0 * M_PI * u), height}};
  });
  return mesh.build();
}

/// Returns a ball where the wand is held, and the wand.
vtkSmartPointer<vtkPolyData> wand() {
  MeshBuilder mesh;
  addEllipsoid(mesh, glm::dvec3(0.0), glm::dvec3(0.035));
  addEllipsoid(mesh, {0.0, 0.13, 0.0}, {0.012, 0.13, 0.012});
  return mesh.build();
}

glm::dmat4 matrixOf(const Pose& pose) {
  return glm::translate(glm::dmat4(1.0), pose.position_m) * glm::mat4_cast(pose.orientation);
}

}  // namespace

ViewerModel makeViewerModel() {
  ViewerModel model{headParts(), {}, {wand(), kWand}};
  const vtkSmartPointer<vtkPolyData> mesh = coat();
  for (std::size_t viewer = 0; viewer < kMostViewers; ++viewer)
    model.coats[viewer] = {mesh, kCoatColours[viewer]};
  return model;
}

ViewerPlaces viewerPlaces(const SeenFrame& seen, const RoomGeometry& room, double floor_m) {
  const glm::dmat4 roomFromViewer(
      glm::dmat3(glm::cross(room.forward, room.up), room.forward, room.up));  // right, forward, up
  const Tracked& tracked = seen.self.tracked;
  const glm::dvec3& eyes_m = seen.self.observer.middle.positionInRoom_m;
  Pose roomFromHead{eyes_m, {1.0, 0.0, 0.0, 0.0}};
  if (tracked.headKnown)
    roomFromHead.orientation = (tracked.roomFromHeadSensor * room.viewers.front().sensorFromEyes).orientation;
  ViewerPlaces places{matrixOf(roomFromHead) * roomFromViewer, {}, {}};
  if (const double height_m = glm::dot(eyes_m, room.up) - floor_m; height_m > kLowest_m) {
    const glm::dvec3 forward = roomFromHead.orientation * room.forward;
    const glm::dvec3 level = forward - room.up * glm::dot(forward, room.up);
    const glm::dvec3 foot_m = eyes_m - height_m * room.up - kBehindEyes_m * level;
    places.roomFromCoat = glm::translate(glm::dmat4(1.0), foot_m) * roomFromViewer *
                          glm::scale(glm::dmat4(1.0), {1.0, 1.0, height_m});
  }
  if (tracked.handKnown) places.roomFromWand = matrixOf(tracked.roomFromHand) * roomFromViewer;
  return places;
}

}  // namespace carom
