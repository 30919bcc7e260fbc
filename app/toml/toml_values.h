#pragma once
// Shared by several file readers: vectors from a file's numbers, and checks of speeds.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/file_keys/language_name.h"
#include "app/toml/toml_file.h"
#include "engine/base/limits.h"
#include "engine/base/pose.h"
#include "engine/sculpture/sculpture_place.h"

namespace carom {

/// Relative tolerance for rounding: bodies that touch within this fraction do not overlap.
inline constexpr double kTouching = 1e-12;

inline glm::dvec2 toVec2(const std::array<double, 2>& a) { return {a[0], a[1]}; }
inline glm::dvec3 toVec3(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

/// Reads { translation, rotation_deg }: rotations about the fixed x, then y, then z axis, then the
/// translation.
inline Pose readPose(const TomlTable& parent, std::string_view key, double unit_m) {
  const auto table = parent.table(key);
  if (!table) return {};
  const glm::dvec3 turn_rad = glm::radians(toVec3(table->numbers<3>("rotation_deg")));
  const glm::dquat aboutX = glm::angleAxis(turn_rad.x, glm::dvec3(1, 0, 0));
  const glm::dquat aboutY = glm::angleAxis(turn_rad.y, glm::dvec3(0, 1, 0));
  const glm::dquat aboutZ = glm::angleAxis(turn_rad.z, glm::dvec3(0, 0, 1));
  return {toVec3(table->numbers<3>("translation")) * unit_m, aboutZ * aboutY * aboutX};
}

/// Returns γβ of the fastest that the drive makes a room, by the key fastest_beta.
inline double readMost_u(const TomlTable& table) {
  const double most = kMostPlatformU / std::hypot(1.0, kMostPlatformU);
  const double beta = table.number("fastest_beta");
  return beta < most ? beta / std::sqrt(1.0 - beta * beta) : kMostPlatformU;
}

/// Reads where spacetime stands; `unit_m`: of the place.
inline SpacetimeSetup readSpacetime(const TomlTable& table, double unit_m = 1.0) {
  SpacetimeSetup setup;
  if (table.has("place")) setup.place_m = toVec3(table.numbers<3>("place")) * unit_m;
  setup.height_m = table.number("height_m");
  setup.scale = table.number("scale");
  if (table.has("past_s")) setup.past_s = table.number("past_s");
  if (table.has("future_s")) setup.future_s = table.number("future_s");
  return setup;
}

/// Returns the language that a file in `folder` names. A file that is not here, but in a session or on
/// another node, may name PO files that are not here either.
inline std::string languageAt(const PlacedText& given, const TomlTable& table,
                              const std::filesystem::path& folder) {
  std::string language = languageNamed(given.text, folder);
  if (table.isKept() && isPoFile(language)) return language;
  if (std::string refusal = refusalOfLanguage(language); !refusal.empty())
    table.fault(given.place, std::move(refusal));
  return language;
}

/// Reads the key `language` of a table of a file in `folder`; empty if it is left out.
inline std::string readLanguage(const TomlTable& table, const std::filesystem::path& folder) {
  const std::string name = table.text("language", "");
  return name.empty() ? name : languageAt({name, table.place("language")}, table, folder);
}

/// Reads its key `languages`.
inline std::vector<std::string> readLanguages(const TomlTable& table, const std::filesystem::path& folder) {
  const FileKey& declared = table.declared("languages");
  std::vector<std::string> languages;
  for (const PlacedText& given : table.texts("languages")) {
    if (given.text.empty()) continue;  // a fault that is known
    std::string language = languageAt(given, table, folder);
    if (std::find(languages.begin(), languages.end(), language) != languages.end())
      table.fault(given.place, fmt::format("'{}' stands here twice, expected it once", given.text));
    if (languages.size() == declared.most) {
      table.fault(given.place, fmt::format("there are more languages, expected at most {}", declared.most));
      break;
    }
    languages.push_back(std::move(language));
  }
  return languages;
}

/// Records a fault if β is not below 1.
template <class Vec>
void checkSpeed(const TomlTable& table, const Vec& beta) {
  if (glm::dot(beta, beta) < 1.0) return;
  table.fault("beta",
              fmt::format("beta has magnitude {}, expected a speed below light, under 1", glm::length(beta)));
}

}  // namespace carom
