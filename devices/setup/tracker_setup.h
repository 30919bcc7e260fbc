#pragma once
// The description of one tracker in a rig file.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "devices/osc/osc_mapping.h"
#include "engine/base/pose.h"

namespace carom {

enum class TrackerKind {
  simulated,  ///< made up by the program
  recorded,   ///< played from a trace
  vrpn,
  dtrack,
  natnet,
  qtm,
  trackd,
  survive,
  osc,
  polhemusUsb,
  hidImu,
  spaceMouse,  ///< buttons and axes, no poses
  headset,     ///< in rigs of a headset alone, which a session follows itself (app/viewer/headset_tracker.h)
};

/// Returns the name in rig files.
std::string_view toString(TrackerKind kind);

/// The height of the eyes above the floor until a tracker has delivered.
inline constexpr double kStandingEyes_m = 1.7;

/// What a simulated person does (devices/tracker/simulated_tracker.h).
enum class SimulatedMotion { moves, still, walks };

struct TrackerSetup {
  std::string name;
  TrackerKind kind = TrackerKind::simulated;
  double latency_s = 0.0;  ///< known age of its samples, if they do not carry it themselves
  SimulatedMotion person = SimulatedMotion::moves;  ///< of a simulated tracker
  std::uint64_t seed = 1;        ///< of a simulated tracker: people with different seeds walk differently
  std::filesystem::path source;  ///< recorded tracker: the trace, which exists. Device: its address
  bool start = false;            ///< for DTRACK: the session starts and stops the measurement
  double unit_m = 1.0;           ///< for trackd: of the lengths that its daemon writes
  /// For QTM and libsurvive: the names of sensors 0, 1, …; empty: all that they have, in their order.
  std::vector<std::string> names{};
  OscMapping osc{};  ///< for OSC: which of its messages are what
  Pose roomFromTracker;
  bool buttonsAlone = false;  ///< the rig uses only the buttons, for the hand
};

}  // namespace carom
