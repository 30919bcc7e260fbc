#pragma once
// The state while an SGCT room file is read.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "app/room_checks/room.h"
#include "app/room_import/json_tree.h"

namespace carom {

struct SgctUser {
  std::string name;
  double eyeSeparation_m = 0.06;  ///< SGCT's default
  glm::dvec3 eyes_m{0.0};
  FilePlace at, eyeSeparationAt;
};

/// The settings of a window that apply to all its viewports.
struct SgctWindow {
  const JsonNode& node;
  int rank = 0;
  glm::dvec2 position_px{0.0}, size_px{0.0}, picture_px{0.0};
  int monitor = 0;
  bool fullscreen = false;
  StereoMode stereo = StereoMode::mono;
  Flip flip = Flip::none;
};

struct SgctReading {
  /// The placement of a whole window.
  struct Place {
    glm::dvec2 position_px, size_px;
    int monitor = 0;
    bool fullscreen = false;
  };

  JsonNode root;
  Room room;
  std::vector<SgctUser> users = {};
  bool stereoLeftOut = false;  ///< a window has not given its stereo mode
  int ranks = 0;
  int windows = 0;
  std::vector<int> ofWindow = {};  ///< window index of each wall
  std::vector<Place> places = {};  ///< of the whole window of each wall
};

}  // namespace carom
