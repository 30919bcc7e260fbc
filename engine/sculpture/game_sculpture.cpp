#include "engine/sculpture/game_sculpture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

namespace carom {
namespace {

// Sizes in the model.
constexpr double kBead_m = 1.8e-3, kLight_m = 0.6e-3, kFrame_m = 0.8e-3, kBase_m = 3.0e-3;
constexpr double kFlashReach_m = 0.3;  // how far the rods of a flash go, on the board
constexpr int kFlashRods = 8, kFlashSteps = 8;

/// The least and the greatest of some coordinates.
struct Bounds {
  Vec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
  void add(const Vec3& point) { low = glm::min(low, point), high = glm::max(high, point); }
};

/// Returns the distance of the nearest side from the centre.
double innerRadius_m(const Puck& puck) {
  double least_m = puck.radius_m;
  const std::vector<Vec2>& corners = puck.outline_m;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 from = corners[i], side = corners[(i + 1) % corners.size()] - from;
    least_m = std::min(least_m, std::abs(from.x * side.y - from.y * side.x) / glm::length(side));
  }
  return least_m;
}

/// Returns the least thickness of a puck's tube, at a right angle to its middle line. A body at β is thinner
/// by γ along its way, and its tube leans by an angle whose tangent is β: 2 R/(γ √(1 + β²)).
double thickness_m(const Puck& puck, const WorldLine& line, const Span& span, const Lorentz& frameFromBoard) {
  double least_m = std::numeric_limits<double>::infinity();
  const Knots knots = line.knots();
  for (std::size_t k = 0; k < knots.size(); ++k) {
    const bool isOver = k + 1 < knots.size() && knots[k + 1].turn.t_s < span.from_s;
    if (isOver || knots[k].turn.t_s > span.until_s) continue;
    const Displacement along =
        frameFromBoard * Displacement{gammaFromU(knots[k].u) / frameFromBoard.lightSpeed_m_s(), knots[k].u};
    const double gamma = along.dt_s * frameFromBoard.lightSpeed_m_s(), beta2 = 1.0 - 1.0 / (gamma * gamma);
    least_m = std::min(least_m, 2.0 * innerRadius_m(puck) / (gamma * std::sqrt(1.0 + beta2)));
  }
  return least_m;
}

/// Makes the parts one after the other.
class Maker {
 public:
  Maker(const SculptureSource& game, const SculptureOptions& options)
      : game_(game),
        options_(options),
        frame_{Lorentz::boost(uFromBeta(options.beta), game.setup.lightSpeed_m_s).inverse(),
               {0.5 * (options.span.from_s + options.span.until_s), Vec3(0.0)}} {
    made_.lightSpeed_m_s = game.setup.lightSpeed_m_s;
    for (const Puck& puck : game.setup.pucks) top_m_ = std::max(top_m_, puck.height_m);
  }

  GameSculpture make() {
    for (std::size_t puck = 0; puck < game_.setup.pucks.size(); ++puck) addTube(puck);
    if (made_.parts.empty())
      throw std::invalid_argument(
          "nothing to show between these moments: soft pucks have no tubes, and no other is there");
    findBoard();
    thicken();
    for (const GameEvent& event : game_.events) {
      if (event.at.t_s >= options_.span.from_s && event.at.t_s <= options_.span.until_s) addEvent(event);
    }
    addBoard();
    return std::move(made_);
  }

 private:
  void addTube(std::size_t puck, double widened = 1.0) {
    const Puck& body = game_.setup.pucks[puck];
    const WorldLine& line = game_.lines[puck];
    if (body.soft || !(line.appears_s() < options_.span.until_s)) {
      ++made_.withoutTube;
      return;
    }
    made_.parts.push_back({SculpturePartKind::tube, body.name, puck,
                           solidOf(worldTube(body, line, options_.span, widened), frame_)});
  }

  /// Finds the rectangle of the board, or one around the pucks, and the scale.
  void findBoard() {
    const auto& board = game_.setup.board;
    if (board) {
      corner_m_ = {0.5 * board->length_m, 0.5 * board->width_m};
      middle_m_ = Vec2(0.0);
    } else {
      findPlane();
    }
    Bounds bounds;
    for (const SculpturePart& part : made_.parts)
      for (const Vec3& point : part.solid.points) bounds.add(point);
    for (const double t_s : {options_.span.from_s, options_.span.until_s})
      for (int k = 0; k < 4; ++k) bounds.add(frame_.at(cornerAt(k, t_s)));
    const Vec3 size_m = bounds.high - bounds.low;
    made_.scale = (options_.size_m - kBase_m - 2.0 * kFrame_m) / std::max({size_m.x, size_m.y, size_m.z});
  }

  /// On an open plane: around the pucks at all their turns and at both moments.
  void findPlane() {
    Bounds bounds;
    for (const SculpturePart& part : made_.parts) {
      const WorldLine& line = game_.lines[part.puck];
      const double reach_m = game_.setup.pucks[part.puck].radius_m;
      const auto add = [&](double t_s) {
        const Vec3 place_m = line.at(std::clamp(t_s, options_.span.from_s, options_.span.until_s)).event.r_m;
        bounds.add(place_m - reach_m);
        bounds.add(place_m + reach_m);
      };
      add(options_.span.from_s);
      add(options_.span.until_s);
      for (const Knot& knot : line.knots()) add(knot.turn.t_s);
    }
    middle_m_ = Vec2(bounds.low + bounds.high) * 0.5;
    corner_m_ = Vec2(bounds.high - bounds.low) * 0.5;
  }

  Event cornerAt(int corner, double t_s) const {
    const double x = corner == 1 || corner == 2 ? corner_m_.x : -corner_m_.x;
    return {t_s, {middle_m_.x + x, middle_m_.y + (corner >= 2 ? corner_m_.y : -corner_m_.y), top_m_}};
  }

  /// Makes the tubes anew that would be thinner than what can be printed.
  void thicken() {
    double least_m = std::numeric_limits<double>::infinity();
    std::vector<std::pair<std::size_t, double>> thin;
    for (const SculpturePart& part : made_.parts) {
      const double wall_m = made_.scale * thickness_m(game_.setup.pucks[part.puck], game_.lines[part.puck],
                                                      options_.span, frame_.frameFromBoard);
      if (wall_m < options_.leastWall_m) thin.emplace_back(part.puck, options_.leastWall_m / wall_m);
      least_m = std::min(least_m, std::max(wall_m, options_.leastWall_m));
    }
    for (const auto& [puck, widened] : thin) {
      std::erase_if(made_.parts, [&](const SculpturePart& part) { return part.puck == puck; });
      addTube(puck, widened);
    }
    std::sort(made_.parts.begin(), made_.parts.end(),
              [](const auto& a, const auto& b) { return a.puck < b.puck; });
    made_.thickened = thin.size();
    made_.leastWall_m = std::min(least_m, 2.0 * rodRadius_m(kLight_m) * made_.scale);
  }

  /// Returns a radius in the model as one on the board, at least that of the least wall.
  double rodRadius_m(double inModel_m) const {
    return std::max(inModel_m, 0.5 * options_.leastWall_m) / made_.scale;
  }

  void add(SculpturePartKind kind, std::string name, SolidMesh solid) {
    made_.parts.push_back({kind, std::move(name), 0, std::move(solid)});
  }

  void addEvent(const GameEvent& event) {
    const std::string name = "event " + std::to_string(event.number) + " " + std::string(nameOf(event.kind));
    Event at = event.at;
    at.r_m.z = top_m_;
    if (event.kind != EventKind::stroke && event.kind != EventKind::flash)
      return add(SculpturePartKind::bead, name, ball(frame_.at(at), rodRadius_m(kBead_m)));
    if (event.kind == EventKind::flash) return addFlash(event, name);
    if (event.turns.empty()) return;
    // The straight way of the light from the hand to the puck's centre, from where it enters the plane.
    const Event arrival = event.turns.front().event;
    const double above_m = event.at.r_m.z - top_m_, way_m = event.at.r_m.z - arrival.r_m.z;
    const double enters = above_m > 0.0 && way_m > 0.0 ? above_m / way_m : 0.0;
    const Displacement way = arrival - event.at;
    const Event entry = event.at + Displacement{way.dt_s * enters, way.dr_m * enters};
    add(SculpturePartKind::bead, name, ball(frame_.at(entry), rodRadius_m(kBead_m)));
    if (way.dt_s > 0.0) addRod(SculpturePartKind::light, name, {entry, arrival}, kLight_m);
  }

  /// The light of a flash at the height h over the plane reaches the distance ρ in it √(h² + ρ²)/c later.
  void addFlash(const GameEvent& event, const std::string& name) {
    const double c_m_s = game_.setup.lightSpeed_m_s, above_m = std::abs(event.at.r_m.z - top_m_);
    for (int k = 0; k < kFlashRods; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kFlashRods;
      std::vector<Event> path;
      for (int step = 0; step <= kFlashSteps; ++step) {
        const double rho_m = kFlashReach_m * step / kFlashSteps;
        path.push_back(
            {event.at.t_s + std::hypot(above_m, rho_m) / c_m_s,
             {event.at.r_m.x + rho_m * std::cos(angle), event.at.r_m.y + rho_m * std::sin(angle), top_m_}});
      }
      if (k == 0) add(SculpturePartKind::bead, name, ball(frame_.at(path.front()), rodRadius_m(kBead_m)));
      addRod(SculpturePartKind::light, name, path, kLight_m);
    }
  }

  void addRod(SculpturePartKind kind, const std::string& name, const std::vector<Event>& path,
              double radius_m) {
    std::vector<Vec3> places_m;
    for (const Event& event : path) places_m.push_back(frame_.at(event));
    add(kind, name, rod(places_m, rodRadius_m(radius_m)));
  }

  /// The board at the first moment as a plate under the tubes, its corners in time, its edges at the last
  /// one.
  void addBoard() {
    const double first_s = options_.span.from_s, last_s = options_.span.until_s;
    const std::array<Vec3, 3> corners{frame_.at(cornerAt(0, first_s)), frame_.at(cornerAt(1, first_s)),
                                      frame_.at(cornerAt(3, first_s))};
    const Vec3 along = corners[1] - corners[0], across = corners[2] - corners[0];
    const Vec3 up = glm::normalize(glm::cross(along, across)) * (kBase_m / made_.scale);
    SolidMesh plate = box({0.0, 0.0, -1.0}, {1.0, 1.0, 0.1});  // a tenth of it reaches into what stands on it
    for (Vec3& point : plate.points) point = corners[0] + along * point.x + across * point.y + up * point.z;
    add(SculpturePartKind::base, "board", std::move(plate));
    for (int k = 0; k < 4; ++k) {
      addRod(SculpturePartKind::frame, "corner", {cornerAt(k, first_s), cornerAt(k, last_s)}, kFrame_m);
      addRod(SculpturePartKind::frame, "edge", {cornerAt(k, last_s), cornerAt((k + 1) % 4, last_s)},
             kFrame_m);
      if (!options_.sheets || !game_.setup.board) continue;
      SolidMesh sheet;
      for (const auto& [corner, t_s] :
           {std::pair{k, first_s}, {(k + 1) % 4, first_s}, {(k + 1) % 4, last_s}, {k, last_s}})
        sheet.points.push_back(frame_.at(cornerAt(corner, t_s)));
      sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
      add(SculpturePartKind::cushion, "cushion", std::move(sheet));
    }
  }

  const SculptureSource& game_;
  const SculptureOptions& options_;
  SpacetimeFrame frame_;
  double top_m_ = 0.0;  // the height of the plane
  Vec2 middle_m_{0.0}, corner_m_{0.0};
  GameSculpture made_;
};

}  // namespace

GameSculpture sculptureOf(const SculptureSource& game, const SculptureOptions& options) {
  return Maker(game, options).make();
}

}  // namespace carom
