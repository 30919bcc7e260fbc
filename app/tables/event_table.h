#pragma once
// A game's events as a table: in the board's frame and in one that moves, where and when the light of each
// was received, and what can be said of each one and the next.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/billiard/game_event.h"
#include "engine/spacetime/simultaneity.h"

namespace carom {

/// A person's head at one drawn frame: where it received the frame's light, on the board, and its own clock.
struct HeadAt {
  std::uint64_t frame = 0;
  Event event;
  double properTime_s = 0.0;
};

/// Light is received. Board time.
struct Reception {
  double t_s = 0.0;
  std::optional<double> properTime_s;  ///< the receiver's own clock
  std::optional<std::uint64_t> frame;  ///< the first drawn frame that can show it
};

/// Someone who rests at a place on the board receives the light of an event at t = t_e + |r − r_e|/c.
Reception receptionAt(const Vec3& place_m, const Event& source, double c_m_s);

/// A recorded head receives it between the last frame outside the event's future light cone and the first
/// inside; between frames its way is taken to be straight and its clock even. None if it was in there before
/// the first frame, or is not yet after the last.
std::optional<Reception> receptionBy(std::span<const HeadAt> head, const Event& source, double c_m_s);

/// Names of the pucks that took part, with commas between, or of the flash.
std::string whoOf(const GameEvent& event, std::span<const std::string> pucks,
                  std::span<const std::string> flashes);

struct EventRow {
  GameEvent event;
  std::string who;        ///< names of the pucks or of the flash
  std::size_t order = 0;  ///< on the board, from 1; events at the same time share theirs
  Event moving;           ///< in the moving frame
  std::size_t movingOrder = 0;
  std::optional<Relation> toNext;  ///< of the displacement from this row's to the next row's; none: the last
};

/// Rows in the order of board time. `movingBeta`: v/c of the moving frame on the board, below 1; axes by a
/// rotation-free boost, and both frames' origins are one event.
std::vector<EventRow> eventRows(std::span<const GameEvent> events, std::span<const std::string> pucks,
                                std::span<const std::string> flashes, const Vec3& movingBeta, double c_m_s);

}  // namespace carom
