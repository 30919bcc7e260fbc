#include "app/page/still_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>

#include "app/tables/html_text.h"
#include "cave/frame/bodies.h"
#include "cave/frame/body_colour.h"
#include "cave/gl/view_colours.h"
#include "engine/light/light_cone.h"

namespace carom {
namespace {

constexpr int kWidth = 960, kHeight = 540;
constexpr double kNearest_m = 0.05;

/// Looks from the eye towards the middle of the table; pixels to the right and down.
class Look {
 public:
  Look(const Visit& visit, const VisitFrame& frame)
      : eye_(frame.observer.middle.observation), head_(frame.observer) {
    const Vec3 up = visit.axes.up;
    const auto middle = seen(WorldLine(Knot{}, visit.scenario.billiard.lightSpeed_m_s), Vec3(0.0));
    const Vec3 way = middle.value_or(visit.axes.forward);
    forward_ = glm::normalize(glm::length(way) > 0.0 ? way : visit.axes.forward);
    right_ = glm::cross(forward_, up);
    right_ = glm::length(right_) > 1e-6 ? glm::normalize(right_) : visit.axes.right;
    up_ = glm::cross(right_, forward_);
  }

  std::optional<Vec3> seen(const WorldLine& line, const Vec3& place_m) const {
    const auto light = emission(line, place_m, eye_, head_.headFromBoard);
    if (!light) return std::nullopt;
    return light->seen.dr_m;
  }

  /// Returns the polygon of these places of a body; nothing if a part of it is behind the eye or unseen.
  std::string polygon(const WorldLine& line, const std::vector<Vec3>& places_m,
                      const std::string& colour) const {
    std::string points;
    for (const Vec3& place_m : places_m) {
      const auto at = seen(line, place_m);
      const double ahead_m = at ? glm::dot(*at, forward_) : 0.0;
      if (ahead_m < kNearest_m) return "";
      const double scale = 0.9 * kWidth / 2.0 / ahead_m;
      points += fmt::format("{:.1f},{:.1f} ", kWidth / 2.0 + scale * glm::dot(*at, right_),
                            kHeight / 2.0 - scale * glm::dot(*at, up_));
    }
    return fmt::format("<polygon points=\"{}\" fill=\"{}\"/>\n", points, colour);
  }

 private:
  Event eye_;
  ObserverView head_;
  Vec3 forward_{0.0}, right_{0.0}, up_{0.0};
};

std::string hexOf(const glm::vec3& linear, float share) {
  const glm::vec3 code = codeOf(glm::clamp(linear * share, 0.0F, 1.0F)) * 255.0F;
  return fmt::format("#{:02x}{:02x}{:02x}", static_cast<int>(code.x), static_cast<int>(code.y),
                     static_cast<int>(code.z));
}

std::vector<Vec3> rectangle(double halfLength_m, double halfWidth_m, double z_m) {
  constexpr int kPerSide = 16;
  const std::array<Vec2, 5> corners{Vec2{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
  std::vector<Vec3> places;
  for (std::size_t side = 0; side < 4; ++side)
    for (int i = 0; i < kPerSide; ++i) {
      const Vec2 at = glm::mix(corners[side], corners[side + 1], static_cast<double>(i) / kPerSide);
      places.emplace_back(at.x * halfLength_m, at.y * halfWidth_m, z_m);
    }
  return places;
}

/// The outline of a puck at a height over its centre.
std::vector<Vec3> rimOf(const Puck& puck, double z_m) {
  constexpr int kCorners = 48;
  std::vector<Vec3> places;
  for (const Vec2& corner : puck.outline_m) places.emplace_back(corner, z_m);
  for (int i = 0; i < kCorners && puck.outline_m.empty(); ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCorners;
    places.emplace_back(puck.radius_m * std::cos(angle), puck.radius_m * std::sin(angle), z_m);
  }
  return places;
}

}  // namespace

std::string stillPicture(const Visit& visit, const std::vector<WorldLine>& lines) {
  const VisitFrame& frame = visit.frames[visit.frames.size() / 2];
  const Look look(visit, frame);
  const BilliardSetup& setup = visit.scenario.billiard;
  constexpr double kRail_m = 0.12, kRailHeight_m = 0.04;
  std::string svg = fmt::format(
      "<svg id=\"still\" role=\"img\" viewBox=\"0 0 {0} {1}\" xmlns=\"http://www.w3.org/2000/svg\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#20252b\"/>\n",
      kWidth, kHeight);
  if (setup.board) {
    const double half_m = 0.5 * setup.board->length_m, across_m = 0.5 * setup.board->width_m;
    svg += look.polygon(lines[kRestingBody], rectangle(half_m + kRail_m, across_m + kRail_m, kRailHeight_m),
                        "#6b4a2f");
    svg += look.polygon(lines[kRestingBody], rectangle(half_m, across_m, 0.0), "#1d6b45");
  }
  std::vector<std::pair<double, std::string>> pucks;
  for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
    const Puck& puck = setup.pucks[i];
    const WorldLine& line = lines[kFirstPuck + i];
    const auto centre = look.seen(line, Vec3(0.0));
    if (!centre) continue;
    const glm::vec3 colour = colourOf(puck.name, i);
    pucks.emplace_back(glm::length(*centre),
                       look.polygon(line, rimOf(puck, -0.5 * puck.height_m), hexOf(colour, 0.4F)) +
                           look.polygon(line, rimOf(puck, 0.5 * puck.height_m), hexOf(colour, 1.0F)));
  }
  std::sort(pucks.begin(), pucks.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [away_m, drawn] : pucks) svg += drawn;
  return svg + "</svg>\n";
}

}  // namespace carom
