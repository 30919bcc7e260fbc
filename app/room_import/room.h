#pragma once
// A room as one file describes it, whatever the format: what room_check judges, `carom check` prints and
// `carom import` writes as a rig. Metres, in the room's axes; every part knows its place in the file.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "app/files/input_file.h"
#include "app/files/rig.h"

namespace carom {

/// Something wrong or odd about a file.
struct Finding {
  enum class Kind { warning, error };
  Kind kind = Kind::warning;
  FilePlace at;
  std::string text;
};

struct RoomWall {
  Wall wall;
  WallPlaces at;
};

/// Where the file has the person's eyes.
struct Viewer {
  glm::dvec3 eyes_m{0.0};  ///< midway between them
  FilePlace at;
  std::string words;  ///< "the recorded head at its start"
};

struct Room {
  std::filesystem::path file;
  std::string title;
  std::string format;  ///< "a rig", "a ParaView room"
  RoomAxes axes;
  std::vector<RoomWall> walls;
  std::vector<NodeSetup> nodes;
  std::vector<FilePlace> nodesAt;  ///< of each node
  std::optional<WindowPlacement> oneWindow;
  double eyeSeparation_m = 0.064;
  FilePlace eyeSeparationAt;
  double unit_m = 1.0;  ///< of the file's lengths
  Viewer viewer;
  /// Height of the floor along axes.up, where the file's format fixes it; a wall that is a floor goes before.
  std::optional<double> floor_m;
  std::vector<std::string> assumptions;  ///< what the file leaves open and how it was taken
  std::vector<Finding> findings;         ///< of the reader

  bool hasErrors() const {
    for (const Finding& finding : findings) {
      if (finding.kind == Finding::Kind::error) return true;
    }
    return false;
  }
};

}  // namespace carom
