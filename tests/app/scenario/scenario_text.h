#pragma once
// The text of small scenario files, for the tests that read scenarios.

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "app/fault_names.h"
#include "app/input_faults.h"
#include "app/scenario/scenario.h"
#include "app/temporary_folder.h"

namespace carom::test {

inline constexpr double kRounding = 1e-12;  // of metres and seconds of order one

inline Scenario read(const std::string& text) {
  const TemporaryFolder folder;
  return readScenario(folder.file("given.toml", text));
}

inline std::string numberText(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

inline std::string puckText(const std::string& name, double radius_m, Vec2 position_m, Vec2 beta) {
  return "[[puck]]\nname = '" + name + "'\nradius_m = " + numberText(radius_m) +
         "\nmass_kg = 1\nposition_m = [" + numberText(position_m.x) + ", " + numberText(position_m.y) +
         "]\nbeta = [" + numberText(beta.x) + ", " + numberText(beta.y) + "]\n";
}

inline const std::string kHead = "light_speed_m_s = 1\n";

inline const std::string kPuck =
    "[[puck]]\nname = 'a'\nradius_m = 0.1\nmass_kg = 1\nposition_m = [0, 0]\nbeta = [0, 0]\n";

inline const std::string kOther =
    "[[puck]]\nname = 'b'\nradius_m = 0.1\nmass_kg = 1\nposition_m = [0, 1]\nbeta = [0, 0]\n";

/// Scenario files that are wrong in one place: each test of a part of the file gives its own.
class ScenarioFaults : public ::testing::TestWithParam<Fault> {};

}  // namespace carom::test
