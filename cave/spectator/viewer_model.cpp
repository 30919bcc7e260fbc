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

constexpr glm::vec3 kWand(0.75F, 0.72F, 0.65F), kTrousers(0.035F, 0.038F, 0.05F),
    kShoes(0.018F, 0.013F, 0.01F);
constexpr double kLowest_m = 0.5;  // least height of the eyes above the floor for a coat below them

// Heights are in units of the eyes' height, about 1.6 m: round things are flattened in these units.
constexpr double kHip = 0.53, kShoulder = 0.825;

/// Returns a jacket: its trunk, wider than deep, and arms that hang down, the hands a little forward.
vtkSmartPointer<vtkPolyData> coat() {
  constexpr std::array<glm::dvec2, 8> kProfile{{{0.0, 0.485},
                                                {0.165, 0.487},
                                                {0.163, 0.54},
                                                {0.142, 0.63},
                                                {0.172, 0.75},
                                                {0.178, 0.81},
                                                {0.13, 0.86},
                                                {0.055, 0.885}}};  // radius, height
  constexpr double kDeep = 0.62;
  constexpr int kAround = 40, kUp = 56;
  MeshBuilder mesh;
  mesh.addPatch(kAround, kUp, [&](double u, double v) {
    const double place = v * (kProfile.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(place), kProfile.size() - 2);
    const double share = glm::smoothstep(0.0, 1.0, place - static_cast<double>(i));
    const double radius = glm::mix(kProfile[i].x, kProfile[i + 1].x, share);
    const double height = glm::mix(kProfile[i].y, kProfile[i + 1].y, place - static_cast<double>(i));
    return PatchPoint{{radius * std::cos(2.0 * M_PI * u), kDeep * radius * std::sin(2.0 * M_PI * u), height}};
  });
  for (const double side : {-1.0, 1.0}) {
    const glm::dvec3 shoulder(side * 0.185, 0.0, kShoulder), elbow(side * 0.235, -0.035, 0.66),
        wrist(side * 0.215, 0.075, 0.535);
    addEllipsoid(mesh, shoulder, {0.056, 0.06, 0.036});
    addLimb(mesh, shoulder, elbow, 0.053, 0.044);
    addEllipsoid(mesh, elbow, {0.044, 0.044, 0.0275});
    addLimb(mesh, elbow, wrist, 0.044, 0.033);
  }
  return mesh.build();
}

/// Returns what does not have the viewer's own colour.
std::vector<ModelPart> belowCoat() {
  MeshBuilder skin, trousers, shoes;
  addLimb(skin, {0.0, -0.005, 0.86}, {0.0, 0.0, 0.965}, 0.056, 0.052);
  addEllipsoid(trousers, {0.0, 0.0, kHip - 0.02}, {0.162, 0.10, 0.06});
  for (const double side : {-1.0, 1.0}) {
    const glm::dvec3 hip(side * 0.082, 0.0, kHip - 0.02), knee(side * 0.092, 0.012, 0.285),
        ankle(side * 0.098, -0.012, 0.04);
    addLimb(trousers, hip, knee, 0.085, 0.062);
    addEllipsoid(trousers, knee, {0.062, 0.062, 0.04});
    addLimb(trousers, knee, ankle, 0.062, 0.05);
    addEllipsoid(shoes, ankle + glm::dvec3(0.0, 0.052, -0.014), {0.05, 0.135, 0.026});
    addEllipsoid(skin, {side * 0.213, 0.098, 0.512}, {0.03, 0.042, 0.034});
  }
  return {{skin.build(), kSkin}, {trousers.build(), kTrousers}, {shoes.build(), kShoes}};
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
  ViewerModel model{headParts(), {}, belowCoat(), {wand(), kWand}};
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
