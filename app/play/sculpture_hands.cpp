#include "app/play/sculpture_hands.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr double kBead_rad = 0.025, kRingNear_m = 0.06;
constexpr double kFootShare = 0.12, kTopShare = 0.10;  // of the height
constexpr double kLeastScale = 0.02, kMostScale = 2.0;

/// Returns how far along a ray the place nearest to a point is, and how far the point is from there.
std::pair<double, double> nearestOn(const HandRay& ray, const Vec3& place_m) {
  const double along_m = glm::dot(place_m - ray.from_m, ray.along);
  return {along_m, glm::distance(ray.from_m + ray.along * along_m, place_m)};
}

SculpturePick pickBead(const HandRay& ray, const SculptureMap& map, std::span<const GameEvent> events,
                       double topOfPucks_m) {
  SculpturePick pick;
  double least_rad = kBead_rad;
  for (const GameEvent& event : events) {
    const Event at{event.at.t_s, {event.at.r_m.x, event.at.r_m.y, topOfPucks_m}};
    const double height_m = map.model_m(at).z;
    if (height_m < 0.0 || height_m > map.top_m()) continue;
    const auto [along_m, off_m] = nearestOn(ray, map.room_m(at));
    if (!(along_m > 0.0) || !(off_m < least_rad * along_m)) continue;
    least_rad = off_m / along_m;
    pick = {SculptureGrip::bead, along_m, event.number};
  }
  return pick;
}

/// The ray in the sculpture's own axes, z along its height; metres of the room.
HandRay ownRay(const HandRay& ray, const SculpturePlace& place) {
  const Pose footFromRoom = inverse(place.roomFromFoot);
  return {footFromRoom * ray.from_m, footFromRoom.orientation * ray.along};
}

SculpturePick pickRing(const HandRay& ray, const SculptureMap& map) {
  const HandRay own = ownRay(ray, map.place());
  const double height_m = map.present_m() * map.place().scale,
               radius_m = kSculptureRing_m * map.place().scale;
  SculpturePick pick;
  double least_m = kRingNear_m;
  constexpr int kParts = 128;
  for (int i = 0; i < kParts; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kParts;
    const auto [along_m, off_m] =
        nearestOn(own, {radius_m * std::cos(angle), radius_m * std::sin(angle), height_m});
    if (!(along_m > 0.0) || !(off_m < least_m)) continue;
    least_m = off_m;
    pick = {SculptureGrip::ring, along_m, 0};
  }
  return pick;
}

/// The cylinder around the axis, as wide as the ring.
SculpturePick pickBody(const HandRay& ray, const SculptureMap& map) {
  const HandRay own = ownRay(ray, map.place());
  const double radius_m = kSculptureRing_m * map.place().scale;
  const glm::dvec2 from(own.from_m), along(own.along);
  const double a = glm::dot(along, along), b = glm::dot(from, along),
               c = glm::dot(from, from) - radius_m * radius_m;
  if (!(a > 0.0) || !(b * b >= a * c)) return {};
  // At the axis rather than at the mantle, so that a pull is as long as it looks.
  const double along_m = -b / a, height_m = own.from_m.z + own.along.z * along_m;
  const double whole_m = map.place().height_m;
  if (!(along_m > 0.0) || height_m < -0.05 * whole_m || height_m > 1.05 * whole_m) return {};
  const double share = height_m / whole_m;
  const SculptureGrip grip = share < kFootShare        ? SculptureGrip::foot
                             : share > 1.0 - kTopShare ? SculptureGrip::top
                                                       : SculptureGrip::body;
  return {grip, along_m, 0};
}

/// Boosts by a pull along the board, in the sculpture's axes: it adds to the rapidity, which has no limit but
/// that of what can be shown. Returns whether that is reached.
bool boost(const Vec3& was, const glm::dvec2& pull_m, SculpturePlace& place) {
  const double speed = glm::length(was);
  const Vec3 rapidity = (speed > 0.0 ? was * (std::atanh(speed) / speed) : Vec3(0.0)) +
                        Vec3(pull_m / SculptureHands::kRapidity_m, 0.0);
  const double size = glm::length(rapidity), most = std::atanh(kMostSculptureBeta);
  place.beta = size > 0.0 ? rapidity * (std::tanh(std::min(size, most)) / size) : Vec3(0.0);
  return size >= most;
}

void scale(const SculpturePlace& was, double pull_m, SculpturePlace& place) {
  const double factor = std::clamp(std::exp(pull_m / SculptureHands::kFactor_m), kLeastScale / was.scale,
                                   std::max(1.0, kMostScale / was.scale));
  place.scale = was.scale * factor;
  place.height_m = std::min(was.height_m * factor, 100.0);
}

}  // namespace

SculpturePick pickSculpture(const HandRay& ray, const SculptureMap& map, std::span<const GameEvent> events,
                            double topOfPucks_m) {
  if (const SculpturePick bead = pickBead(ray, map, events, topOfPucks_m); bead.grip != SculptureGrip::none)
    return bead;
  if (const SculpturePick ring = pickRing(ray, map); ring.grip != SculptureGrip::none) return ring;
  return pickBody(ray, map);
}

SculptureHands::Outcome SculptureHands::step(const HandInput& hand, std::size_t viewer,
                                             const SculptureMap& map, std::span<const GameEvent> events,
                                             double topOfPucks_m, SculptureView& view) {
  Outcome outcome;
  if (hand.device.empty()) {
    if (holding_ && holding_->viewer == viewer) holding_.reset();
    return outcome;
  }
  const HandRay ray{hand.from_m, hand.along};
  if (!holding_ && hand.pressed) {
    const SculpturePick pick = pickSculpture(ray, map, events, topOfPucks_m);
    if (pick.grip == SculptureGrip::none) return outcome;
    holding_ = {viewer, pick, ray.from_m + ray.along * pick.away_m, view.place};
    if (pick.grip == SculptureGrip::bead) {
      outcome.picked = true;
      const std::uint64_t number = pick.event + 1;
      if (view.picked == number) {
        view.picked = view.compared = 0;
      } else {
        view.compared = std::exchange(view.picked, number);
      }
    }
  }
  if (!holding_ || holding_->viewer != viewer) return outcome;
  outcome.takes = true;
  outcome.at_m = ray.from_m + ray.along * holding_->pick.away_m;
  if (!hand.held && !hand.pressed) {
    holding_.reset();
    return outcome;
  }
  const SculpturePlace& was = holding_->was;
  const Vec3 pull_m = glm::conjugate(was.roomFromFoot.orientation) * (outcome.at_m - holding_->from_m);
  const auto upright = [&](double angle) {
    return was.roomFromFoot.orientation * glm::angleAxis(angle, Vec3(0.0, 0.0, 1.0));
  };
  switch (holding_->pick.grip) {
    case SculptureGrip::ring:
      outcome.boosts = true;
      outcome.atLimit = boost(was.beta, glm::dvec2(pull_m), view.place);
      break;
    case SculptureGrip::foot:
      view.place.roomFromFoot.position_m = was.roomFromFoot * Vec3(pull_m.x, pull_m.y, 0.0);
      break;
    case SculptureGrip::top:
      scale(was, pull_m.z, view.place);
      break;
    case SculptureGrip::body: {
      const Vec3 way = glm::conjugate(was.roomFromFoot.orientation) * ray.along;
      const glm::dvec2 level(way);
      const double length = glm::length(level);
      if (length > 1e-6)
        view.place.roomFromFoot.orientation =
            upright((level.y * pull_m.x - level.x * pull_m.y) / (length * kTurn_m));
      break;
    }
    default:
      break;
  }
  return outcome;
}

}  // namespace carom
