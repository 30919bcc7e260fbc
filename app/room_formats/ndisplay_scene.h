#pragma once
// The tree of transforms, cameras and screens of an nDisplay configuration, in either of its formats.
// Unreal's axes are x forward, y right, z up, left-handed; rotations are pitch, yaw and roll.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "app/room_checks/room.h"
#include "app/room_parts/room_parts.h"
#include "app/toml/input_file.h"

namespace carom {

/// A place in Unreal's axes; `matrix` has the directions of its x, y and z as columns.
struct UnrealPlace {
  glm::dvec3 position_m{0.0};
  glm::dmat3 matrix{1.0};
};

/// Returns the matrix of a rotation by angles in degrees, as Unreal's FRotator makes it.
glm::dmat3 unrealRotation(double pitch_deg, double yaw_deg, double roll_deg);

/// Returns a point or direction of Unreal's axes with x right, y up, z back.
inline glm::dvec3 turned(const glm::dvec3& v) { return {v.y, v.z, -v.x}; }

/// A component of the tree.
struct SceneNode {
  std::string id, parent;
  UnrealPlace local{};
  double width_m = 0.0, height_m = 0.0;  ///< of a screen
  bool isTracked = false;
  bool isCamera = false;
  FilePlace at{}, parentAt{};
};

class NdisplayScene {
 public:
  explicit NdisplayScene(Room& room) : room_(room) {}

  /// Adds a component; a second of one name is an error.
  void add(SceneNode node);
  /// Returns a component, or null.
  const SceneNode* find(const std::string& id) const;
  /// Returns the place of a component in the room; nothing, with an error noted, if a parent is missing or it
  /// is its own ancestor.
  std::optional<UnrealPlace> placeOf(const std::string& id);
  /// Returns the corners of a screen, or nothing with an error noted.
  std::optional<ReadCorners> cornersOf(const std::string& screen);
  /// Warns of each component that carries none of the screens and is neither a screen itself nor `head`: it
  /// is left out.
  void tellUnused(const std::vector<std::string>& screens, const std::string& head) const;
  /// Returns whether a component hangs on another, directly or through others.
  bool hangsOn(const std::string& id, const std::string& ancestor) const;

 private:
  Room& room_;
  std::map<std::string, SceneNode> nodes_;
  std::set<std::string> refused_;
};

}  // namespace carom
