#pragma once
// The findings about a room while it is checked.

#include <string>
#include <utility>
#include <vector>

#include "app/room_checks/room.h"

namespace carom {

struct Verdict {
  const Room& room;
  FindingList findings;

  void fail(FilePlace at, std::string text) { findings.add({Finding::Kind::error, at, std::move(text)}); }
  void warn(FilePlace at, std::string text) { findings.add({Finding::Kind::warning, at, std::move(text)}); }
};

/// Returns "; 0.21 ft would be 64.0 mm" for the units in which the file's number would be plausible; empty if
/// there are none.
std::string otherUnits(double value_m, double unit_m, double least_m, double most_m);

}  // namespace carom
