#pragma once
// A room as described by a file of any format: room_check checks it, `carom check` prints it, and `carom
// import` writes it as a rig. Metres, in the room's axes; every part has its position in the file.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "app/rig/rig.h"
#include "app/toml/findings.h"

namespace carom {

struct RoomWall {
  Wall wall;
  WallPlaces at;
};

/// The position of the viewer's eyes according to the file.
struct Viewer {
  glm::dvec3 eyes_m{0.0};  ///< midpoint of the eyes
  FilePlace at;
  std::string words;  ///< "the recorded head at its start"
};

/// Somebody who is tracked according to the file.
struct Person {
  /// The tracker of head and hand is an index into Room::trackers.
  ViewerSetup setup;
  bool isTracked = false;  ///< otherwise a simulated person stands for them
};

/// A file that a rig needs beside it.
struct RoomFile {
  std::string name;
  std::shared_ptr<const std::string> content;
};

struct Room {
  std::filesystem::path file;
  std::string title;
  std::string format;  ///< "a rig", "a ParaView room"
  RoomAxes axes;
  std::string unit = "m";  ///< in which a rig of it is written
  std::vector<RoomWall> walls;
  std::vector<NodeSetup> nodes;
  std::vector<FilePlace> nodesAt;  ///< one for each node
  std::optional<WindowPlacement> oneWindow;
  double eyeSeparation_m = 0.064;
  FilePlace eyeSeparationAt;
  double unit_m = 1.0;          ///< of the lengths in the file
  std::vector<Viewer> viewers;  ///< one at least
  std::vector<Person> people;   ///< empty, or one for each of `viewers`
  std::vector<TrackerSetup> trackers;
  /// Whether a rig's origin goes beneath the viewer; otherwise it only goes up or down to the floor.
  bool originUnderViewer = true;
  /// Height of the floor along axes.up if the file's format defines it; a wall that is a floor takes
  /// precedence.
  std::optional<double> floor_m;
  std::vector<std::string> assumptions;  ///< what the file leaves open and the value assumed
  std::vector<RoomFile> files;           ///< that its walls name, without a folder
  FindingList findings;                  ///< of the reader

  /// Returns whose eyes look at the wall.
  const Viewer& viewerOf(const Wall& wall) const { return viewers.at(wall.viewer); }
  bool hasErrors() const {
    for (const Finding& finding : findings) {
      if (finding.kind == Finding::Kind::error) return true;
    }
    return false;
  }
};

}  // namespace carom
