#pragma once
// The events of a game: collisions, strokes, flashes of light and pucks that jam, as one list in the order in
// which the game committed them.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include <glm/vec2.hpp>

#include "engine/spacetime/event.h"

namespace carom {

using Vec2 = glm::dvec2;

/// The kinds of events. `jam` is one puck of several that press on one another and move on without closing on
/// each other (see `Billiard`). Each of them has an event of its own, all with the same contact; momentum
/// balances over all of them.
/// The first touch of a soft puck and a cushion is a `softCushion`, that of two soft ones a `softSoft`; their
/// turns name the pucks, and change nothing. `parted` is the last touch of such a collision, with its heat;
/// it is listed once they have not touched for as long as sound needs to cross the slower one. `farSide` is
/// the moment at which the far side of a soft puck hears of a touch, of a stroke, or of what holds it.
enum class EventKind : std::uint8_t {
  puckPuck,
  puckCushion,
  stroke,
  flash,
  jam,
  softCushion,
  softSoft,
  parted,
  farSide
};
inline constexpr EventKind kLastEventKind = EventKind::farSide;
enum class Cushion : std::uint8_t { plusX, minusX, plusY, minusY };

/// Returns the name that files and tables use.
constexpr std::string_view nameOf(EventKind kind) {
  constexpr std::array<std::string_view, 9> kNames{"puck-puck",    "puck-cushion", "stroke", "flash",   "jam",
                                                   "soft-cushion", "soft-soft",    "parted", "far-side"};
  return kNames[static_cast<std::size_t>(kind)];
}
constexpr std::string_view nameOf(Cushion cushion) {
  constexpr std::array<std::string_view, 4> kNames{"+x", "-x", "+y", "-y"};
  return kNames[static_cast<std::size_t>(cushion)];
}

/// Whether two pucks meet, rigid or soft; whether one meets a cushion.
constexpr bool isOfPucks(EventKind kind) {
  return kind == EventKind::puckPuck || kind == EventKind::softSoft;
}
constexpr bool isOfCushion(EventKind kind) {
  return kind == EventKind::puckCushion || kind == EventKind::softCushion;
}

/// The change of motion of a puck's centre. Board frame.
struct Turn {
  std::size_t puck = 0;  ///< index into the setup's pucks
  Event event;
  Vec2 betaBefore{0.0};
  Vec2 betaAfter{0.0};
  double properTime_s = 0.0;  ///< the puck's own clock
  double spinBefore_kg_m2_s = 0.0;
  double spinAfter_kg_m2_s = 0.0;
};

/// The turns of one event: none, one or two, held in place.
class Turns {
 public:
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const Turn* begin() const { return turns_.data(); }
  const Turn* end() const { return turns_.data() + size_; }
  Turn* begin() { return turns_.data(); }
  Turn* end() { return turns_.data() + size_; }
  const Turn& operator[](std::size_t i) const { return turns_[i]; }
  Turn& operator[](std::size_t i) { return turns_[i]; }
  const Turn& front() const { return turns_.front(); }
  void push_back(const Turn& turn) { turns_.at(size_++) = turn; }

 private:
  std::array<Turn, 2> turns_;
  std::size_t size_ = 0;
};

struct GameEvent {
  std::uint64_t number = 0;  ///< from 0, in the order of commitment
  EventKind kind = EventKind::flash;
  std::optional<Cushion> cushion;  ///< of a collision with a cushion
  /// For a stroke or flash: its place in the setup's list; for a soft contact and its parting: among the
  /// contacts.
  std::uint32_t which = 0;
  /// The contact; the hand's stroke or, if the hand has no place, its arrival at the centre; the flash.
  Event at;
  /// For a collision: the discs, or the disc and the cushion, were in contact already when the leg began, and
  /// the kick acts at once, where the centres are. No signal comes from `at` then. `at` is the place where
  /// the rims lie on each other, simultaneously with the turns in the equal-speed frame, or the place on the
  /// cushion beside the centre when it turns; it may lie after the turns and out of reach of light.
  bool withoutDelay = false;
  /// For a collision of bodies with corners: a side lies on a side, and `at` is the middle of what touches.
  bool sideOnSide = false;
  Turns turns;  ///< one for each puck that took part; for a stroke, its arrival
  double heat_j = 0.0;
};

}  // namespace carom
