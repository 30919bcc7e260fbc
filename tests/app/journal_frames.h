#pragma once
// Frames made from their number, for journals and session files to keep and give back.

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <vector>

#include "app/journal/journal.h"
#include "cave/record/frame_digest.h"

namespace carom::test {

inline const SessionFacts kFacts{"carom 0",        "rigs/desk.toml",  "scenarios/three-pucks.toml",
                                 "unit = \"m\"\n", "title = \"é\"\n", 1.42};

inline GameEvent eventOf(std::uint64_t number, double x) {
  GameEvent event;
  event.number = number;
  event.kind = number % 2 == 0 ? EventKind::puckCushion : EventKind::puckPuck;
  if (number % 2 == 0) event.cushion = Cushion::minusY;
  event.at = {x, {0.1, -x, 0.01}};
  event.withoutDelay = number % 3 == 0;
  event.sideOnSide = number % 5 == 0;
  event.heat_j = 1e-3 * x;
  for (std::size_t puck = 0; puck < 1 + number % 2; ++puck)
    event.turns.push_back({puck, {x, {x, 0.2, 0.01}}, {0.1, x}, {-0.1, x}, x / 3.0, 0.01 * x, -x});
  return event;
}

/// A frame whose every number depends on its own; each third brings knots, each fourth an event.
inline FrameState frameOf(std::uint64_t number) {
  FrameState state;
  const double x = 0.1 * static_cast<double>(number);
  state.record.number = number;
  state.record.display_s = x / 6.0;
  state.record.lightSpeed_m_s = kFacts.lightSpeed_m_s;
  state.record.viewers[0].observer.headFromBoard = Lorentz::boost({x, -x, 0.3}, 1.42);
  state.record.boardFromRoom = Lorentz::boost({-x, 0.2, 0.0}, 1.42);
  state.record.viewers[0].observer.properTime_s = x / 7.0;
  ObserverView& observer = state.record.viewers[0].observer;
  observer.left = observer.right = observer.middle = {{x, {x / 3.0, -0.0, 1.7}}, {0.032, 1.7, x}};
  state.record.viewers[0].placeInRoom_m = observer.middle.positionInRoom_m;
  state.record.room_s = observer.properTime_s;
  state.record.switches.colour = number % 2;
  state.record.viewers[0].hand.offset_m = 0.01 * x;
  state.record.controls.comfort = number % 2;
  state.record.fade = 0.25 * static_cast<double>(number % 4);
  state.record.viewers[0].score = {number / 5, number / 3};
  state.record.pucks = 2;
  state.record.eventsKept = (number + 3) / 4;
  if (number % 4 == 0) state.events.push_back(eventOf(number / 4, x));
  if (number % 3 == 0) {
    state.knots.push_back({1, {{x, {x, 0.0, 0.01}}, {-0.0, 0.3, 0.0}, x, {x, {x, 0.0, 0.01}}, 0.0}});
    state.knots.push_back({2, {{x, {0.0, x, 0.01}}, {0.3, 0.0, 0.0}, x, {}, 0.1, {0.5, x, 0.2, 0.1}}});
  }
  return state;
}

inline bool sameBits(const GameEvent& a, const GameEvent& b) {
  return a.withoutDelay == b.withoutDelay && a.sideOnSide == b.sideOnSide &&
         digestOf(FrameState{{}, {}, {a}, {}, {}}, World{}) ==
             digestOf(FrameState{{}, {}, {b}, {}, {}}, World{});
}

/// Of all fields; what lies between them is nothing.
inline bool sameBits(const FrameRecord& a, const FrameRecord& b) {
  return digestOf(FrameState{a, {}, {}, {}, {}}, World{}) == digestOf(FrameState{b, {}, {}, {}, {}}, World{});
}

inline bool sameBits(const FrameState& a, const FrameState& b) {
  return std::equal(a.events.begin(), a.events.end(), b.events.begin(), b.events.end(),
                    [](const GameEvent& x, const GameEvent& y) { return sameBits(x, y); }) &&
         sameBits(a.record, b.record) && a.knots.size() == b.knots.size() &&
         (a.knots.empty() ||
          std::memcmp(a.knots.data(), b.knots.data(), a.knots.size() * sizeof(BodyKnot)) == 0);
}

inline std::array<HeadEstimate, 1> head() {
  HeadEstimate estimate;
  estimate.known = Known::predicted;
  estimate.celerity_m_s = {0.1, 0.2, 0.3};
  return {estimate};
}

inline std::vector<std::string> column(SQLite::Database& database, const std::string& sql) {
  std::vector<std::string> values;
  for (SQLite::Statement row(database, sql); row.executeStep();)
    values.push_back(row.getColumn(0).getString());
  return values;
}

using Strings = std::vector<std::string>;

}  // namespace carom::test
