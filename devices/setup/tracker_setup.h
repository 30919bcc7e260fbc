#pragma once
// What a rig file says of one tracker.

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "engine/base/pose.h"

namespace carom {

enum class TrackerKind {
  simulated,  ///< made up by the program
  recorded,   ///< played from a trace
  vrpn,
  dtrack,
  natnet,
  polhemusUsb,
  hidImu,
  spaceMouse,  ///< buttons and axes, no poses
};

/// As rig files name them, in the order of TrackerKind.
inline constexpr std::array<std::string_view, 8> kTrackerKinds{
    "simulated", "recorded", "vrpn", "dtrack", "natnet", "polhemus-usb", "hid-imu", "spacemouse"};
inline std::string_view toString(TrackerKind kind) { return kTrackerKinds[static_cast<std::size_t>(kind)]; }

/// Where eyes are above the floor, until a tracker has said otherwise.
inline constexpr double kStandingEyes_m = 1.7;

struct TrackerSetup {
  std::string name;
  TrackerKind kind = TrackerKind::simulated;
  double latency_s = 0.0;        ///< known age of its samples where they do not say it themselves
  bool still = false;            ///< of a simulated one: the person does not move
  std::filesystem::path source;  ///< of a recorded one: the trace; exists. Of a device: its address
  Pose roomFromTracker;
  bool buttonsAlone = false;  ///< the hand's buttons are all that the rig takes of it
};

}  // namespace carom
