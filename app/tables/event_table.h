#pragma once
// A table of a game's events: coordinates in the board's frame and in a moving one, the reception of each
// event's light, and the interval from each event to the next.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/game/game_event.h"
#include "engine/spacetime/simultaneity.h"

namespace carom {

/// The viewer's head at one drawn frame: the board event at which it received the frame's light, and its
/// proper time.
struct HeadAt {
  std::uint64_t frame = 0;
  Event event;
  double properTime_s = 0.0;
};

/// The reception of an event's light. Board time.
struct Reception {
  double t_s = 0.0;
  std::optional<double> properTime_s;  ///< the receiver's proper time
  std::optional<std::uint64_t> frame;  ///< the first drawn frame that can show the event
};

/// Returns the reception by an observer at rest at a place on the board: t = t_e + |r − r_e|/c.
Reception receptionAt(const Vec3& place_m, const Event& source, double c_m_s);

/// Returns the reception by a recorded head: between the last frame outside the event's future light cone and
/// the first inside. Between frames the head's motion is taken as straight and uniform. Returns nothing if
/// the head was inside the cone before the first frame, or is not yet inside after the last.
std::optional<Reception> receptionBy(std::span<const HeadAt> head, const Event& source, double c_m_s);

/// Returns the names of the pucks that took part, separated by commas, or the name of the flash.
std::string whoOf(const GameEvent& event, std::span<const std::string> pucks,
                  std::span<const std::string> flashes);

struct EventRow {
  GameEvent event;
  std::string who;        ///< names of the pucks or of the flash
  std::size_t order = 0;  ///< order on the board, from 1; simultaneous events share a number
  Event moving;           ///< in the moving frame
  std::size_t movingOrder = 0;
  /// Of the displacement from this row's event to the next row's; empty for the last.
  std::optional<Relation> toNext;
};

/// Returns rows in the order of board time. `movingBeta` is v/c of the moving frame on the board, below 1;
/// its axes follow from a rotation-free boost, and both frames' origins are one event.
std::vector<EventRow> eventRows(std::span<const GameEvent> events, std::span<const std::string> pucks,
                                std::span<const std::string> flashes, const Vec3& movingBeta, double c_m_s);

}  // namespace carom
