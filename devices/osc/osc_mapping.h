#pragma once
// Which messages of Open Sound Control are poses, buttons and axes, as a rig says.

#include <optional>
#include <string_view>
#include <vector>

#include "devices/osc/osc_pattern.h"

namespace carom {

/// The meaning of an argument of a pose.
enum class OscValue { x, y, z, qx, qy, qz, qw, ignored };

/// Reads words such as "x y z qx qy qz qw", one for each argument; "-" stands for an argument without a
/// meaning here. Throws std::invalid_argument unless x, y and z are there once, and all parts of the
/// quaternion once or none.
std::vector<OscValue> readOscValues(std::string_view words);

struct OscMapping {
  std::optional<OscPattern> pose;
  std::vector<OscValue> values;  ///< the arguments of a pose, in order
  double unit_m = 1.0;           ///< of x, y and z
  std::optional<OscPattern> buttons, axes;
};

}  // namespace carom
