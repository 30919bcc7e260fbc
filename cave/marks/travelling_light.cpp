#include "cave/marks/travelling_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cave/frame/bodies.h"
#include "cave/gl/view_colours.h"
#include "engine/light/light_path.h"

namespace carom {

// Out: r = r_hand + c (t − t_hand) n. Back: r = r_puck + c (t − t_puck) n' towards the event at which it
// meets the head (lightMeets).
std::optional<StrokeLight> strokeLight(const GameEvent& stroke, const ObserverView& observer) {
  if (stroke.kind != EventKind::stroke || stroke.turns.empty()) return {};
  const Event& head = observer.middle.observation;
  const Event& puck = stroke.turns.front().event;
  const double c_m_s = observer.headFromBoard.lightSpeed_m_s();
  if (!(head.t_s >= stroke.at.t_s)) return {};
  const bool isBack = head.t_s >= puck.t_s;
  const Event& from = isBack ? puck : stroke.at;
  const Event to =
      isBack ? lightMeets(puck, head, betaFromU(observer.headFromBoard.inverse().u()), c_m_s) : puck;
  const Vec3 way_m = to.r_m - from.r_m;
  const double length_m = glm::length(way_m), gone_m = c_m_s * (head.t_s - from.t_s);
  if (!(length_m > gone_m)) return {};
  const Vec3 along = way_m / length_m;
  return StrokeLight{from.r_m + gone_m * along, along, gone_m, length_m - gone_m, isBack};
}

bool isStrokeUnderWay(std::span<const GameEvent> events, const ObserverView& observer) {
  return std::any_of(events.begin(), events.end(), [&](const GameEvent& event) {
    return event.kind == EventKind::stroke && strokeLight(event, observer).has_value();
  });
}

namespace {

/// Adds a pulse with a tail over the last of its way. Near the eyes, where it begins or ends, it is faint and
/// no wider than a hand.
void addPulse(const Resting& draw, const StrokeLight& light, const glm::vec3& colour, double strength,
              MarkBuffer& batch) {
  constexpr double kTail_m = 0.25, kSize_m = 0.028, kNear_m = 0.35;
  constexpr double kLeast_rad = 0.012, kMost_rad = 0.05, kHalfWidth_rad = 0.0045;
  constexpr int kPieces = 6;
  const glm::dvec3 head_m = draw(light.place_m);
  const double away_m = glm::length(head_m);
  const double shown = strength * std::min(1.0, away_m / kNear_m);
  const double tail_m = std::min(kTail_m, light.gone_m);
  glm::dvec3 before_m = head_m;
  for (int i = 1; i <= kPieces; ++i) {
    const double share = static_cast<double>(i) / kPieces;
    const glm::dvec3 next_m = draw(light.place_m - share * tail_m * light.along);
    const double left = 1.0 - share + 0.5 / kPieces;
    batch.addLine(std::array{before_m, next_m}, glm::vec4(colour, static_cast<float>(0.7 * shown * left)),
                  kHalfWidth_rad * left);
    before_m = next_m;
  }
  const double radius_m = std::clamp(kSize_m, kLeast_rad * away_m, std::max(kMost_rad, kLeast_rad) * away_m);
  batch.addGlow(head_m, 2.5 * radius_m, glm::vec4(colour, static_cast<float>(0.5 * shown)));
  batch.addGlow(head_m, radius_m, glm::vec4(colour, static_cast<float>(shown)));
}

/// Returns the radius of the circle in which a sphere around an event cuts the cloth; NaN if it does not.
double onCloth_m(const Event& middle, double radius_m) {
  const double rise_m = middle.r_m.z - kOnCloth_m;
  return std::sqrt((radius_m - rise_m) * (radius_m + rise_m));
}

void addClosingRing(const Resting& draw, const Event& puck, double left_m, MarkBuffer& batch) {
  const double radius_m = onCloth_m(puck, left_m);
  if (!(radius_m > 0.0 && radius_m < kClosingRing_m)) return;
  const double half_m = std::min(0.006, 0.5 * radius_m);
  addClothRing(batch, draw, {puck.r_m.x, puck.r_m.y, kOnCloth_m}, radius_m - half_m, radius_m + half_m,
               glm::vec4(kStrokeColour, static_cast<float>(1.0 - radius_m / kClosingRing_m)));
}

/// News that started from an event, of one puck or of two.
struct News {
  Event from;
  std::array<std::size_t, 2> pucks{};
};

void addRingOf(const MarkContext& sight, const Resting& draw, const News& news,
               std::span<const glm::vec3> colours, MarkBuffer& batch) {
  const double c_m_s = sight.observer.headFromBoard.lightSpeed_m_s();
  const double gone_m = c_m_s * (boardNow_s(sight) - news.from.t_s);
  const double radius_m = onCloth_m(news.from, gone_m);
  if (!(gone_m > 0.0 && radius_m > 0.0 && radius_m < kNews_m)) return;
  const double half_m = std::min(kNewsHalfWidth_m, radius_m);
  const Vec3 middle_m(news.from.r_m.x, news.from.r_m.y, kOnCloth_m);
  const auto shown = static_cast<float>(0.95 * (1.0 - radius_m / kNews_m));
  const auto ink = [&](std::size_t puck) { return glm::vec4(lightOf(colours[kFirstPuck + puck]), shown); };
  addClothRing(batch, draw, middle_m, radius_m - half_m, radius_m, ink(news.pucks[0]));
  addClothRing(batch, draw, middle_m, radius_m, radius_m + half_m, ink(news.pucks[1]));
}

bool sendsNews(const GameEvent& event) {
  return (isOfPucks(event.kind) || isOfCushion(event.kind) || event.kind == EventKind::stroke) &&
         !event.turns.empty();
}

}  // namespace

void addStrokes(const MarkContext& sight, MarkBuffer& batch) {
  const Resting draw(sight);
  for (const GameEvent& event : sight.events) {
    if (event.kind != EventKind::stroke) continue;
    const std::optional<StrokeLight> light = strokeLight(event, sight.observer);
    if (!light) continue;
    if (!light->isBack) addClosingRing(draw, event.turns.front().event, light->left_m, batch);
    addPulse(draw, *light, light->isBack ? kStrokeBackColour : kStrokeColour, light->isBack ? 0.65 : 1.0,
             batch);
  }
}

void addNews(const MarkContext& sight, std::span<const glm::vec3> colours, MarkBuffer& batch) {
  const Resting draw(sight);
  std::size_t count = 0;
  for (std::size_t i = sight.events.size(); i-- > 0 && count < kMostNews;) {
    const GameEvent& event = sight.events[i];
    if (!sendsNews(event)) continue;
    if (!(std::min(event.at.t_s, event.turns.front().event.t_s) < boardNow_s(sight))) continue;
    ++count;
    const std::size_t first = event.turns.front().puck, last = event.turns[event.turns.size() - 1].puck;
    if (event.kind == EventKind::stroke || event.withoutDelay) {
      for (const Turn& turn : event.turns)
        addRingOf(sight, draw, {turn.event, {turn.puck, turn.puck}}, colours, batch);
    } else {
      addRingOf(sight, draw, {event.at, {first, last}}, colours, batch);
    }
  }
}

}  // namespace carom
