#pragma once
// The text of a small rig file and of its variants, for the tests that read rigs.

#include <gtest/gtest.h>

#include <cstddef>
#include <glm/geometric.hpp>
#include <string>

#include "app/fault_names.h"
#include "app/input_faults.h"
#include "app/rig/rig.h"
#include "app/temporary_folder.h"

namespace carom::test {

inline constexpr double kRounding_m = 1e-12;

inline const std::string kGood =
    "unit = 'mm'\n"
    "axes = 'x-right y-up z-back'\n"
    "[head]\n"
    "tracker = 'cap'\n"
    "eye_separation = 62\n"
    "[[tracker]]\n"
    "name = 'cap'\n"
    "kind = 'simulated'\n"
    "[[wall]]\n"
    "name = 'front'\n"
    "lower_left = [-1500, 0, -1500]\n"
    "lower_right = [1500, 0, -1500]\n"
    "upper_left = [-1500, 2000, -1500]\n"
    "pixels = [1920, 1280]\n";

inline Rig read(const std::string& text) {
  const TemporaryFolder folder;
  return readRig(folder.file("given.toml", text));
}

/// kGood with one piece of it changed.
inline std::string changed(const std::string& from, const std::string& to) {
  std::string text = kGood;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// A second wall on the place of kGood's, named `second`, with these lines instead of a window and stereo.
inline std::string withSecond(const std::string& firstsLines, const std::string& secondsLines) {
  std::string second = kGood.substr(kGood.find("[[wall]]"));
  second.replace(second.find("front"), 5, "second");
  return kGood + firstsLines + second + secondsLines;
}

inline void expectNear(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_NEAR(glm::distance(a, b), 0.0, kRounding_m) << a.x << ' ' << a.y << ' ' << a.z;
}

/// Rig files that are wrong in one place: each test of a part of the file gives its own.
class RigFaults : public ::testing::TestWithParam<Fault> {};

}  // namespace carom::test
