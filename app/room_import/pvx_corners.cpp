#include "app/room_import/pvx_corners.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <locale>
#include <numbers>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

#include "app/room_checks/foreign_room.h"
#include "cave/room/rectangle.h"

namespace carom {
namespace {

// ParaView's view of a machine without corners: a camera of 30 degrees. The wall is placed to match it.
constexpr double kViewAngle_rad = 30.0 * std::numbers::pi / 180.0;
constexpr double kAssumedDistance_m = 1.0;
constexpr int kAssumedHeight_px = 1080;

constexpr std::array<std::string_view, 3> kPvxCorners{"LowerLeft", "LowerRight", "UpperRight"};

/// One of the three numbers of a corner, or the text found there instead.
struct Token {
  std::string text;
  FilePlace at;
  std::optional<double> value;
};

std::vector<Token> tokensOf(const XmlAttribute& attribute) {
  std::vector<Token> tokens;
  const std::string& text = attribute.value;
  for (std::size_t i = 0; (i = text.find_first_not_of(" \t\r\n", i)) != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_of(" \t\r\n", i), text.size());
    Token token{text.substr(i, end - i), attribute.valueAt, {}};
    token.at.column += static_cast<int>(i);
    token.value = wholeNumber(token.text);
    if (token.value && !within({}, *token.value)) token.value.reset();
    tokens.push_back(std::move(token));
    i = end;
  }
  return tokens;
}

/// Returns a corner as ParaView reads it: each number up to the first invalid character, zeros from there on.
glm::dvec3 asParaViewReads(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  glm::dvec3 corner_m(0.0);
  stream >> corner_m.x;
  stream >> corner_m.y;
  stream >> corner_m.z;
  return corner_m;
}

/// Returns the value of one coordinate that makes the three corners a rectangle. Returns nothing if it does
/// not matter or no value does. Corner 1 has the right angle.
std::optional<double> valueThatFits(const std::array<glm::dvec3, 3>& corners_m, std::size_t corner, int axis,
                                    double near) {
  const glm::dvec3 &a = corners_m[0], &m = corners_m[1], &b = corners_m[2];
  double others = 0.0;  // part of (a − m)·(b − m) without this axis
  for (int i = 0; i < 3; ++i) {
    if (i != axis) others += (a[i] - m[i]) * (b[i] - m[i]);
  }
  std::vector<double> roots;
  if (corner == 1) {  // (a − v)(b − v) + others = 0
    const double middle = 0.5 * (a[axis] + b[axis]), half = 0.5 * (a[axis] - b[axis]);
    const double square = half * half - others;
    if (square >= 0.0) roots = {middle - std::sqrt(square), middle + std::sqrt(square)};
  } else {  // (v − m) other + others = 0
    const double other = corners_m[2 - corner][axis] - m[axis];
    if (std::abs(other) >= kShortestEdge_m) roots = {m[axis] - others / other};
  }
  std::optional<double> best;
  for (const double root : roots) {
    std::array<glm::dvec3, 3> tried = corners_m;
    tried[corner][axis] = root;
    const bool wall = glm::distance(tried[0], tried[1]) >= kShortestEdge_m &&
                      glm::distance(tried[1], tried[2]) >= kShortestEdge_m;
    if (wall && (!best || std::abs(root - near) < std::abs(*best - near))) best = root;
  }
  return best;
}

/// Returns a description of the error that ParaView's reading would cause in the wall; empty if the other
/// corners do not determine it.
std::string harmOf(const std::array<const XmlAttribute*, 3>& texts,
                   const std::array<std::vector<Token>, 3>& tokens, std::size_t corner, int axis) {
  std::array<glm::dvec3, 3> corners_m;
  for (std::size_t i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      const auto& value = tokens[i][static_cast<std::size_t>(k)].value;
      if (!value && (i != corner || k != axis)) return {};
      corners_m[i][k] = value.value_or(0.0);
    }
  }
  const glm::dvec3 taken_m = asParaViewReads(texts[corner]->value);
  const auto fitting = valueThatFits(corners_m, corner, axis, taken_m[axis]);
  if (!fitting) return {};
  glm::dvec3 meant_m = corners_m[corner];
  meant_m[axis] = *fitting;
  corners_m[corner] = taken_m;
  const double moved_m = glm::distance(taken_m, meant_m);
  const double second_m = glm::distance(corners_m[1], corners_m[2]);
  if (!(moved_m > 0.0 && glm::distance(corners_m[0], corners_m[1]) > 0.0 && second_m > 0.0)) return {};
  const double miss_m = std::abs(squareMiss_m(corners_m));
  return fmt::format(
      "; ParaView takes it for {} without a word: the other corners make it {:.6g}, so this corner would be "
      "{:.4g} mm off and the wall {:.3g} mm ({:.2f} degrees) out of square",
      taken_m[axis], *fitting, moved_m * 1e3, miss_m * 1e3,
      std::asin(std::min(1.0, miss_m / second_m)) * 180.0 / std::numbers::pi);
}

bool readNumbers(const std::array<const XmlAttribute*, 3>& texts,
                 const std::array<std::vector<Token>, 3>& tokens, const std::string& wall, Room& room) {
  bool sound = true;
  for (std::size_t i = 0; i < 3; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const Token& token = tokens[i][static_cast<std::size_t>(axis)];
      if (token.value) continue;
      sound = false;
      const bool number = wholeNumber(token.text).has_value();
      addError(room, token.at,
               fmt::format("'{}' in {} of wall '{}' is {}, expected {}{}", printable(token.text),
                           kPvxCorners[i], wall, number ? "out of range" : "no number",
                           number ? wordsFor({}, false) : "a number and nothing else",
                           harmOf(texts, tokens, i, axis)));
    }
  }
  return sound;
}

/// Places the wall of a machine without corners as ParaView's default view.
void hangUp(const XmlElement& machine, Wall& wall, Room& room) {
  if (wall.pixels.x == 0) wall.pixels = wall.window.size_px = {kAssumedHeight_px, kAssumedHeight_px};
  const double up_m = kAssumedDistance_m * std::tan(0.5 * kViewAngle_rad);
  const double right_m = up_m * wall.pixels.x / wall.pixels.y;
  wall.lowerLeft_m = {-right_m, -up_m, -kAssumedDistance_m};
  wall.lowerRight_m = {right_m, -up_m, -kAssumedDistance_m};
  wall.upperLeft_m = {-right_m, up_m, -kAssumedDistance_m};
  const std::string what = fmt::format(
      "machine '{}' has no corners, so where its screen stands is unknown; it is taken to hang {:.0f} mm "
      "ahead of "
      "the eyes, {:.0f} × {:.0f} mm: ParaView's view angle of 30 degrees",
      wall.name, kAssumedDistance_m * 1e3, 2e3 * right_m, 2e3 * up_m);
  addWarning(room, machine.at, what);
  room.assumptions.push_back(what);
}

}  // namespace

bool readCorners(const XmlElement& machine, Wall& wall, Room& room) {
  std::array<const XmlAttribute*, 3> texts{};
  int given = 0;
  for (std::size_t i = 0; i < 3; ++i) given += (texts[i] = machine.attribute(kPvxCorners[i])) != nullptr;
  if (given == 0) {
    hangUp(machine, wall, room);
    return true;
  }
  bool sound = true;
  std::array<std::vector<Token>, 3> tokens;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!texts[i]) {
      addError(
          room, machine.at,
          fmt::format("{} is missing at wall '{}', expected all three corners: ParaView drops the other two "
                      "without a word",
                      kPvxCorners[i], wall.name));
      sound = false;
      continue;
    }
    tokens[i] = tokensOf(*texts[i]);
    if (tokens[i].size() == 3) continue;
    addError(room, texts[i]->valueAt,
             fmt::format("{} of wall '{}' has {} value{}, expected 3 numbers", kPvxCorners[i], wall.name,
                         tokens[i].size(), tokens[i].size() == 1 ? "" : "s"));
    sound = false;
  }
  if (!sound || !readNumbers(texts, tokens, wall.name, room)) return false;
  const auto corner = [&](std::size_t i) {
    return glm::dvec3(*tokens[i][0].value, *tokens[i][1].value, *tokens[i][2].value);
  };
  const ThreeCorners corners{{corner(0), corner(1), corner(2)}, kPvxCorners};
  wall.lowerLeft_m = corner(0);
  wall.lowerRight_m = corner(1);
  wall.upperLeft_m = corner(0) + (corner(2) - corner(1));
  if (const auto fault = rectangleFault(wall.name, corners)) {
    addError(room, texts[fault->corner]->valueAt, fault->what);
    return false;
  }
  return true;
}

void assumePixels(const XmlElement& machine, Wall& wall, Room& room) {
  const double width_m = glm::distance(wall.lowerLeft_m, wall.lowerRight_m);
  const double height_m = glm::distance(wall.lowerLeft_m, wall.upperLeft_m);
  const double width_px = kAssumedHeight_px * width_m / height_m;
  wall.pixels = {static_cast<int>(std::lround(std::clamp(width_px, 1.0, double{kMostPvxPixels}))),
                 kAssumedHeight_px};
  wall.window.size_px = wall.pixels;
  const std::string what = fmt::format("machine '{}' has no Geometry; {} × {} pixels are taken", wall.name,
                                       wall.pixels.x, wall.pixels.y);
  addWarning(room, machine.at, what);
  room.assumptions.push_back(what);
}

}  // namespace carom
