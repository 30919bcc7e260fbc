#pragma once
// Reads of a scenario file whatever follows a clock: the tour, which is the prescribed motion of the
// platform, and the captions, sentences that appear in the room at given times.

#include <vector>

#include "app/scenario/scenario.h"
#include "app/toml/toml_file.h"

namespace carom {

/// Reads the legs. A leg without `from_s` follows the previous one.
std::vector<ThrustLeg> readTour(const TomlTable& tour, double c_m_s);

/// Returns whether the tour starts with the game.
bool readTourAtOnce(const TomlTable& tour);

/// Reports the leg that makes the platform too fast.
void checkTourSpeed(const std::vector<ThrustLeg>& legs, const ObserverStart& start, const TomlTable& tour,
                    double c_m_s);

/// Reads the tables [[caption]] of the file. A caption without `from_s` follows the previous one.
std::vector<Caption> readCaptions(const TomlTable& root);

}  // namespace carom
