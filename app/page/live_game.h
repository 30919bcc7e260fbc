#pragma once
// The game that is played now, for pages that follow it: what they are told, some times a second. Frames
// never wait for it.
//
// A message is a row of numbers (64 bits each, the lowest byte first):
//   1 if all is told anew, else 0; the number of the game; the board time until which it is known;
//   the newest frame: its numbers and its states (app/page/page_rows.h);
//   all anew: the number of bodies, and of each the number of its knots and these; the number of events and
//     these;
//   otherwise the number of changes, and of each: from when the pucks are cut, the number of knots and these,
//     each with its body; from which number on events are void, the number of new ones and these.
//   An event: number, kind, cushion (from 1), t, x, y, z, the number of pucks and their bodies.

#include <cstdint>
#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/page/visit.h"
#include "cave/record/frame_state.h"
#include "engine/game/game_event.h"
#include "engine/spacetime/world_line.h"

namespace carom {

class LiveGame {
 public:
  /// Pages that join later are not told of legs that ended so long ago by the board's time.
  static constexpr double kPast_s = 120.0;

  /// Begins a game; between frames.
  void begin(std::uint64_t game, std::vector<WorldLine> atStart);
  /// Takes a frame as the first viewer sees it. In the frames' thread; a steady frame allocates nothing.
  void add(const FrameState& state);

  // In the thread of the server:
  /// Returns the news since the last call, or all if another game has begun; empty without a new frame.
  std::string more();
  /// Returns all that is known, as it was with the last `more`; empty before the first frame.
  std::string whole() const;

 private:
  struct Change {
    double cutFrom_s = std::numeric_limits<double>::infinity();
    std::uint64_t eventsKept = std::numeric_limits<std::uint64_t>::max();
    std::size_t knots = 0, events = 0;
  };
  /// What frames have brought and the server has not taken.
  struct News {
    std::vector<Change> changes;
    std::vector<BodyKnot> knots;
    std::vector<GameEvent> events;
    std::optional<VisitFrame> frame;
    double known_s = 0.0;
    std::size_t pucks = 0;

    void add(const FrameState& state);
    void add(const News& later);
    void clear();
  };
  struct Beginning {
    std::uint64_t game = 0;
    std::vector<WorldLine> lines;
  };
  void apply(const News& news);

  News staged_;  ///< of the frames' thread
  std::mutex mutex_;
  News waiting_;
  std::optional<Beginning> begins_;

  // Of the server's thread:
  News taken_;
  Beginning now_;
  std::vector<GameEvent> events_;
  std::optional<VisitFrame> frame_;
  double known_s_ = 0.0;
};

}  // namespace carom
