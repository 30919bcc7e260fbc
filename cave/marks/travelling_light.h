#pragma once
// News on its way at the speed of light, drawn where it is at the person's board time, as the light of
// flashes is: a stroke that runs from the hand to its puck, the light of it that runs back to the person, and
// rings over the cloth around each hit.

#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "cave/marks/mark_context.h"

namespace carom {

/// Where the light of a stroke is at one moment, and which of its two ways it goes. Board frame.
struct StrokeLight {
  Vec3 place_m{0.0};
  Vec3 along{0.0};      ///< unit vector in which it goes
  double gone_m = 0.0;  ///< since it left the hand, or the puck
  double left_m = 0.0;  ///< to the puck, or until it meets the head
  bool isBack = false;
};

/// Returns where the light of a stroke is at the person's board time, or nothing if it is not under way: from
/// the hand straight to the event at which it reaches the puck, then on the one way on which it meets the
/// point between the eyes, if that moves on as it does now. A stroke that comes from no place has only the
/// way back.
std::optional<StrokeLight> strokeLight(const GameEvent& stroke, const ObserverView& observer);

/// Returns whether the light of one of these strokes is under way.
bool isStrokeUnderWay(std::span<const GameEvent> events, const ObserverView& observer);

/// Adds the light of strokes: a bright pulse on its way to the puck, with the ring in which all that reaches
/// the puck together with it closes in on the puck over the cloth; and a pale pulse on its way back.
void addStrokes(const MarkContext& sight, MarkBuffer& batch);
inline constexpr double kClosingRing_m = 0.7;  ///< radius from which on the ring is drawn

/// Adds around each hit the ring of radius c (t − t_e) in which the news of it crosses the cloth at the
/// person's board time t: one half of it in the colour of each puck, the first one's inside. `colours` is
/// linear, one for every body of the scene. Where a collision sends no signal, the news begins at the turns.
/// The latest kMostNews are drawn.
void addNews(const MarkContext& sight, std::span<const glm::vec3> colours, MarkBuffer& batch);
inline constexpr double kNews_m = 3.2;  ///< radius up to which they are drawn
inline constexpr double kNewsHalfWidth_m = 0.011;
inline constexpr std::size_t kMostNews = 12;

}  // namespace carom
