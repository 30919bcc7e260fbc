#pragma once
// The tour of a scenario file: the drive that it sets out on by itself.

#include <vector>

#include "app/files/scenario.h"
#include "app/files/toml_file.h"

namespace carom {

/// A leg without `from_s` follows the one before it.
std::vector<ThrustLeg> readTour(const TomlTable& tour, double c_m_s);

/// Whether it starts without being asked to.
bool readTourAtOnce(const TomlTable& tour);

/// Complains of the leg that makes the platform too fast.
void checkTourSpeed(const std::vector<ThrustLeg>& legs, const ObserverStart& start, const TomlTable& tour,
                    double c_m_s);

}  // namespace carom
